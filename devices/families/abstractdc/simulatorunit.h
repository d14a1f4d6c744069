// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/abstractdc/simulatoroptions.h"
#include "families/abstractdc/simulatorregulator.h"
#include "transport/canlink.h"

#include <functional>
#include <list>
#include <memory>

namespace mb::abstractdc::simulation {

/// One drive: what it hears, its loop of 20.04 ms, its flash, and the motor.
class Unit {
public:
    using Notify = std::function<void(Instant, std::string_view, double)>;

    Unit(CanLink &link, Clock &clock, const UnitOptions &options, Notify notify);

    [[nodiscard]] bool isOutputOn() const { return m_pwm != 0; }
    [[nodiscard]] double speed();
    [[nodiscard]] double position();
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
    void enter(Loop mode, std::int32_t value);
    void reply(Log log, std::int32_t value);
    void transmit(CanFrame frame);
    [[nodiscard]] const SimulatedFault *strikes(std::string_view kind) const;

    // Its work
    void cycle();
    void regulate(std::int64_t milliseconds);
    void drive(int pwm);
    void advance();
    [[nodiscard]] std::int32_t encoder() const;
    [[nodiscard]] std::int32_t positionLog();
    [[nodiscard]] std::int64_t milliseconds() const;
    [[nodiscard]] Record &gainsOf(Loop loop) { return m_gains.at(static_cast<std::size_t>(loop) - 1); }

    CanLink &m_link;
    Clock &m_clock;
    UnitOptions m_options;
    Notify m_notify;
    const Dialect &m_dialect;
    SettingsFlash m_flash;
    MotorModel m_motor;
    Instant m_motorAt{};
    int m_awakeSteps = 0; ///< a standing motor is left alone once these are over

    bool m_powered = false;
    Instant m_startedAt{};
    std::int64_t m_origin = 0; ///< the encoder starts at 0 with the power
    Loop m_mode = Loop::None;
    std::int32_t m_target = 0;
    std::array<Record, 3> m_gains{};
    std::array<Pid, 3> m_pids{};
    std::int64_t m_output = 0; ///< "voltage": not cleared by mode none
    int m_pwm = 0;
    std::int32_t m_velocity = 0;
    std::int32_t m_velocityFrom = 0;
    std::int64_t m_velocityTime = 0;
    int m_temperature = 0;
    Averager m_current;
    bool m_overrunTold = false;

    std::uint64_t m_heard = 0;
    std::uint64_t m_sent = 0;
    int m_positionLogs = 0;
    bool m_glitchNext = false;
    Timer m_cycle;
    Timer m_restart;
    std::list<Timer> m_timers;
    std::list<Timer> m_replies;
    std::size_t m_pending = 0;
    Subscription m_received;
};

} // namespace mb::abstractdc::simulation
