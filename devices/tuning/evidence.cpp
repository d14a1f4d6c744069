// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/evidence.h"

#include "experiment/envelope.h"
#include "model/family.h"
#include "model/loopparameters.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace mb::tuning {
namespace {

constexpr double atDutyLimit = 0.98;
constexpr double restTime = 0.2;    ///< s before the edge
constexpr double beganCounts = 3.0; ///< counts
constexpr double leastDuty = 0.005; ///< that is told from none
constexpr double slopeSpan = 0.02;  ///< s, either side of where a slope of positions is taken

double meanOfTrace(const Trace &trace)
{
    return std::accumulate(trace.y.begin(), trace.y.end(), 0.0) / static_cast<double>(trace.size());
}

/// When a trace that begins near 0 first reaches a level, between its samples.
std::optional<double> crossing(const Trace &trace, double level)
{
    for (std::size_t i = 1; i < trace.size(); ++i) {
        const double from = trace.y[i - 1];
        const double to = trace.y[i];
        if (std::abs(to) >= std::abs(level) && to * level > 0.0)
            return to == from ? trace.t[i]
                              : trace.t[i - 1] + (level - from) / (to - from) * (trace.t[i] - trace.t[i - 1]);
    }
    return std::nullopt;
}

Trace slopesOf(const Trace &positions)
{
    Trace slopes;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const double t = positions.t[i];
        const double from = std::max(positions.t.front(), t - slopeSpan);
        const double to = std::min(positions.t.back(), t + slopeSpan);
        if (to - from > 1.5 * slopeSpan)
            slopes.add(t, (valueAt(positions, to) - valueAt(positions, from)) / (to - from));
    }
    return slopes;
}

} // namespace

Evidence::Evidence(const Family &family, const Trial &trial)
    : m_family(family)
    , m_trial(trial)
    , m_hold(trial.holds.empty() ? 0.0 : trial.holds.front().to - trial.holds.front().from)
{
    std::transform(trial.gains.begin(), trial.gains.end(), std::back_inserter(m_roles),
        [&family](const auto &gain) { return roleOf(family, gain.first); });
}

const LoopScale *Evidence::scale() const
{
    return m_family.loop;
}

std::string Evidence::key(Role role) const
{
    const auto found = std::ranges::find(m_roles, role);
    return found == m_roles.end() ? std::string()
                                  : m_trial.gains[static_cast<std::size_t>(found - m_roles.begin())].first;
}

double Evidence::gain(Role role) const
{
    const auto found = std::ranges::find(m_roles, role);
    return found == m_roles.end()
        ? 0.0
        : m_trial.gains[static_cast<std::size_t>(found - m_roles.begin())].second.value_or(0.0);
}

std::optional<double> Evidence::stepsOf(Role role) const
{
    const auto index = findParameter(m_family.parameters, key(role));
    if (!index)
        return std::nullopt;
    return std::abs(gain(role)) * m_family.parameters[index->value].one;
}

Trace Evidence::held(std::string_view channel, double from, double to) const
{
    const Signal *const signal = m_trial.signal(channel);
    return signal ? signal->trace.part(from, to) : Trace();
}

std::optional<double> Evidence::meanOf(std::string_view channel, double from, double to) const
{
    const Trace trace = held(channel, from, to);
    return trace.isEmpty() ? std::nullopt : std::optional(meanOfTrace(trace));
}

std::optional<double> Evidence::dutyBefore() const
{
    return meanOf("duty", -restTime, -0.01);
}

std::optional<double> Evidence::feedForwardTimesGain() const
{
    const auto duty = dutyAtEnd();
    const auto velocity = meanOf("velocity", 0.75 * m_hold, m_hold);
    if (!scale() || gain(Role::FeedForward) == 0.0 || !duty || !velocity || std::abs(*duty) < leastDuty)
        return std::nullopt;
    const double perCount = gain(Role::FeedForward) * scale()->velocityTime / scale()->fullDuty; // duty for 1 count/s
    return perCount * *velocity / *duty;
}

std::optional<double> Evidence::countsLeft() const
{
    const auto end = meanOf(measuredOf(m_trial.mode), 0.75 * m_hold, m_hold);
    return end ? std::optional(m_trial.stimulus.to - *end) : std::nullopt;
}

std::optional<double> Evidence::leapOfOneCount() const
{
    if (!scale() || gain(Role::Derivative) == 0.0 || m_trial.mode != Mode::Position)
        return std::nullopt;
    const double divisor = scale()->divided ? gain(Role::Divisor) : 1.0;
    return divisor == 0.0 ? std::nullopt
                          : std::optional(std::abs(gain(Role::Derivative)) / divisor / scale()->fullDuty
                              * scale()->period / scale()->cycle);
}

std::optional<double> Evidence::rampTime() const
{
    if (!scale() || gain(Role::Ramp) <= 0.0)
        return std::nullopt;
    return scale()->period * scale()->fullDuty / gain(Role::Ramp);
}

double Evidence::timeAtLimit() const
{
    const Trace duty = held("duty", 0.0, m_hold);
    const double limit = atDutyLimit * m_trial.envelope.duty.value_or(1.0);
    double time = 0.0;
    for (std::size_t i = 0; i + 1 < duty.size(); ++i)
        time += std::abs(duty.y[i]) >= limit ? duty.t[i + 1] - duty.t[i] : 0.0;
    return time;
}

std::optional<double> Evidence::errorAfterLimit() const
{
    const Trace duty = held("duty", 0.0, m_hold);
    const Trace measured = held(measuredOf(m_trial.mode), 0.0, m_hold);
    const double limit = atDutyLimit * m_trial.envelope.duty.value_or(1.0);
    bool wasAt = false;
    for (std::size_t i = 0; i < duty.size() && !measured.isEmpty(); ++i) {
        const bool at = std::abs(duty.y[i]) >= limit;
        if (wasAt && !at) {
            const double error = std::abs(m_trial.stimulus.to - valueAt(measured, duty.t[i]));
            return m_trial.mode == Mode::Velocity && scale() ? error * scale()->velocityTime : error;
        }
        wasAt = at;
    }
    return std::nullopt;
}

std::optional<double> Evidence::demandOfStep() const
{
    if (!scale() || gain(Role::Proportional) == 0.0)
        return std::nullopt;
    const double divisor = scale()->divided ? gain(Role::Divisor) : 1.0;
    const double time = m_trial.mode == Mode::Velocity ? scale()->velocityTime : 1.0;
    const double step = std::abs(m_trial.stimulus.to - m_trial.stimulus.from) * time;
    return divisor == 0.0 ? std::nullopt
                          : std::optional(std::abs(gain(Role::Proportional)) * step / divisor / scale()->fullDuty);
}

std::optional<double> Evidence::velocityDelay() const
{
    const auto end = meanOf("velocity", 0.75 * m_hold, m_hold);
    const Trace positions = held("position", -0.05, m_hold);
    const Trace velocities = held("velocity", -0.05, m_hold);
    if (!end || positions.size() < 8 || velocities.size() < 8)
        return std::nullopt;
    const auto real = crossing(slopesOf(positions), *end / 2.0);
    const auto told = crossing(velocities, *end / 2.0);
    return real && told ? std::optional(*told - *real) : std::nullopt;
}

std::optional<double> Evidence::velocityHold() const
{
    const double moving = std::min(m_hold, 3.0 * m_trial.metrics.rise.value_or(m_hold / 3.0));
    const Trace velocities = held("velocity", 0.0, moving);
    std::vector<double> gaps;
    double since = velocities.isEmpty() ? 0.0 : velocities.t.front();
    for (std::size_t i = 1; i < velocities.size(); ++i) {
        if (velocities.y[i] == velocities.y[i - 1])
            continue;
        gaps.push_back(velocities.t[i] - since);
        since = velocities.t[i];
    }
    const double hold = median(gaps);
    return gaps.size() >= 3 && hold > 1.8 * samplePeriod(velocities) ? std::optional(hold) : std::nullopt;
}

std::optional<Evidence::Start> Evidence::startOfMotion() const
{
    const Trace positions = held("position", 0.0, m_hold);
    const Trace duty = held("duty", 0.0, m_hold);
    if (positions.isEmpty() || duty.isEmpty())
        return std::nullopt;
    for (std::size_t i = 1; i < positions.size(); ++i) {
        if (std::abs(positions.y[i] - positions.y.front()) < beganCounts)
            continue;
        const double then = valueAt(duty, positions.t[i]);
        return std::abs(then) >= leastDuty ? std::optional(Start{positions.t[i], then}) : std::nullopt;
    }
    return std::nullopt;
}

std::optional<Evidence::Swing> Evidence::swingAtEnd() const
{
    const Trace positions = held("position", m_hold / 2.0, m_hold);
    const Trace duty = held("duty", m_hold / 2.0, m_hold);
    if (positions.isEmpty() || duty.isEmpty())
        return std::nullopt;
    const auto [low, high] = std::minmax_element(positions.y.begin(), positions.y.end());
    Swing swing{*high - *low, 0};
    double last = 0.0;
    for (const double value : duty.y) {
        if (std::abs(value) < leastDuty)
            continue;
        swing.turns += last * value < 0.0 ? 1 : 0;
        last = value;
    }
    return swing;
}

} // namespace mb::tuning
