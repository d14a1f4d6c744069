// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/device.h"
#include "model/motionguard.h"

#include <list>
#include <string>
#include <vector>

namespace mb {

/// Stops that are owed to devices nobody sees now: their link was closed before they were seen to stand, or another run of the
/// program left them. Sent when their line is open again, for DeviceStop::debtLimit; each ends when its device is found and has taken
/// it over, when a guardian has stopped it, or when its user has looked. Thread of the session.
class OwedStops {
public:
    /// Without a guard nothing is taken over from other runs.
    OwedStops(Clock &clock, MotionGuard *guard);

    [[nodiscard]] const std::list<OwedStop> &all() const { return m_owed; }
    /// A guardian has stopped one, or they were taken over from somebody who had the line when it was opened.
    [[nodiscard]] Listeners<> &changed() { return m_changed; }
    /// A link was opened: what guardians of programs that are gone owe on its line is ours now, and everything owed there is sent,
    /// before anything else.
    void pay(Link &link);
    /// The link of a device is closed while nobody has seen its motor stand: the stop stays.
    void add(Device &device);
    /// To a device that was found, or whose link is back: from now on its own stop follows it up.
    void passTo(Device &device);
    /// The device was seen to stand.
    void settle(const Device &device);
    /// The link to this line (linkIdentity) was closed or lost: what is owed there is the guardians' again.
    void leave(const std::string &line);
    /// The user has looked at the motors: nothing is owed any more.
    void dismiss();

private:
    /// False while somebody else has the line.
    bool takeOver(Link &link);
    void sendDue(Link &link) const;
    void lookAtBooks();
    void lookAgain();
    [[nodiscard]] bool isDue(const OwedStop &owed) const;

    Clock &m_clock;
    MotionGuard *m_guard;
    std::list<OwedStop> m_owed;
    std::vector<Link *> m_withOthers; ///< open, and somebody else's business when they were opened
    Timer m_look;
    Listeners<> m_changed;
};

} // namespace mb
