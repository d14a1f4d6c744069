// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/simulatorprofile.h"

#include <algorithm>
#include <cmath>

namespace mb::supermodified::simulation {
namespace {

constexpr double kneeWidth = 2.0;

} // namespace

double believedRate(Dialect dialect)
{
    return dialect == Dialect::D3 ? loopsPerSecond : assumedLoopsPerSecond;
}

void Profile::hold(std::int64_t position)
{
    m_target = Target::Position;
    m_setPoint = position;
    m_exact = static_cast<double>(position);
    m_goal = m_exact;
    m_pace = 0.0;
}

void Profile::moveTo(std::int64_t position)
{
    m_target = Target::ProfiledPosition;
    m_goal = static_cast<double>(position);
    setKnee();
}

/// As if the move began at rest: D1 and D2 compute it once.
void Profile::setKnee()
{
    const double way = m_goal - m_exact;
    const auto square = static_cast<std::int32_t>(m_settings.velocity * m_settings.velocity); // README.md#overflow
    const double stopping = square / (2.0 * std::max<double>(m_settings.acceleration, 1.0));
    m_ahead = std::copysign(1.0, way);
    m_knee = m_goal - m_ahead * std::min(stopping, std::abs(way) / 2.0);
    m_braking = false;
}

void Profile::moveAt(std::int64_t velocity, bool profiled)
{
    m_target = profiled ? Target::ProfiledVelocity : Target::Velocity;
    m_goal = static_cast<double>(velocity);
    if (!profiled)
        m_pace = m_goal;
}

void Profile::approach(double target, double most)
{
    m_pace = target > m_pace ? std::min(target, m_pace + most) : std::max(target, m_pace - most);
}

void Profile::step()
{
    const double seconds = 1.0 / believedRate(m_dialect);
    const double most = m_settings.acceleration * seconds;
    switch (m_target) {
    case Target::Position: return;
    case Target::Velocity: break;
    case Target::ProfiledVelocity: approach(m_goal, most); break;
    case Target::ProfiledPosition: m_dialect == Dialect::D3 ? stepPosition(seconds) : stepByKnee(seconds); break;
    }
    m_exact += m_pace * seconds;
    m_setPoint = static_cast<std::int64_t>(std::llround(m_exact));
}

/// A trapezoid: as fast as allowed, and no faster than what can still be braked.
void Profile::stepPosition(double step)
{
    const double left = m_goal - m_exact;
    const double acceleration = std::max<double>(m_settings.acceleration, 1.0);
    if (std::abs(left) <= std::max(1.0, std::abs(m_pace) * step)) {
        arrive();
        return;
    }
    const double braking = std::sqrt(2.0 * acceleration * std::abs(left));
    approach(std::copysign(std::min<double>(m_settings.velocity, braking), left), acceleration * step);
}

/// D1, D2: braking begins only in a loop that finds the set-point at the knee. Fast ones step over it, and go on (README.md#passed-target).
void Profile::stepByKnee(double step)
{
    const double acceleration = std::max<double>(m_settings.acceleration, 1.0);
    const double left = (m_goal - m_exact) * m_ahead;
    m_braking = m_braking || std::abs(m_exact - m_knee) < kneeWidth;
    if (m_braking && (left <= 1.0 || m_pace == 0.0)) {
        arrive();
        return;
    }
    const double pace = m_braking ? std::sqrt(2.0 * acceleration * left) : static_cast<double>(m_settings.velocity);
    approach(std::copysign(std::min<double>(m_settings.velocity, pace), m_ahead), acceleration * step);
}

void Profile::arrive()
{
    m_exact = m_goal;
    m_pace = 0.0;
    m_target = Target::Position;
}

} // namespace mb::supermodified::simulation
