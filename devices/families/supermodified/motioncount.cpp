// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/motioncount.h"

#include "families/supermodified/movecommand.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace mb::supermodified {

std::int64_t MotionCount::targetOf(const SetPoint &setPoint) const
{
    const auto target = static_cast<std::int64_t>(std::llround(setPoint.target));
    return isPosition(setPoint.mode) && !setPoint.relative ? target - m_origin : target;
}

double MotionCount::Step::farther() const
{
    return static_cast<double>(std::abs(low) > std::abs(high) ? low : high);
}

std::optional<MotionCount::Step> MotionCount::stepOf(const SetPoint &setPoint, bool started) const
{
    const std::int64_t target = targetOf(setPoint);
    if (!started && setPoint.relative)
        return Step{target, target};
    if (!m_position || (setPoint.relative && !m_setPoint))
        return std::nullopt;
    const Range to = setPoint.relative ? m_setPoint->moved(target) : Range{target, target};
    return Step{to.low - *m_position, to.high - *m_position};
}

std::optional<MotionCount::Step> MotionCount::error() const
{
    if (!m_position || !m_setPoint)
        return std::nullopt;
    return Step{m_setPoint->low - *m_position, m_setPoint->high - *m_position};
}

MotionCount::Range MotionCount::Range::with(const Range &other) const
{
    return {std::min(low, other.low), std::max(high, other.high)};
}

/// The node was halted between two positions that it told.
void MotionCount::told(std::int64_t raw)
{
    if (std::exchange(m_halted, false))
        m_setPoint = Range{raw, raw}.with({m_position.value_or(raw), m_position.value_or(raw)});
    m_position = raw;
}

bool MotionCount::mayHaveStarted(std::int64_t raw)
{
    const auto before = std::exchange(m_startSentAt, std::nullopt);
    if (!before || std::abs(raw) >= std::abs(raw - *before))
        return false;
    m_origin += *before;
    m_position = 0;
    doubted();
    return true;
}

void MotionCount::started()
{
    m_origin += m_position.value_or(0);
    m_position = 0;
    m_setPoint = Range{};
    m_halted = false;
    m_startSentAt.reset();
}

void MotionCount::began(const SetPoint &setPoint)
{
    m_halted = isHold(setPoint);
    if (!m_halted)
        m_setPoint = after(setPoint);
    else
        m_setPoint = m_position ? std::optional(Range{*m_position, *m_position}) : std::nullopt;
}

/// A velocity moves the set-point on and on; a profile begins where the motor or the set-point is, and moves it to the target.
std::optional<MotionCount::Range> MotionCount::after(const SetPoint &setPoint) const
{
    const std::int64_t target = targetOf(setPoint);
    if (setPoint.mode == Mode::Position && !setPoint.relative)
        return Range{target, target};
    if (!isPosition(setPoint.mode) || !m_setPoint)
        return std::nullopt;
    if (setPoint.mode == Mode::Position)
        return m_setPoint->moved(target);
    if (!m_position)
        return std::nullopt;
    const Range from = m_setPoint->with({*m_position, *m_position});
    return from.with(setPoint.relative ? from.moved(target) : Range{target, target});
}

void MotionCount::zeroed()
{
    m_origin = 0;
    m_position = 0;
    m_startSentAt.reset();
    doubted();
}

void MotionCount::doubted()
{
    m_setPoint.reset();
    m_halted = false;
}

} // namespace mb::supermodified
