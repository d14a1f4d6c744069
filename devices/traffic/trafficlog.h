// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "traffic/trafficstatistics.h"

#include <cstdint>
#include <mutex>
#include <span>
#include <vector>

namespace mb {

/// One thing that passed a link, by value: a frame of CAN, or bytes of a serial line or of SPI.
struct TrafficRecord {
    std::uint64_t number = 0; ///< counts from 1 without holes, per log
    Direction direction = Direction::Received;
    CanFrame frame;                    ///< of bytes: only its time
    std::uint32_t length = 0;          ///< bytes that passed; 0: this is a frame
    std::vector<std::uint8_t> bytes{}; ///< at most the first 4096 of them; empty when they are kept no longer

    [[nodiscard]] bool isFrame() const { return length == 0; }
};

/// The last traffic of one link, for whoever shows it, and the count of all that ever passed, by identifier. Written by the engine thread,
/// read by any; one short lock a frame, nothing allocated per frame. What a reader did not fetch in time is overwritten, and
/// the numbers tell how much; the statistics have it all the same.
class TrafficLog : NonCopyable {
public:
    explicit TrafficLog(std::size_t capacity = 65536);

    void append(Direction direction, const CanFrame &frame);
    /// For links without frames. Nothing happens without bytes.
    void append(Direction direction, Instant time, std::span<const std::uint8_t> bytes);
    /// Appends to `out` the records after number `after`, at most `limit` of the newest; yields the newest number.
    std::uint64_t fetch(std::uint64_t after, std::size_t limit, std::vector<TrafficRecord> &out) const;
    [[nodiscard]] std::uint64_t newest() const;
    /// Time of the first record ever; Instant{} before.
    [[nodiscard]] Instant firstTime() const;

    /// Appends one row for each identifier; see TrafficStatistics. Yields the frames that have none.
    std::uint64_t statistics(Instant now, std::vector<TrafficRow> &out) const;
    /// Appends the last 5 s of one identifier, one frame each 50 ms, those after `after` only.
    void trail(const TrafficKey &key, Instant after, std::vector<CanFrame> &out) const;

private:
    struct Kept {
        CanFrame frame;
        std::uint64_t begin = 0; ///< of its bytes, counted over all bytes ever kept
        std::uint32_t length = 0;
        Direction direction = Direction::Received;
    };
    void keep(const Kept &kept);
    [[nodiscard]] TrafficRecord record(std::uint64_t number) const;

    mutable std::mutex m_mutex;
    std::vector<Kept> m_ring;
    std::uint64_t m_newest = 0;
    Instant m_firstTime{};
    std::vector<std::uint8_t> m_bytes; ///< a ring too; empty on links with frames
    std::uint64_t m_bytesEnd = 0;
    TrafficStatistics m_statistics;
};

} // namespace mb
