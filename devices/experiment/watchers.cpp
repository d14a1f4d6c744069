// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/watchers.h"

#include "experiment/seconds.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mb::tuning {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t slopePoints = 3;
constexpr Duration shortestSpan = 1500us; ///< of a slope: samples may come at once
constexpr double leastMove = 3.0;         ///< counts
constexpr double clearlyMoved = 10.0;     ///< counts
constexpr double surelyMoves = 3.0;       ///< times what friction takes
constexpr double runawayMargin = 1.2;
constexpr double realPeak = 0.05; ///< of the swing
constexpr double growth = 1.05;   ///< of a peak over the one before on the same side
constexpr double asLarge = 0.95;  ///< the same, where the duty lets it grow no more
constexpr double broad = 0.3;     ///< of the swing, from one turn to the next
constexpr double undamped = 0.85; ///< of the way from one turn to the next, over the one before
constexpr double atLimit = 0.95;  ///< of the duty limit
constexpr double strong = 0.5;    ///< of the duty limit
constexpr std::uint64_t enoughSamples = 40;

} // namespace

double SlopeWatch::add(Instant time, double counts)
{
    m_points.emplace_back(time, counts);
    while (m_points.size() > slopePoints && time - m_points[1].first >= shortestSpan)
        m_points.pop_front();
    const Duration span = m_points.back().first - m_points.front().first;
    if (span >= shortestSpan)
        m_speed = (m_points.back().second - m_points.front().second) / inSeconds(span);
    return m_speed;
}

void OverloadWatch::add(Instant time, double amperes, double limit)
{
    if (m_last)
        m_seconds += m_amperes * m_amperes * inSeconds(time - *m_last) / (limit * limit);
    m_amperes = amperes;
    m_last = time;
    if (std::abs(amperes) <= limit) {
        m_since.reset();
        m_above = Duration::zero();
        return;
    }
    m_since = m_since.value_or(time);
    m_above = time - *m_since;
}

void OverloadWatch::pause()
{
    m_last.reset();
    m_since.reset();
    m_above = Duration::zero();
}

void MotionWatch::pushAnew(Instant time)
{
    m_pushedAt = time;
    m_pushedFrom = m_movedTo = m_counts.value_or(0.0);
    m_entrySpeed = std::abs(m_speed);
    m_movedAt = time;
    m_wrong = 0;
    m_stuck = Duration::zero();
}

void MotionWatch::duty(Instant time, double fraction, double breakaway)
{
    const bool same = m_pushedAt && (fraction < 0.0) == (m_duty < 0.0);
    m_duty = fraction;
    if (std::abs(fraction) < breakaway) {
        m_pushedAt.reset();
        m_wrong = 0;
    } else if (!same) {
        pushAnew(time);
    }
    const bool surely = std::abs(fraction) >= surelyMoves * breakaway;
    if (surely && !m_surely)
        m_movedAt = time;
    m_surely = surely;
    if (!surely)
        m_stuck = Duration::zero();
}

void MotionWatch::position(Instant time, double counts)
{
    const bool first = !m_counts;
    const double span = inSeconds(time - m_lastAt);
    const double step = counts - m_counts.value_or(counts);
    const double before = std::abs(m_speed);
    m_speed = span > 0.0 ? step / span : 0.0;
    m_counts = counts;
    m_lastAt = time;
    if (!m_pushedAt)
        return;
    if (first)
        pushAnew(*m_pushedAt);
    if (std::abs(counts - m_movedTo) >= leastMove) {
        m_movedTo = counts;
        m_movedAt = time;
    }
    m_stuck = m_surely ? time - m_movedAt : Duration::zero();
    const double sign = m_duty < 0.0 ? -1.0 : 1.0;
    const bool away = m_speed * sign < 0.0 && (counts - m_pushedFrom) * sign < -clearlyMoved;
    if (away && std::abs(m_speed) > runawayMargin * m_entrySpeed)
        m_wrong += std::abs(m_speed) >= before ? 1 : 0; // what pulls at it is being braked
    else if (step != 0.0)
        m_wrong = 0;
}

void OscillationWatch::target(double target)
{
    if (m_target && target != *m_target) {
        const bool rising = target > *m_target;
        m_turned = m_turned || rising != m_isRising;
        m_isRising = rising;
        m_lasting = m_sustained = 0;
    }
    m_target = target;
}

/// Wherever it swings: friction may hold it beside its target.
void OscillationWatch::turn(double error, double swing, double real)
{
    const bool further = m_isGoing ? error > m_farthest : error < m_farthest;
    if (!further && std::abs(error - m_farthest) > real) {
        const double stroke = std::abs(m_farthest - std::exchange(m_turnedAt, m_farthest));
        const double least = std::max(broad * swing, undamped * std::exchange(m_stroke, stroke));
        m_sustained = stroke >= least ? m_sustained + 1 : 0;
        m_isGoing = !m_isGoing;
        ++m_lasting;
        m_farthest = error;
    } else if (further) {
        m_farthest = error;
    }
}

void OscillationWatch::error(double error, double swing, double noise)
{
    turn(error, swing, std::max({realPeak * swing, noise, leastMove}));
    const bool positive = error > 0.0;
    if (error == 0.0 || positive == m_isPositive) {
        m_peak = std::max(m_peak, std::abs(error));
        return;
    }
    m_isPositive = positive;
    const double least = std::max(m_turned ? swing : realPeak * swing, noise);
    double &last = positive ? m_lastNegative : m_lastPositive; // of the sign that ends here
    const bool counts = m_peak > least && m_peak > (m_atLimit || m_wasAtLimit ? asLarge : growth) * last;
    m_growing = counts ? m_growing + 1 : 0;
    last = m_peak;
    m_peak = std::abs(error);
    m_wasAtLimit = std::exchange(m_atLimit, false);
    m_turned = false;
}

void OscillationWatch::duty(Instant time, double fraction, double limit)
{
    m_atLimit = m_atLimit || std::abs(fraction) >= atLimit * limit;
    if (std::abs(fraction) > strong * limit) {
        if (fraction * m_strongDuty < 0.0)
            m_flips.push_back(time);
        m_strongDuty = fraction;
    }
    while (!m_flips.empty() && time - m_flips.front() > 1s)
        m_flips.pop_front();
}

void LossWatch::add(Instant now, std::uint64_t samples, std::uint64_t lost)
{
    m_counts.push_back({now, samples, lost});
    while (m_counts.size() > 1 && now - m_counts.front().at > 1s)
        m_counts.pop_front();
    const std::uint64_t came = samples - m_counts.front().samples;
    const std::uint64_t missing = lost - m_counts.front().lost;
    if (came + missing < enoughSamples)
        m_share = 0.0;
    else // a whole second brings as many as the part of it that is known, and one poll of a few is no twentieth of them
        m_share
            = static_cast<double>(missing) / static_cast<double>(came + missing) * inSeconds(now - m_counts.front().at);
}

} // namespace mb::tuning
