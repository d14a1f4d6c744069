// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/abstractdc/simulatorloops.h"
#include "families/abstractdc/simulatoroutbox.h"

namespace mb::abstractdc::simulation {

/// One drive: its power and its flash, what it hears, and the faults that come at their time.
class Unit {
public:
    using Notify = Shaft::Notify;

    Unit(CanLink &link, Clock &clock, const UnitOptions &options, Notify notify);

    [[nodiscard]] bool isOutputOn() const { return m_shaft.isOutputOn(); }
    [[nodiscard]] double speed();
    [[nodiscard]] double position();
    [[nodiscard]] double current();
    void setPowered(bool powered);
    bool disturb(std::string_view what, double value);

private:
    // Power and faults
    void start();
    void stop();
    void losePower();
    void scheduleFaults();
    void at(double seconds, std::function<void()> work);

    // What it hears
    void hear(const CanFrame &frame);
    void dispatch(const CanFrame &frame);
    void onSettings(const CanFrame &frame);
    void onSetPoint(const CanFrame &frame);
    void onLogRequest(const CanFrame &frame);
    [[nodiscard]] std::int32_t positionLog();

    Clock &m_clock;
    UnitOptions m_options;
    Notify m_notify;
    const Dialect &m_dialect;
    SettingsFlash m_flash;
    Shaft m_shaft;
    Loops m_loops;
    Outbox m_outbox;
    bool m_powered = false;
    std::uint64_t m_heard = 0;
    int m_positionLogs = 0;
    bool m_glitchNext = false;
    Timer m_restart;
    Timer m_busOff; ///< runs while nothing is heard and nothing sent
    std::list<Timer> m_timers;
    Subscription m_received;
};

} // namespace mb::abstractdc::simulation
