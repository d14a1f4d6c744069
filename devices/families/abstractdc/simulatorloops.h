// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/abstractdc/simulatorregulator.h"
#include "families/abstractdc/simulatorshaft.h"

#include <optional>

namespace mb::abstractdc::simulation {

/// What one simulated drive does every 20.04 ms: it samples its converters and regulates, with the gains in force.
class Loops {
public:
    /// Told of a "memory-overrun".
    using Notify = Shaft::Notify;

    Loops(Clock &clock, Shaft &shaft, Notify notify);

    /// The power has come, with these gains from the flash.
    void start(const std::array<Record, 3> &gains);
    /// It has gone.
    void stop();
    void enter(Loop mode, std::int32_t value);
    /// A build of another hand: "loop-period" s, "derivative-inverted" where not 0; "temperature" °C, of its converter. False for what it
    /// does not know.
    [[nodiscard]] bool disturb(std::string_view what, double value);
    /// Of velocity, current or position; what is written holds at once.
    [[nodiscard]] Record &gainsOf(Loop loop) { return m_gains.at(static_cast<std::size_t>(loop) - 1); }

    /// What the logs tell: counts/s, stale outside the velocity mode (README.md#stale-logs);
    [[nodiscard]] std::int32_t velocity() const { return m_velocity; }
    /// of the converters;
    [[nodiscard]] int current() const { return m_current.mean(m_gains.at(1).averaging); }
    [[nodiscard]] int temperature() const { return m_temperature; }
    /// and "voltage": not cleared by mode none.
    [[nodiscard]] std::int64_t output() const { return m_output; }

private:
    void cycle();
    void regulate(std::int64_t milliseconds);
    [[nodiscard]] std::int64_t milliseconds() const;

    Clock &m_clock;
    Shaft &m_shaft;
    Notify m_notify;
    Instant m_startedAt{};
    Loop m_mode = Loop::None;
    std::int32_t m_target = 0;
    std::array<Record, 3> m_gains{};
    std::array<Pid, 3> m_pids{};
    std::int64_t m_output = 0;
    std::int32_t m_velocity = 0;
    std::int32_t m_velocityFrom = 0;
    std::int64_t m_velocityTime = 0;
    int m_temperature = 0;
    std::optional<double> m_case; ///< °C; nothing: that of the motor
    Averager m_current;
    bool m_overrunTold = false;
    Duration m_period = loopPeriod;
    bool m_derivativeInverted = false;
    Timer m_cycle;
};

} // namespace mb::abstractdc::simulation
