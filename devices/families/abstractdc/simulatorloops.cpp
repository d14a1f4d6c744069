// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/simulatorloops.h"

#include "async/seconds.h"

#include <algorithm>
#include <cmath>

namespace mb::abstractdc::simulation {
namespace {

using namespace std::chrono_literals;

constexpr int temperatureCycles = 2;

int toAdc(double counts)
{
    return std::clamp(static_cast<int>(std::lround(counts)), 0, adcMost);
}

} // namespace

Loops::Loops(Clock &clock, Shaft &shaft, Notify notify)
    : m_clock(clock)
    , m_shaft(shaft)
    , m_notify(std::move(notify))
    , m_cycle(clock)
{
}

void Loops::start(const std::array<Record, 3> &gains)
{
    m_startedAt = m_clock.now();
    m_mode = Loop::None;
    m_target = 0;
    m_gains = gains;
    m_pids = {};
    m_output = 0;
    m_velocity = 0;
    m_velocityFrom = 0;
    m_velocityTime = 0;
    m_current = {};
    m_overrunTold = false;
    m_cycle.startIn(m_period, [this] { cycle(); });
}

void Loops::stop()
{
    m_cycle.stop();
    m_shaft.drive(0);
}

void Loops::enter(Loop mode, std::int32_t value)
{
    const bool changed = mode != m_mode;
    m_mode = mode;
    m_target = value;
    if (mode == Loop::None) {
        m_shaft.drive(0);
    } else if (mode == Loop::Direct) {
        m_output = value;
        m_shaft.drive(pwmOf(value));
    } else if (changed) {
        m_pids.at(static_cast<std::size_t>(mode) - 1).restart(gainsOf(mode), milliseconds());
    }
}

bool Loops::disturb(std::string_view what, double value)
{
    if (what == "loop-period")
        m_period = fromSeconds(value);
    else if (what == "derivative-inverted")
        m_derivativeInverted = value != 0.0;
    else if (what == "temperature")
        m_case = value;
    else
        return false;
    return true;
}

std::int64_t Loops::milliseconds() const
{
    return (m_clock.now() - m_startedAt) / 1ms;
}

void Loops::cycle()
{
    m_cycle.startIn(m_period, [this] { cycle(); });
    m_shaft.advance();
    const MotorModel &motor = m_shaft.motor();
    m_current.add(toAdc(std::abs(motor.current()) * countsPerAmpere), gainsOf(Loop::Current).averaging);
    if (m_current.hasOverrun() && !m_overrunTold) {
        m_overrunTold = true;
        m_notify(m_clock.now(), "memory-overrun", 0.0);
    }
    if ((m_clock.now() - m_startedAt) / m_period % temperatureCycles == 0)
        m_temperature = toAdc(m_case.value_or(motor.housingTemperature()) * countsPerDegree);
    if (m_mode != Loop::None && m_mode != Loop::Direct)
        regulate(milliseconds());
}

void Loops::regulate(std::int64_t now)
{
    std::int64_t feedback = 0;
    if (m_mode == Loop::Velocity) { // README.md#stale-logs: since it was used last, however long ago
        const std::int32_t position = m_shaft.encoder();
        const std::int64_t elapsed = std::max<std::int64_t>(now - m_velocityTime, 1);
        m_velocity = static_cast<std::int32_t>((std::int64_t{position} - m_velocityFrom) * 1000 / elapsed);
        m_velocityFrom = position;
        m_velocityTime = now;
        feedback = m_velocity;
    } else if (m_mode == Loop::Current) {
        feedback = current();
    } else {
        feedback = m_shaft.encoder();
    }
    Record gains = gainsOf(m_mode);
    gains.d = m_derivativeInverted ? -gains.d : gains.d;
    m_output = m_pids.at(static_cast<std::size_t>(m_mode) - 1).step(gains, m_target - feedback, now);
    m_shaft.drive(pwmOf(m_output));
}

} // namespace mb::abstractdc::simulation
