// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/virtualclock.h"

#include <algorithm>

namespace mb {

bool VirtualClock::step()
{
    if (!hasWork())
        return false;
    m_now = std::max(m_now, nextDeadline());
    runNext();
    return true;
}

void VirtualClock::advance(Duration time)
{
    const Instant end = m_now + time;
    while (hasWork() && nextDeadline() <= end)
        step();
    m_now = end;
}

bool VirtualClock::runUntil(const std::function<bool()> &done, Duration limit)
{
    const Instant end = m_now + limit;
    while (!done()) {
        if (!hasWork() || nextDeadline() > end)
            return false;
        step();
    }
    return true;
}

} // namespace mb
