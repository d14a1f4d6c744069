// SPDX-License-Identifier: GPL-3.0-or-later
#include "traffic/trafficstatistics.h"

#include <algorithm>
#include <cmath>

namespace mb {
namespace {

constexpr Duration slotTime = std::chrono::milliseconds(50);
constexpr std::int64_t slotsPerSecond = 20;

std::int64_t slotOf(Instant time)
{
    return time.time_since_epoch() / slotTime;
}

std::size_t hashOf(const TrafficKey &key)
{
    const std::uint32_t flags = (key.extended ? 1U : 0U) | (key.remote ? 2U : 0U) | (key.error ? 4U : 0U)
        | (key.direction == Direction::Sent ? 8U : 0U);
    std::uint64_t hash = (std::uint64_t{key.id} << 4U | flags) * 0x9E3779B97F4A7C15ULL;
    hash ^= hash >> 32U;
    return static_cast<std::size_t>(hash);
}

double inSeconds(Duration time)
{
    return std::chrono::duration<double>(time).count();
}

} // namespace

TrafficKey keyOf(Direction direction, const CanFrame &frame)
{
    return {frame.id, frame.extended, frame.remote, frame.error, direction};
}

TrafficStatistics::TrafficStatistics()
    : m_table(tableSize, 0)
{
}

std::size_t TrafficStatistics::place(const TrafficKey &key) const
{
    // At most a quarter of the table is in use: a free place is always near.
    std::size_t place = hashOf(key) % tableSize;
    while (m_table[place] != 0 && m_entries[m_table[place] - 1U].key != key)
        place = (place + 1) % tableSize;
    return place;
}

TrafficStatistics::Entry *TrafficStatistics::findOrAdd(const TrafficKey &key)
{
    const std::size_t at = place(key);
    if (m_table[at] != 0)
        return &m_entries[m_table[at] - 1U];
    if (m_entries.size() == mostKeys)
        return nullptr;
    m_entries.emplace_back().key = key;
    m_table[at] = static_cast<std::uint16_t>(m_entries.size());
    return &m_entries.back();
}

const TrafficStatistics::Entry *TrafficStatistics::find(const TrafficKey &key) const
{
    const std::size_t at = place(key);
    return m_table[at] != 0 ? &m_entries[m_table[at] - 1U] : nullptr;
}

void TrafficStatistics::add(Direction direction, const CanFrame &frame)
{
    Entry *entry = findOrAdd(keyOf(direction, frame));
    if (!entry) {
        ++m_unlisted;
        return;
    }
    if (entry->count > 0) {
        for (std::size_t i = 0; i < frame.data.size(); ++i) {
            const bool was = i < entry->last.size;
            const bool is = i < frame.size;
            if (was != is || (is && frame.data[i] != entry->last.data[i]))
                entry->changed[i] = frame.time;
        }
        entry->periods[entry->count % periodCount] = frame.time - entry->last.time;
    }
    countSlot(*entry, frame.time);
    keepTrail(*entry, frame);
    entry->last = frame;
    ++entry->count;
}

void TrafficStatistics::countSlot(Entry &entry, Instant time)
{
    const std::int64_t slot = slotOf(time);
    const auto at = [&entry](std::int64_t number) -> std::uint32_t & {
        return entry.slots[static_cast<std::size_t>(number) % slotCount];
    };
    if (entry.count == 0)
        entry.slot = slot;
    const std::int64_t first = std::max(entry.slot + 1, slot - static_cast<std::int64_t>(slotCount) + 1);
    for (std::int64_t number = first; number <= slot; ++number)
        at(number) = 0;
    // Time stamps of adapters may step back a little: such a frame counts as the newest did.
    entry.slot = std::max(entry.slot, slot);
    ++at(entry.slot);
}

void TrafficStatistics::keepTrail(Entry &entry, const CanFrame &frame)
{
    if (entry.trailEnd > 0 && slotOf(frame.time) <= slotOf(entry.trail[(entry.trailEnd - 1) % trailCount].time))
        return;
    entry.trail[entry.trailEnd % trailCount] = frame;
    ++entry.trailEnd;
}

void TrafficStatistics::clear()
{
    m_entries.clear();
    std::ranges::fill(m_table, std::uint16_t{0});
    m_unlisted = 0;
}

void TrafficStatistics::judgePeriods(const Entry &entry, TrafficRow &row)
{
    const auto count = std::min<std::uint64_t>(entry.count - 1, periodCount);
    if (count == 0)
        return;
    double sum = 0.0;
    for (std::uint64_t i = entry.count - count; i < entry.count; ++i)
        sum += inSeconds(entry.periods[i % periodCount]);
    const double mean = sum / static_cast<double>(count);
    row.period = mean;
    if (count < 2)
        return;
    double squares = 0.0;
    double worst = 0.0;
    for (std::uint64_t i = entry.count - count; i < entry.count; ++i) {
        const double off = inSeconds(entry.periods[i % periodCount]) - mean;
        squares += off * off;
        worst = std::max(worst, std::abs(off));
    }
    row.jitter = std::sqrt(squares / static_cast<double>(count));
    row.worst = worst;
}

TrafficRow TrafficStatistics::rowOf(const Entry &entry, Instant now)
{
    TrafficRow row{entry.key, entry.count, entry.last, entry.changed, 0.0, {}, {}, {}};
    const std::int64_t end = slotOf(now);
    const std::int64_t oldest = entry.slot - static_cast<std::int64_t>(slotCount) + 1;
    std::uint64_t frames = 0;
    for (std::int64_t slot = std::max(end - slotsPerSecond, oldest); slot < std::min(end, entry.slot + 1); ++slot)
        frames += entry.slots[static_cast<std::size_t>(slot) % slotCount];
    row.rate = static_cast<double>(frames);
    judgePeriods(entry, row);
    return row;
}

void TrafficStatistics::rows(Instant now, std::vector<TrafficRow> &out) const
{
    out.reserve(out.size() + m_entries.size());
    for (const Entry &entry : m_entries)
        out.push_back(rowOf(entry, now));
}

void TrafficStatistics::trail(const TrafficKey &key, Instant after, std::vector<CanFrame> &out) const
{
    const Entry *entry = find(key);
    if (!entry)
        return;
    const auto kept = std::min<std::uint64_t>(entry->trailEnd, trailCount);
    for (std::uint64_t i = entry->trailEnd - kept; i < entry->trailEnd; ++i) {
        const CanFrame &frame = entry->trail[i % trailCount];
        if (frame.time > after)
            out.push_back(frame);
    }
}

} // namespace mb
