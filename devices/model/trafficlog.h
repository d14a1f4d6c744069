// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transport/canlink.h"

#include <cstdint>
#include <mutex>
#include <vector>

namespace mb {

/// One frame that passed a link, by value.
struct TrafficRecord {
    std::uint64_t number = 0; ///< counts from 1 without holes, per log
    Direction direction = Direction::Received;
    CanFrame frame;
};

/// The last frames of one link, for whoever shows them. Written by the engine thread, read by any; one short lock a frame,
/// nothing allocated per frame. What a reader did not fetch in time is overwritten, and the numbers tell how much.
class TrafficLog {
public:
    explicit TrafficLog(std::size_t capacity = 65536);
    TrafficLog(const TrafficLog &) = delete;
    TrafficLog &operator=(const TrafficLog &) = delete;

    void append(Direction direction, const CanFrame &frame);
    /// Appends to `out` the records after number `after`, at most `limit` of the newest; yields the newest number.
    std::uint64_t fetch(std::uint64_t after, std::size_t limit, std::vector<TrafficRecord> &out) const;
    [[nodiscard]] std::uint64_t newest() const;

private:
    mutable std::mutex m_mutex;
    std::vector<TrafficRecord> m_ring;
    std::uint64_t m_newest = 0;
};

} // namespace mb
