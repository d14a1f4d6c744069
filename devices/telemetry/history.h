// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace mb {

/// A sample, or a break of the line where the value is not a number.
struct Point {
    Instant time{};
    double value = std::numeric_limits<double>::quiet_NaN();

    [[nodiscard]] bool isGap() const { return std::isnan(value); }
};

class History;

class ChunkStore;

/// What History::columns() answered last, kept by a reader who asks again and again for a window that moves: only
/// columns that are new since, or not full yet, are computed. One for each trace of a picture.
class ColumnWindow {
public:
    [[nodiscard]] const std::vector<Point> &points() const { return m_points; }

private:
    friend class History;
    std::vector<Point> m_points;
    std::vector<Point> m_before; ///< the answer before, while the new one is made
    const History *m_history = nullptr;
    std::uint64_t m_generation = 0;
    std::int64_t m_width = 0; ///< these three in microseconds
    std::int64_t m_from = 0;  ///< columns from here
    std::int64_t m_to = 0;    ///< to here are there and will not change
};

/// The whole recording of one channel: chunks of values with 32-bit time offsets, and a pyramid of extremes (factor 16)
/// that is kept on append, so that a picture of any stretch costs what its width costs, not what its length costs.
/// Values are doubles (counts exact to 2^53) and extremes are exact; times are kept in whole microseconds, rounded
/// down. 13.6 bytes a sample, pyramid included; beyond the budget of a ChunkStore the oldest full chunks move to its file,
/// and everything else goes on as before. Not thread-safe by itself (queries count their work): see Telemetry.
class History {
public:
    struct Extremes {
        double low = 0.0;
        double high = 0.0;
    };
    /// Between the sample at `from` and the one at `to` the line is broken, and `lost` samples are known missing.
    struct Gap {
        Instant from{};
        Instant to{};
        std::uint64_t lost = 0;
    };

    /// Of the samples in a stretch of time. Each sample counts the same, whatever the time to the next.
    struct Statistics {
        std::size_t count = 0;
        std::uint64_t lost = 0; ///< known missing between them
        double mean = 0.0;
        double deviation = 0.0; ///< standard deviation of the samples, divided by their number
        double rms = 0.0;
        double low = 0.0;
        double high = 0.0;
    };

    History();
    History(const History &) = delete;
    History &operator=(const History &) = delete;
    ~History();

    /// Times must not decrease: an older one is stored with the time of the last sample, and counted by clamped().
    /// A value that is not finite is not stored: it breaks the line and counts as one lost sample.
    void append(Instant time, double value);
    /// The next sample does not connect to the last one; `lost` samples are known missing between them.
    void breakLine(std::uint64_t lost = 0);
    /// From now on chunks beyond the store's budget go to its file. Once, before the first sample.
    void keepIn(std::shared_ptr<ChunkStore> store);
    /// Forgets everything, the counters of lost and clamped samples included; revision() goes on.
    void clear();

    [[nodiscard]] std::size_t size() const { return m_size; }
    [[nodiscard]] bool isEmpty() const { return m_size == 0; }
    [[nodiscard]] std::optional<Point> first() const;
    [[nodiscard]] std::optional<Point> last() const;
    /// Samples known missing, those before the first and after the last sample included.
    [[nodiscard]] std::uint64_t lost() const { return m_lost; }
    [[nodiscard]] std::uint64_t clamped() const { return m_clamped; }
    /// Moves with every change.
    [[nodiscard]] std::uint64_t revision() const { return m_revision; }

    /// The width of the columns that columns() uses: a pixel rounded down to seven significant bits of whole
    /// microseconds, so that a window that is a nanosecond longer has the same columns.
    [[nodiscard]] static Duration columnWidth(Instant from, Instant to, int pixels);
    /// What a line through the samples of [from, to] looks like on `pixels` columns; replaces `out`.
    /// Columns are whole multiples of their width on the clock's time line, so nothing shimmers while scrolling; those
    /// that `from` and `to` fall in come whole, and so do the one sample before and after them. Each column gives all
    /// of its samples when they are four or fewer, else the first, the least, the greatest and the last, in time order.
    /// A point that is not a number, with the time of the sample before it, stands at each gap, except inside columns
    /// of more than four samples, where a gap is narrower than a pixel: gaps() has those.
    void columns(Instant from, Instant to, int pixels, std::vector<Point> &out) const;
    /// The same points, at a fraction of the cost when `window` has most of them already.
    void columns(Instant from, Instant to, int pixels, ColumnWindow &window) const;
    /// The last sample at or before `time`.
    [[nodiscard]] std::optional<Point> at(Instant time) const;
    /// Of the samples in [from, to]; nothing when there are none.
    [[nodiscard]] std::optional<Extremes> extremes(Instant from, Instant to) const;
    /// Of the samples in [from, to]; costs what its ends cost and one step for each 4096 samples.
    [[nodiscard]] std::optional<Statistics> statistics(Instant from, Instant to) const;
    /// Gaps that touch [from, to], in time order. Those that begin less than `merge` after the beginning of another are
    /// reported as one with it, which bounds the cost. A gap is listed once a sample follows it; lost() knows it
    /// before.
    [[nodiscard]] std::vector<Gap> gaps(Instant from, Instant to, Duration merge = Duration::zero()) const;

    /// Calls `visit(const Point &)` for every sample in [from, to], and for every gap between two of them.
    template <class Visitor> void forEach(Instant from, Instant to, Visitor visit) const;
    /// For readers that must let go of a lock between blocks: the number of the first sample at or after `from` …
    [[nodiscard]] std::size_t lowerBound(Instant from) const;
    /// … and up to `most` samples from number `index` on, not later than `to`, with gaps between them (also before the
    /// first one, unless it is number 0); replaces `out`. Yields the number to go on with; it is `index` at the end.
    std::size_t read(std::size_t index, Instant to, std::size_t most, std::vector<Point> &out) const;

    /// Bytes allocated in memory; chunks that went to the file of a store are not among them.
    [[nodiscard]] std::size_t memoryUse() const;
    /// Samples and nodes that queries have looked at since construction: what tests and benchmarks bound.
    [[nodiscard]] std::uint64_t visited() const { return m_visited; }

private:
    static constexpr std::uint32_t chunkSize = 4096;
    static constexpr std::size_t levelCount = 4;

    using Micros = std::int64_t;
    /// Chunk number and place in the chunk: 2^32 samples, 58 GB. The end is place 0 of the chunk after the last.
    using Position = std::uint32_t;
    struct Node;
    struct Chunk;
    class Columns;
    /// Sums over one chunk, of the differences from its first value: exact where values are large and close.
    struct Sums {
        double first = 0.0;
        double sum = 0.0;
        double squares = 0.0;
    };
    struct Moments;
    /// A chunk is in memory, or in a room of the store.
    struct Release {
        ChunkStore *store = nullptr; ///< nullptr: allocated
        void operator()(Chunk *chunk) const;
    };
    struct Break {
        Position before;         ///< the sample that does not connect
        std::uint64_t lostSoFar; ///< this break included
    };
    using BreakIterator = std::vector<Break>::const_iterator;

    /// Whole microseconds, rounded down.
    [[nodiscard]] static Micros toMicros(Instant time);
    [[nodiscard]] static Instant toInstant(Micros time) { return Instant(std::chrono::microseconds(time)); }
    [[nodiscard]] static std::size_t chunkOf(Position position) { return position / chunkSize; }
    [[nodiscard]] static std::uint32_t placeOf(Position position) { return position % chunkSize; }
    [[nodiscard]] static Position positionOf(std::size_t chunk, std::uint32_t place)
    {
        return static_cast<Position>(chunk) * chunkSize + place;
    }

    [[nodiscard]] Chunk &room(Micros time);
    /// Moves the oldest chunks that are still in memory to the file, while the store is over its budget.
    void moveOut();
    void addMoments(std::size_t chunk, std::uint32_t from, std::uint32_t to, Moments &moments) const;
    void include(Chunk &chunk, Position position, double value);
    [[nodiscard]] Position end() const;
    [[nodiscard]] Position next(Position position) const;
    [[nodiscard]] Position previous(Position position) const;
    [[nodiscard]] std::size_t indexOf(Position position) const;
    [[nodiscard]] Position positionAt(std::size_t index) const;
    [[nodiscard]] Micros timeAt(Position position) const;
    [[nodiscard]] Point pointAt(Position position) const;
    /// The first sample not before `time`, at `from` or after it.
    [[nodiscard]] Position search(Micros time, Position from = 0) const;
    /// Extremes of [from, to), which is not empty, and where they are first met.
    [[nodiscard]] Node range(Position from, Position to) const;
    void addPlaces(std::size_t chunk, std::uint32_t from, std::uint32_t to, Node &sum) const;
    void addChunks(std::size_t from, std::size_t to, Node &sum) const;
    /// Keeps of `window` what is still right, and yields from where on it has to be completed.
    [[nodiscard]] Micros reuse(ColumnWindow &window, Columns &columns, Micros start, Micros stop) const;
    /// The first break at or after `position`.
    [[nodiscard]] BreakIterator breakFrom(Position position) const;

    std::shared_ptr<ChunkStore> m_store; ///< outlives the chunks
    std::vector<std::unique_ptr<Chunk, Release>> m_chunks;
    std::size_t m_movedOut = 0;                         ///< so many of the first chunks are in the file
    std::vector<Sums> m_sums;                           ///< of the chunks
    std::vector<Micros> m_starts;                       ///< of the chunks
    std::array<std::vector<Node>, levelCount> m_levels; ///< one node for 1, 16, 256, 4096 chunks
    std::vector<Break> m_breaks;
    std::size_t m_size = 0;
    Micros m_lastTime = std::numeric_limits<Micros>::min();
    std::uint64_t m_lost = 0;
    std::uint64_t m_clamped = 0;
    std::uint64_t m_revision = 0;
    std::uint64_t m_generation = 0; ///< cleared so many times
    bool m_broken = false;
    mutable std::uint64_t m_visited = 0;
};

template <class Visitor> void History::forEach(Instant from, Instant to, Visitor visit) const
{
    std::vector<Point> block;
    std::size_t index = lowerBound(from);
    for (bool begun = false;; begun = true) {
        const std::size_t following = read(index, to, chunkSize, block);
        if (following == index)
            return;
        // A gap before the first sample of the stretch lies outside it.
        const std::size_t skip = !begun && block.front().isGap() ? 1 : 0;
        for (std::size_t i = skip; i < block.size(); ++i)
            visit(static_cast<const Point &>(block[i]));
        index = following;
    }
}

} // namespace mb
