// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/simulatoraxis.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mb::quadquad2drv::simulation {
namespace {

constexpr double ratedSpeed = 50'000.0; ///< transitions/s
constexpr double edgeSeconds = 0.64e-6;
constexpr std::size_t mostPoints = 4096;

/// Moves `value` towards `target` by `most` at the most.
double approach(double value, double target, double most)
{
    return value + std::clamp(target - value, -most, most);
}

} // namespace

void SpeedWindow::configure(int length, int timeBits)
{
    m_edges = 4LL * length;
    m_longest = std::ldexp(edgeSeconds, timeBits);
}

void SpeedWindow::add(double seconds, std::int64_t counts)
{
    m_points.push_back({seconds, counts});
    const auto complete = [this](const Point &since) {
        const Point &now = m_points.back();
        return std::abs(now.counts - since.counts) >= m_edges || now.seconds - since.seconds >= m_longest;
    };
    while (m_points.size() > 2 && (complete(m_points[1]) || m_points.size() > mostPoints))
        m_points.pop_front();
    const double span = m_points.back().seconds - m_points.front().seconds;
    m_speed = span > 0.0 ? static_cast<double>(m_points.back().counts - m_points.front().counts) / span : 0.0;
}

Axis::Axis(const MotorParameters &motor, double load)
    : m_motor(motor, load)
{
    reset();
}

void Axis::reset()
{
    settings = AxisSettings{};
    settings.velocityLimit = static_cast<std::uint32_t>(fastest * limitOne);
    m_window.configure(31, 20);
    m_window.clear();
    m_origin = m_motor.counts();
    m_lastRead = 0;
    m_status = 0;
    m_wasActive = false;
    m_reference = m_referenceVelocity = m_integral = m_lastError = m_output = 0.0;
}

void Axis::setMode(ControlMode mode)
{
    if (mode != settings.mode) {
        m_integral = 0.0;
        m_lastError = 0.0;
        m_reference = counter();
        m_referenceVelocity = mode == ControlMode::Velocity ? m_window.speed() : 0.0;
    }
    settings.mode = mode;
}

void Axis::setCounter(std::int32_t value)
{
    const std::int32_t before = counter();
    m_origin = m_motor.counts() - value;
    m_reference += static_cast<double>(value) - before;
    m_lastRead = value;
    m_window.clear();
}

double Axis::velocityLimit() const
{
    const double limit = settings.velocityLimit / limitOne;
    return settings.rampVelocity > 0.0 ? std::min(limit, settings.rampVelocity) : limit;
}

double Axis::accelerationLimit() const
{
    const double limit = settings.accelerationLimit / limitOne;
    if (settings.rampAcceleration <= 0.0)
        return limit;
    return limit > 0.0 ? std::min(limit, settings.rampAcceleration) : settings.rampAcceleration;
}

void Axis::advanceReference()
{
    const double acceleration = accelerationLimit();
    const double most = acceleration > 0.0 ? acceleration * loopSeconds : 1e12;
    if (settings.mode == ControlMode::Velocity) {
        const double limit = velocityLimit();
        m_referenceVelocity = approach(m_referenceVelocity, std::clamp(settings.velocityTarget, -limit, limit), most);
        return;
    }
    const double distance = settings.positionTarget - m_reference;
    double wanted = distance / loopSeconds;
    if (acceleration > 0.0)
        wanted
            = std::copysign(std::min(std::abs(wanted), std::sqrt(2.0 * acceleration * std::abs(distance))), distance);
    wanted = std::clamp(wanted, -velocityLimit(), velocityLimit());
    m_referenceVelocity = approach(m_referenceVelocity, wanted, most);
    m_reference += m_referenceVelocity * loopSeconds;
}

double Axis::positionLoop()
{
    const auto &[p, i, d, windup] = settings.positionGains;
    const double error = m_reference - counter();
    m_integral = std::clamp(m_integral + m_scale * gain::positionI * i * error, -1.0 * windup, 1.0 * windup);
    const double out
        = m_scale * gain::positionP * p * error + m_integral + m_scale * gain::positionD * d * (error - m_lastError);
    m_lastError = error;
    return out;
}

double Axis::velocityLoop()
{
    const auto &[p, i, d] = settings.velocityGains;
    const double error = m_referenceVelocity - m_window.speed();
    m_integral = std::clamp(
        m_integral + m_scale * gain::velocityI * i * error, -1.0 * settings.powerLimit, 1.0 * settings.powerLimit);
    const double out
        = m_scale * gain::velocityP * p * error + m_integral + m_scale * gain::velocityD * d * (error - m_lastError);
    m_lastError = error;
    return out;
}

void Axis::step(double seconds)
{
    m_window.add(seconds, m_motor.counts());
    switch (settings.mode) {
    case ControlMode::Off: m_output = 0.0; break;
    case ControlMode::Power: m_output = settings.power; break;
    case ControlMode::Position:
        advanceReference();
        m_output = positionLoop();
        break;
    case ControlMode::Velocity:
        advanceReference();
        m_output = velocityLoop();
        break;
    }
    m_output = std::clamp(m_output, -1.0 * settings.powerLimit, 1.0 * settings.powerLimit);
    const bool driven = settings.mode != ControlMode::Off;
    m_motor.step(m_output / fullPower, driven ? Bridge::Drive : Bridge::Coast, loopSeconds);
    watchInput();
}

void Axis::watchInput()
{
    const auto mode = static_cast<InputMode>(settings.input & 0x03U);
    const bool activeLow = ((settings.input & 0x08U) != 0) == m_libraryPolarity; // README.md#inputs: both readings
    const bool active = mode != InputMode::Disabled && m_inputHigh != activeLow;
    if (active)
        m_status |= status::inputWasActive;
    if (active != m_wasActive && (active || mode == InputMode::Edge))
        trigger(active || mode == InputMode::Index);
    m_wasActive = active;
}

void Axis::trigger(bool positive)
{
    m_status |= positive ? status::positiveEdge : status::negativeEdge;
    const unsigned edge = (settings.input >> 4U) & 0x03U;
    const bool sets = (edge & (m_libraryPolarity ? 1U : 2U)) != 0;
    const bool wantsPositive = (edge & (m_libraryPolarity ? 2U : 1U)) == 0;
    if (sets && positive == wantsPositive)
        setCounter(settings.inputPosition);
}

std::int32_t Axis::velocity() const
{
    return static_cast<std::int32_t>(std::lround(m_window.speed() / resolution) * std::lround(resolution));
}

std::uint8_t Axis::takeStatus()
{
    std::uint8_t now = m_status;
    if (m_wasActive)
        now |= status::inputActive;
    if (std::abs(m_window.speed()) > ratedSpeed)
        now |= status::overspeed;
    m_status = 0;
    return now;
}

std::int32_t Axis::takeChange()
{
    const std::int32_t now = counter();
    return now - std::exchange(m_lastRead, now);
}

} // namespace mb::quadquad2drv::simulation
