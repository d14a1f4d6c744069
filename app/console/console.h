// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/failure.h"
#include "app/console/output.h"
#include "app/guardian/client/guardianclient.h"
#include "model/session.h"

#include <functional>

namespace mb::console {

struct Options {
    std::string_view verb; ///< one of the table; empty: what was typed is not understood
    bool json = false;
    bool quiet = false; ///< no progress and no notes
    Patience patience;  ///< --timeout and --retries: of every question, and of finding a device
};

/// What a verb works with. One thread, one event loop.
class Console {
public:
    Console(Clock &clock, std::span<const Family *const> families, Options options);

    [[nodiscard]] Clock &clock() { return m_session.clock(); }
    [[nodiscard]] Session &session() { return m_session; }
    [[nodiscard]] std::span<const Family *const> families() const { return m_session.families(); }
    [[nodiscard]] const Options &options() const { return m_options; }
    [[nodiscard]] bool json() const { return m_options.json; }
    [[nodiscard]] Output &out() { return m_output; }
    /// A line for people on standard error; not with --quiet.
    void note(std::string_view text) const;
    /// Tells an error that does not end the verb by itself, and yields the exit status that it asks for.
    [[nodiscard]] int fails(const Error &error) const;
    /// The device of the verb is found: what is sent from now on is meant for it.
    void begin() { m_sentBefore = sent(); }
    /// Whatever is asked meanwhile, the device is told nothing until begin(): what is refused till then is wrong usage.
    void onlyAsk() { m_sentBefore.reset(); }
    /// Of the session of a stage that ends: it was sent by this verb, too.
    void countSent(const Session &session) { m_sentOnStages += sentIn(session); }
    /// A unit is between two steps that belong together: the computer must not sleep.
    void stayAwake(bool must) { m_staysAwake = must; }
    [[nodiscard]] bool staysAwake() const { return m_staysAwake; }
    /// Something was, so that a refusal is no wrong usage any more.
    [[nodiscard]] bool hasSent() const { return m_sentBefore && sent() > *m_sentBefore; }

    /// A signal, or the reader of standard output has gone. A verb that listens ends by itself; the others are cut.
    [[nodiscard]] Listeners<> &interrupted() { return m_interruptions; }
    [[nodiscard]] bool isInterrupted() const { return m_isInterrupted; }
    void interrupt();

private:
    [[nodiscard]] static std::uint64_t sentIn(const Session &session);
    [[nodiscard]] std::uint64_t sent() const { return m_sentOnStages + sentIn(m_session); }

    Options m_options;
    Output m_output;
    GuardianClient m_guardian;
    Session m_session;
    Subscription m_remarked;
    Subscription m_memoryTrouble;
    Subscription m_profileTrouble;
    Listeners<> m_interruptions;
    bool m_isInterrupted = false;
    bool m_staysAwake = false;
    std::uint64_t m_sentOnStages = 0;
    std::optional<std::uint64_t> m_sentBefore; ///< in finding the device
};

/// Tells an error as --json or its absence asks; the last words of the program.
void tell(const Error &error, int status, const Options &options);

/// A verb with its arguments, ready to run. Checks everything before it sends anything; yields the exit status.
using Job = std::function<Task<int>(Console &)>;

/// Without the rounding of a division: exact to the last digit that a double has.
[[nodiscard]] double secondsOf(Duration time);

/// Time since 1970, or since its construction on a simulated link, whose time is its own.
class TimeOrigin {
public:
    TimeOrigin(const Clock &clock, const LinkAddress &link);
    [[nodiscard]] Duration of(Instant time) const
    {
        return time.time_since_epoch() + m_offset + (m_awake ? m_awake->slept() - m_slept : Duration{});
    }
    [[nodiscard]] double seconds(Instant time) const { return secondsOf(of(time)); }

private:
    Duration m_offset;
    const Clock *m_awake; ///< stands still while the computer sleeps; nullptr: nobody asks for the time of day
    Duration m_slept;
};

} // namespace mb::console
