// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/entryspeed.h"

#include <algorithm>

namespace mb::abstractdc {

void EntrySpeed::located(double position, Instant time, bool passing)
{
    m_last = {position, time};
    if (passing || !m_from)
        m_from = m_last;
    m_known = m_known || passing;
}

void EntrySpeed::restarted(Instant time)
{
    m_from = Seen{0.0, time};
    m_known = true;
}

EntrySpeed::Range EntrySpeed::range(double now) const
{
    Range range{std::min(now, m_known ? now : 0.0), std::max(now, m_known ? now : 0.0)};
    const double seconds = m_from ? std::chrono::duration<double>(m_last.time - m_from->time).count() : 0.0;
    if (seconds <= 0.0)
        return range;
    const double mean = (m_last.position - m_from->position) / seconds;
    return {std::min(range.low, mean), std::max(range.high, mean)};
}

} // namespace mb::abstractdc
