// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/listeners.h"
#include "async/result.h"
#include "model/stopscript.h"
#include "transport/link.h"

#include <memory>
#include <string>

namespace mb {

/// A guardian's watch over one device. Destroying it without release() makes the guardian stop the motor.
class GuardWatch {
public:
    enum class State {
        Called,   ///< asked for, not confirmed: nothing may move
        Standing, ///< the guardian has confirmed that it has descriptor and script
        Acted,    ///< it heard nothing for its time and sent the stop: motion is over
        Gone,     ///< it died, or never came
    };

    GuardWatch() = default;
    GuardWatch(const GuardWatch &) = delete;
    GuardWatch &operator=(const GuardWatch &) = delete;
    virtual ~GuardWatch() = default;

    [[nodiscard]] State state() const { return m_state; }
    /// Of Acted and Gone: one clause for people.
    [[nodiscard]] const std::string &reason() const { return m_reason; }
    [[nodiscard]] Listeners<> &changed() { return m_changed; }

    /// This process lives. The guardian acts 500 ms after it heard the last one.
    virtual void renew() = 0;
    /// The motor is known to stand: the guardian may forget it.
    virtual void release() = 0;

protected:
    void enter(State state, std::string reason = {})
    {
        m_state = state;
        m_reason = std::move(reason);
        m_changed.notify();
    }

private:
    State m_state = State::Called;
    std::string m_reason;
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
};

} // namespace mb
