// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/entryspeed.h"

#include <algorithm>

namespace mb::abstractdc {
namespace {

constexpr double leastElapsed = 0.001; ///< seconds, of the drive

} // namespace

void EntrySpeed::located(double position, Instant time, bool passing)
{
    m_last = {position, time};
    if (!m_first)
        m_first = m_last;
    if (!passing)
        return;
    m_passed = m_last;
    m_known = true;
}

void EntrySpeed::restarted(Instant time)
{
    m_passed = Seen{0.0, time};
    m_known = true;
}

void EntrySpeed::forget()
{
    m_first.reset();
    m_known = false;
}

void EntrySpeed::recall(const Seen &passed)
{
    m_passed = passed;
    m_known = true;
}

std::optional<EntrySpeed::Seen> EntrySpeed::lastPass() const
{
    if (m_known || !m_first)
        return m_known ? m_passed : std::nullopt;
    return Seen{0.0, m_first->time};
}

EntrySpeed::Range EntrySpeed::range(double now) const
{
    Range range{now, now};
    const auto include = [&range](double speed) { range = {std::min(range.low, speed), std::max(range.high, speed)}; };
    if (m_passed)
        include(meanSince(*m_passed).value_or(now));
    if (m_known || !m_first)
        return range;
    include(0.0);
    include(meanSince(*m_first).value_or(0.0));
    include(meanSince({0.0, m_first->time}).value_or(0.0));
    return range;
}

std::optional<double> EntrySpeed::meanSince(const Seen &seen) const
{
    if (seen.position == m_last.position && seen.time == m_last.time)
        return std::nullopt;
    const double seconds = std::chrono::duration<double>(m_last.time - seen.time).count();
    return (m_last.position - seen.position) / std::max(seconds, leastElapsed);
}

} // namespace mb::abstractdc
