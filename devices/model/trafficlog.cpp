// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/trafficlog.h"

#include <algorithm>

namespace mb {

TrafficLog::TrafficLog(std::size_t capacity)
    : m_ring(capacity)
{
}

void TrafficLog::append(Direction direction, const CanFrame &frame)
{
    const std::lock_guard lock(m_mutex);
    ++m_newest;
    m_ring[m_newest % m_ring.size()] = TrafficRecord{m_newest, direction, frame};
}

std::uint64_t TrafficLog::fetch(std::uint64_t after, std::size_t limit, std::vector<TrafficRecord> &out) const
{
    const std::lock_guard lock(m_mutex);
    const std::uint64_t kept = std::min<std::uint64_t>({limit, m_ring.size(), m_newest});
    const std::uint64_t first = std::max(after + 1, m_newest - kept + 1);
    for (std::uint64_t number = first; number <= m_newest; ++number)
        out.push_back(m_ring[number % m_ring.size()]);
    return m_newest;
}

std::uint64_t TrafficLog::newest() const
{
    const std::lock_guard lock(m_mutex);
    return m_newest;
}

} // namespace mb
