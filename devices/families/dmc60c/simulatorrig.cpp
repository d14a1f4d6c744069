// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/simulatorrig.h"

#include <algorithm>
#include <cmath>

namespace mb::dmc60c::simulation {
namespace {

constexpr double amperesPerLsb = 2070.0 / 65536.0; ///< as calibrated at the factory
constexpr int adcLow = -2048;
constexpr int adcHigh = 2047;
constexpr double busNoise = 0.02; ///< V
constexpr double temperatureStep = 0.5;
constexpr double ambient = 25.0;
constexpr double bridgeResistance = 0.005; ///< Ω, what heats the case
constexpr double caseResistance = 1.5;     ///< K/W
constexpr double caseSeconds = 60.0;
constexpr double leastCurrent = 1e-3; ///< A; below it a standing motor is left alone

} // namespace

Rig::Rig(const MotorParameters &motor, double load, std::uint64_t seed)
    : m_motor(motor, load)
    , m_random(seed)
{
}

void Rig::step(double duty, Neutral neutral, double seconds)
{
    const Bridge bridge = neutral == Neutral::Brake ? Bridge::Brake : Bridge::Coast;
    m_motor.step(duty, duty != 0.0 ? Bridge::Drive : bridge, seconds);
    m_disturbed = false;
    heat(current() * current() * bridgeResistance, seconds);
}

bool Rig::isAtRest() const
{
    return !m_disturbed && m_motor.isStuck() && std::abs(m_motor.current()) < leastCurrent;
}

void Rig::heat(double watts, double seconds)
{
    const double settled = ambient + watts * caseResistance;
    m_case = settled + (m_case - settled) * std::exp(-seconds / caseSeconds);
}

void Rig::rest(double seconds)
{
    heat(0.0, seconds);
    if (m_motor.temperature() > ambient + 1.0)
        m_motor.step(0.0, Bridge::Coast, seconds);
}

std::int32_t Rig::adcCurrent()
{
    const double noisy = m_motor.current() / amperesPerLsb + m_adcNoise * m_noise(m_random);
    return static_cast<std::int32_t>(std::lround(std::clamp<double>(noisy, adcLow, adcHigh)));
}

double Rig::measuredBus()
{
    return bus() + busNoise * m_noise(m_random);
}

double Rig::measuredTemperature() const
{
    return std::round(m_case / temperatureStep) * temperatureStep;
}

bool Rig::disturb(std::string_view what, double value)
{
    if (what == "forward-limit")
        m_forwardClosed = value != 0.0;
    else if (what == "reverse-limit")
        m_reverseClosed = value != 0.0;
    else if (what == "analog-input")
        m_analog = value;
    else if (what == "temperature")
        m_case = value;
    else if (what == "current-noise")
        m_adcNoise = value;
    else {
        m_disturbed = true;
        return m_motor.disturb(what, value);
    }
    return true;
}

} // namespace mb::dmc60c::simulation
