// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/motormodel.h"

#include <cstdint>
#include <random>
#include <string_view>

namespace mb::dmc60c::simulation {

/// What is screwed to the controller: motor with load, encoder, supply, switches, and the sensors with their errors.
class Rig {
public:
    enum class Neutral { Coast, Brake };

    Rig(const MotorParameters &motor, double load, std::uint64_t seed);

    /// `duty` −1…1; at 0 the bridge is as `neutral` says. At most one pass of the loop.
    void step(double duty, Neutral neutral, double seconds);
    /// Time passes with nothing turning and no current.
    void rest(double seconds);
    [[nodiscard]] bool isAtRest() const;

    /// What the encoder counted, its faults included.
    [[nodiscard]] std::int64_t counts() const { return m_motor.counts(); }
    [[nodiscard]] std::int64_t countsPerTurn() const { return m_motor.parameters().countsPerTurn; }
    /// 12 bits around zero, 31.6 mA each, with noise; saturates at ±64.7 A.
    [[nodiscard]] std::int32_t adcCurrent();
    [[nodiscard]] double current() const { return m_motor.current(); }
    [[nodiscard]] double bus() const { return m_motor.busVoltage(); }
    [[nodiscard]] double measuredBus();
    [[nodiscard]] double caseTemperature() const { return m_case; }
    [[nodiscard]] double measuredTemperature() const;
    [[nodiscard]] double analogInput() const { return m_analog; }
    [[nodiscard]] bool isForwardSwitchClosed() const { return m_forwardClosed; }
    [[nodiscard]] bool isReverseSwitchClosed() const { return m_reverseClosed; }

    /// Of the shaft itself: counts/s and counts.
    [[nodiscard]] double speed() const { return m_motor.countSpeed(); }
    [[nodiscard]] double position() const { return m_motor.countPosition(); }

    void killEncoder() { m_motor.setEncoderDead(true); }
    void reverseEncoder() { m_motor.setEncoderReversed(true); }
    /// The disturbances of simulator.h that concern the rig.
    bool disturb(std::string_view what, double value);

private:
    void heat(double watts, double seconds);

    MotorModel m_motor;
    std::mt19937_64 m_random;
    std::normal_distribution<double> m_noise;
    bool m_disturbed = false; ///< and has not been stepped since
    bool m_forwardClosed = false;
    bool m_reverseClosed = false;
    double m_adcNoise = 2.0; ///< LSB
    double m_case = 25.0;
    double m_analog = 0.0;
};

} // namespace mb::dmc60c::simulation
