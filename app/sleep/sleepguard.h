// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/sleep/sleepinhibitor.h"
#include "async/clock.h"

#include <functional>

namespace mb {

class Session;

/// Keeps the computer awake while a motor of a session is driven, or still turns afterwards, and while a device is busy with its
/// firmware. Simulated devices end with this program, and may sleep. The thread of the session, which outlives this.
/// What else needs the computer, such as units that are served, is asked too.
class SleepGuard {
public:
    using Need = std::function<bool()>;
    SleepGuard(Session &session, Clock &clock, SleepInhibitor &inhibitor, Need need = {});
    SleepGuard(const SleepGuard &) = delete;
    SleepGuard &operator=(const SleepGuard &) = delete;
    ~SleepGuard();

private:
    void look();
    [[nodiscard]] bool isNeeded() const;

    Session &m_session;
    SleepInhibitor &m_inhibitor;
    Need m_need;
    Timer m_look;
    bool m_awake = false;
};

} // namespace mb
