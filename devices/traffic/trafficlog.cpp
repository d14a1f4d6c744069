// SPDX-License-Identifier: GPL-3.0-or-later
#include "traffic/trafficlog.h"

#include <algorithm>

namespace mb {
namespace {

constexpr std::size_t byteRing = 262144;
constexpr std::size_t mostBytes = 4096; ///< of one record

} // namespace

TrafficLog::TrafficLog(std::size_t capacity)
    : m_ring(capacity)
{
}

void TrafficLog::keep(const Kept &kept)
{
    if (m_newest == 0)
        m_firstTime = kept.frame.time;
    ++m_newest;
    m_ring[m_newest % m_ring.size()] = kept;
}

void TrafficLog::append(Direction direction, const CanFrame &frame)
{
    const std::lock_guard lock(m_mutex);
    keep({frame, 0, 0, direction});
    m_statistics.add(direction, frame);
}

void TrafficLog::append(Direction direction, Instant time, std::span<const std::uint8_t> bytes)
{
    if (bytes.empty())
        return;
    const std::lock_guard lock(m_mutex);
    m_bytes.resize(byteRing);
    Kept kept{{}, m_bytesEnd, static_cast<std::uint32_t>(bytes.size()), direction};
    kept.frame.time = time;
    for (const std::uint8_t byte : bytes.first(std::min(bytes.size(), mostBytes)))
        m_bytes[m_bytesEnd++ % byteRing] = byte;
    keep(kept);
}

TrafficRecord TrafficLog::record(std::uint64_t number) const
{
    const Kept &kept = m_ring[number % m_ring.size()];
    TrafficRecord record{number, kept.direction, kept.frame, kept.length, {}};
    if (kept.length == 0 || kept.begin + byteRing < m_bytesEnd)
        return record;
    const std::size_t size = std::min<std::size_t>(kept.length, mostBytes);
    record.bytes.reserve(size);
    for (std::uint64_t i = kept.begin; i < kept.begin + size; ++i)
        record.bytes.push_back(m_bytes[i % byteRing]);
    return record;
}

std::uint64_t TrafficLog::fetch(std::uint64_t after, std::size_t limit, std::vector<TrafficRecord> &out) const
{
    const std::lock_guard lock(m_mutex);
    const std::uint64_t kept = std::min<std::uint64_t>({limit, m_ring.size(), m_newest});
    const std::uint64_t first = std::max(after + 1, m_newest - kept + 1);
    for (std::uint64_t number = first; number <= m_newest; ++number)
        out.push_back(record(number));
    return m_newest;
}

std::uint64_t TrafficLog::newest() const
{
    const std::lock_guard lock(m_mutex);
    return m_newest;
}

Instant TrafficLog::firstTime() const
{
    const std::lock_guard lock(m_mutex);
    return m_firstTime;
}

std::uint64_t TrafficLog::statistics(Instant now, std::vector<TrafficRow> &out) const
{
    const std::lock_guard lock(m_mutex);
    m_statistics.rows(now, out);
    return m_statistics.unlisted();
}

void TrafficLog::trail(const TrafficKey &key, Instant after, std::vector<CanFrame> &out) const
{
    const std::lock_guard lock(m_mutex);
    m_statistics.trail(key, after, out);
}

} // namespace mb
