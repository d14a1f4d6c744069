// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "families/abstractdc/simulatoroptions.h"

#include <functional>
#include <string_view>

namespace mb::abstractdc::simulation {

/// The bridge, the motor and the encoder of one simulated drive. The motor turns up to now whenever somebody looks.
class Shaft {
public:
    /// Told when the output goes on or off, with the PWM.
    using Notify = std::function<void(Instant, std::string_view, double)>;

    Shaft(Clock &clock, const UnitOptions &options, Notify notify);

    /// PWM units, ±fullPwm; 0 brakes.
    void drive(int pwm);
    [[nodiscard]] bool isOutputOn() const { return m_pwm != 0; }
    /// The encoder starts at 0 here, as with the power.
    void zero();
    void advance();

    /// As they were when it was advanced last.
    [[nodiscard]] const MotorModel &motor() const { return m_motor; }
    [[nodiscard]] MotorModel &motor() { return m_motor; }
    /// Counts since zero().
    [[nodiscard]] std::int64_t counts() const { return m_motor.counts() - m_origin; }
    /// The same as the drive has it: a wrap of the 16-bit timer is counted as 65 535 (README.md#position).
    [[nodiscard]] std::int32_t encoder() const;
    bool disturb(std::string_view what, double value);

private:
    Clock &m_clock;
    Notify m_notify;
    MotorModel m_motor;
    Instant m_motorAt{};
    int m_awakeSteps = 0; ///< a standing motor is left alone once these are over
    std::int64_t m_origin = 0;
    int m_pwm = 0;
};

} // namespace mb::abstractdc::simulation
