// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/sleep/sleepinhibitor.h"
#include "async/clock.h"
#include "async/noncopyable.h"

#include <functional>

namespace mb {

class Session;

/// Keeps the computer awake while a motor of a session is driven, or still turns afterwards, and while a device is busy with its
/// firmware. Simulated devices end with this program, and may sleep. `also` is asked for work of another kind that must not be
/// interrupted, such as the service of a unit. The thread of the session, which outlives this.
class SleepGuard : NonCopyable {
public:
    SleepGuard(Session &session, Clock &clock, SleepInhibitor &inhibitor, std::function<bool()> also = {});
    ~SleepGuard();

private:
    void look();
    [[nodiscard]] bool isNeeded() const;

    Session &m_session;
    SleepInhibitor &m_inhibitor;
    std::function<bool()> m_also;
    Timer m_look;
    bool m_awake = false;
};

} // namespace mb
