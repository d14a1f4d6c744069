// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/framerow.h"

#include <utility>

namespace mb {
namespace {

constexpr std::size_t mostIdentifiers = 4096; ///< whose last time is remembered for Δ

/// Seconds since the last one in the book; 0 for the first.
template <class Book, class Key> double sinceLast(Book &book, const Key &key, Instant time)
{
    const auto [last, isNew] = book.try_emplace(key, time);
    const Duration since = time - std::exchange(last->second, time);
    return isNew ? 0.0 : std::chrono::duration<double>(since).count();
}

} // namespace

FrameRow FrameSuccession::next(TrafficRecord record)
{
    FrameRow row{std::move(record), 0.0, {}};
    const Instant time = row.record.frame.time;
    if (row.record.isFrame()) {
        row.asked = m_follower.addressOf(row.record.frame);
        if (m_last.size() > mostIdentifiers)
            m_last.clear();
        row.sinceSame = sinceLast(m_last, keyOf(row.record.direction, row.record.frame), time);
    } else if (auto packets = m_packets.take(row.record); !packets.empty()) {
        row.said = std::make_shared<const std::vector<FrameMeaning>>(std::move(packets));
        row.sinceSame = sinceLast(m_lastPacket, std::pair(row.record.direction, row.packet()->frame.message), time);
    }
    return row;
}

void FrameSuccession::forgetTimes()
{
    m_last.clear();
    m_lastPacket.clear();
}

} // namespace mb
