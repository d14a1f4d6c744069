// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/console.h"
#include "async/event.h"

namespace mb::console {

/// What a verb that streams waits for: its time is up, a signal came, the link was lost or a recording is over, whichever
/// is first.
class Ending {
public:
    enum class Cause { None, Time, Interrupted, LinkLost };

    explicit Ending(Console &console);
    /// A lost link, or the end of a recording, ends it.
    void watch(Link &link);
    /// As long as `mayReturn` says so of the lost link, its loss does not end the verb.
    void watchPatiently(Link &link, std::function<bool(const Link &)> mayReturn);
    void after(std::optional<Duration> time);

    /// Lets recordings play.
    [[nodiscard]] Event::Wait wait();
    [[nodiscard]] Cause cause() const { return m_cause; }
    /// What a lost link ends the verb with.
    [[nodiscard]] const std::string &reason() const { return m_reason; }

private:
    void end(Cause cause);

    Timer m_time;
    Timer m_posted; ///< the waiting task goes on from the clock, never from inside a link's notification
    Event m_event;
    Cause m_cause = Cause::None;
    std::string m_reason;
    Subscription m_interrupted;
    std::vector<Subscription> m_links;
    std::vector<ReplayLink *> m_recordings;
};

} // namespace mb::console
