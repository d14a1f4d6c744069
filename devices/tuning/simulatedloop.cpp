// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/simulatedloop.h"

#include <algorithm>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr double patienceForCounts = 0.671; ///< s, that a window of counts waits for them
constexpr double breakawayShare = 1.2;      ///< of the friction while it moves

double wholeSteps(double value, double step)
{
    return step > 0.0 ? std::trunc(value / step) * step : value;
}

std::size_t passesOf(double seconds, double period)
{
    return static_cast<std::size_t>(std::lround(std::max(seconds, 0.0) / period));
}

double dutyAt(const PlantModel &plant, const ContinuousGains &gains, double value)
{
    if (value == 0.0)
        return 0.0;
    return value / plant.gain + (value > 0.0 ? plant.friction : -plant.friction) - gains.f * value;
}

} // namespace

SimulatedLoop::SimulatedLoop(
    Mode loop, const PlantModel &plant, const ContinuousGains &gains, const LoopShape &shape, double from)
    : m_integrates(loop == Mode::Position)
    , m_windowed(loop == Mode::Velocity && shape.window > 0.0)
    , m_plant(plant)
    , m_gains(gains)
    , m_shape(shape)
    , m_kept(std::exp(-shape.period / plant.tau))
    , m_speed(m_integrates ? 0.0 : from)
    , m_place(m_integrates ? from : 0.0)
    , m_measured(from)
    , m_integral(m_integrates ? 0.0 : dutyAt(plant, gains, from))
{
    if (m_windowed)
        m_span = std::max<std::size_t>(
            1, passesOf(shape.windowCounts > 0.0 ? patienceForCounts : shape.window, shape.period));
    // an output that is held from pass to pass is half of one late already
    m_lag = passesOf(plant.delay - (m_windowed ? 0.5 * shape.window : 0.0) - 0.5 * shape.period, shape.period);
    const double before = static_cast<double>(m_lag + m_span);
    for (std::size_t i = 0; i < m_lag + m_span; ++i) {
        const double ago = before - static_cast<double>(i);
        m_late.push_back(m_windowed ? -from * ago * shape.period : from);
    }
}

double SimulatedLoop::measure()
{
    if (!m_windowed) {
        m_late.push_back(value());
        const double seen = m_late.front();
        m_late.pop_front();
        return m_integrates && m_shape.isCounted ? std::floor(seen) : seen;
    }
    m_late.push_back(m_shape.isCounted ? std::floor(m_place) : m_place);
    if (m_shape.windowCounts > 0.0)
        return measureByCounts();
    const double seen = (m_late[m_span] - m_late.front()) / (static_cast<double>(m_span) * m_shape.period);
    m_late.pop_front();
    return seen;
}

/// Over the shortest time in which it went so far.
double SimulatedLoop::measureByCounts()
{
    std::size_t newest = m_late.size() - 1 - m_lag;
    const auto isLong
        = [&] { return std::abs(m_late[newest] - m_late[1]) >= m_shape.windowCounts || newest - 1 >= m_span; };
    for (; newest > 1 && isLong(); --newest)
        m_late.pop_front();
    return (m_late[newest] - m_late.front()) / (static_cast<double>(newest) * m_shape.period);
}

double SimulatedLoop::output(double target, double measured)
{
    const double error = target - measured;
    const double slope = (error - m_lastError) / m_shape.period;
    m_lastError = error;
    if (m_shape.goodEnough > 0.0 && std::abs(error) < m_shape.goodEnough) {
        m_integral = 0.0;
        return m_gains.f * target;
    }
    m_integral += wholeSteps(m_gains.i * error * m_shape.period, m_shape.integralStep);
    if (m_shape.integralMost > 0.0)
        m_integral = std::clamp(m_integral, -m_shape.integralMost, m_shape.integralMost);
    const double now = wholeSteps(m_gains.p * error + m_gains.d * slope, m_shape.outputStep);
    double duty = now + m_gains.f * target + m_integral;
    if (duty != 0.0 && std::abs(duty) < m_shape.leastOutput)
        duty = std::copysign(m_shape.leastOutput, duty);
    return std::clamp(duty, -m_shape.mostDuty, m_shape.mostDuty);
}

/// Exact for constant duty.
void SimulatedLoop::turn(double duty)
{
    const double push = std::abs(duty);
    const bool stuck = m_speed == 0.0 && push <= breakawayShare * m_plant.friction;
    const double sign = m_speed != 0.0 ? (m_speed > 0.0 ? 1.0 : -1.0) : (duty > 0.0 ? 1.0 : -1.0);
    const double ends = stuck ? 0.0 : m_plant.gain * (duty - sign * m_plant.friction);
    const double next = ends + (m_speed - ends) * m_kept;
    m_place += ends * m_shape.period + (m_speed - ends) * m_plant.tau * (1.0 - m_kept);
    m_speed = m_speed * next < 0.0 && push <= m_plant.friction ? 0.0 : next;
}

double SimulatedLoop::pass(double target)
{
    m_measured = measure();
    const double duty = output(target, m_measured);
    turn(duty);
    return duty;
}

} // namespace mb::tuning
