// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "async/listeners.h"
#include "async/noncopyable.h"
#include "async/result.h"
#include "model/stopscript.h"
#include "transport/link.h"

#include <memory>
#include <string>
#include <vector>

namespace mb {

/// A stop that a line owes to a device which nobody has seen stand.
struct OwedStop {
    std::string line;   ///< linkIdentity()
    std::string device; ///< selector, as of when it was driven
    StopScript script;
    Instant since{};
};

/// A guardian's watch over one device. Destroying it without release() makes the guardian stop the motor.
class GuardWatch : NonCopyable {
public:
    enum class State {
        Called,   ///< asked for, not confirmed: nothing may move
        Standing, ///< the guardian has confirmed that it has descriptor and script
        Acted,    ///< it heard nothing for its time and sent the stop: motion is over
        Gone,     ///< it died, or never came
    };

    virtual ~GuardWatch() = default;

    [[nodiscard]] State state() const { return m_state; }
    /// Of Acted and Gone: one clause for people.
    [[nodiscard]] const Message &reason() const { return m_reason; }
    [[nodiscard]] Listeners<> &changed() { return m_changed; }

    /// This process lives. The guardian acts 500 ms after it heard the last one.
    virtual void renew() = 0;
    /// The motor is known to stand: the guardian may forget it.
    virtual void release() = 0;

protected:
    void enter(State state, Message reason = {})
    {
        m_state = state;
        m_reason = std::move(reason);
        m_changed.notify();
    }

private:
    State m_state = State::Called;
    Message m_reason;
    Listeners<> m_changed;
};

/// Gets guardians. Engine thread; outlives the session that uses it. `app/guardian/client` starts the real one.
class MotionGuard {
public:
    virtual ~MotionGuard() = default;
    /// Asks for a guardian that can send on this open link; its outlet is inheritable. Returns at once, the watch changes when
    /// the guardian has confirmed. Fails with Unsafe and the remedy when none can be started. `name` is for its log line.
    [[nodiscard]] virtual Result<std::unique_ptr<GuardWatch>> watch(
        Link &link, const StopScript &script, const std::string &name)
        = 0;
    /// Before the first frame on a link that was just opened: guardians leave what is owed on its line to this program until it
    /// leaves the line. False while somebody else has it: ask again.
    [[nodiscard]] virtual bool own(Link & /*link*/) { return true; }
    /// The link was closed or lost: what is owed there is the guardians' again, under whatever name the line comes back.
    virtual void leave(const std::string & /*line*/) { }
    /// The book of every line that own() was asked for: what this program and guardians, of programs that are gone too, owe there or
    /// have given up; not once it was confirmed or settled.
    [[nodiscard]] virtual std::vector<OwedStop> owed(Instant /*now*/) const { return {}; }
    /// Into that book. False where there is none, or it cannot be written.
    virtual bool owe(const OwedStop & /*stop*/, Instant /*now*/) { return false; }
    /// A device was seen to stand, or is not to be told any more: its stop is not owed on this line, whoever has it.
    virtual void settle(const std::string & /*line*/, const std::string & /*device*/) { }
    /// What became of the stop that a guardian sent.
    enum class Verdict {
        Confirmed, ///< the device answered
        Sent,      ///< it went out, and nothing on this link answers
        Failed,    ///< it could not be sent, or an answer did not come
    };
    /// What became of a watch that was given up without release(): name of the device, and of its stop.
    [[nodiscard]] Listeners<const std::string &, Verdict> &acted() { return m_acted; }

protected:
    void tellActed(const std::string &name, Verdict verdict) { m_acted.notify(name, verdict); }

private:
    Listeners<const std::string &, Verdict> m_acted;
};

} // namespace mb
