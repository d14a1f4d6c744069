// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transport/canlink.h"

#include <array>
#include <compare>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace mb {

/// What one row of a table of identifiers stands for. Our own frames and those of others are never mixed: another master
/// that uses our identifiers must be seen.
struct TrafficKey {
    std::uint32_t id = 0; ///< of an error frame: its class bits
    bool extended = false;
    bool remote = false;
    bool error = false;
    Direction direction = Direction::Received;
    friend auto operator<=>(const TrafficKey &, const TrafficKey &) = default;
};
[[nodiscard]] TrafficKey keyOf(Direction direction, const CanFrame &frame);

/// What is known of one identifier. Times in seconds; nothing while there are too few frames to tell.
struct TrafficRow {
    TrafficKey key;
    std::uint64_t count = 0; ///< frames ever
    CanFrame last;
    std::array<Instant, 8> changed{}; ///< when each byte last differed from the frame before; Instant{} when never
    double rate = 0.0;                ///< frames in the last second, counted in steps of 50 ms
    std::optional<double> period;     ///< mean of the last 32 distances between frames
    std::optional<double> jitter;     ///< standard deviation of these distances; from two on
    std::optional<double> worst;      ///< the largest difference between one of them and their mean
};

/// Counts frames by identifier: O(1) a frame, and memory only for a new identifier. Not locked: TrafficLog does that.
/// Frames of the first `mostKeys` identifiers have a row each, the others are counted together.
class TrafficStatistics {
public:
    static constexpr std::size_t mostKeys = 1024;

    TrafficStatistics();
    void add(Direction direction, const CanFrame &frame);
    void clear();

    /// All rows in the order in which their identifiers appeared; `now` is the end of the last second.
    void rows(Instant now, std::vector<TrafficRow> &out) const;
    /// Frames after `after` for a small line of one identifier, oldest first: the first of each 50 ms, 5 s long.
    void trail(const TrafficKey &key, Instant after, std::vector<CanFrame> &out) const;
    /// Frames whose identifier has no row.
    [[nodiscard]] std::uint64_t unlisted() const { return m_unlisted; }

private:
    static constexpr std::size_t slotCount = 32;
    static constexpr std::size_t periodCount = 32;
    static constexpr std::size_t trailCount = 100;
    static constexpr std::size_t tableSize = 4096;

    struct Entry {
        TrafficKey key;
        std::uint64_t count = 0;
        CanFrame last;
        std::array<Instant, 8> changed{};
        std::int64_t slot = 0;                        ///< the newest of the 50 ms steps
        std::array<std::uint32_t, slotCount> slots{}; ///< frames a step, by step number modulo
        std::array<Duration, periodCount> periods{};  ///< by frame number modulo
        std::uint64_t trailEnd = 0;                   ///< points ever kept
        std::array<CanFrame, trailCount> trail{};     ///< by point number modulo
    };

    [[nodiscard]] Entry *findOrAdd(const TrafficKey &key);
    [[nodiscard]] const Entry *find(const TrafficKey &key) const;
    [[nodiscard]] std::size_t place(const TrafficKey &key) const;
    static void countSlot(Entry &entry, Instant time);
    static void keepTrail(Entry &entry, const CanFrame &frame);
    static TrafficRow rowOf(const Entry &entry, Instant now);
    static void judgePeriods(const Entry &entry, TrafficRow &row);

    std::deque<Entry> m_entries;
    std::vector<std::uint16_t> m_table; ///< open addressing: place in m_entries plus one, 0 free
    std::uint64_t m_unlisted = 0;
};

} // namespace mb
