// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "telemetry/columnwindow.h"
#include "telemetry/linebreaks.h"
#include "telemetry/point.h"
#include "telemetry/sampletape.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace mb {

/// The whole recording of one channel: its samples on a tape, the breaks of its line, and what readers ask of a stretch
/// of time. A picture of any stretch costs what its width costs, not what its length costs. Times are kept in whole
/// microseconds, rounded down. Not thread-safe by itself (queries count their work): see Telemetry.
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

    /// Times must not decrease: an older one is stored with the time of the last sample, and counted by clamped().
    /// A value that is not finite is not stored: it breaks the line and counts as one lost sample.
    void append(Instant time, double value);
    /// The next sample does not connect to the last one; `lost` samples are known missing between them.
    void breakLine(std::uint64_t lost = 0);
    /// From now on chunks beyond the store's budget go to its file. Once, before the first sample.
    void keepIn(std::shared_ptr<ChunkStore> store) { m_tape.keepIn(std::move(store)); }
    /// Forgets everything, the counters of lost and clamped samples included; revision() goes on.
    void clear();

    [[nodiscard]] std::size_t size() const { return m_tape.size(); }
    [[nodiscard]] bool isEmpty() const { return m_tape.size() == 0; }
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
    [[nodiscard]] std::size_t memoryUse() const { return m_tape.memoryUse() + m_breaks.memoryUse(); }
    /// Samples and nodes that queries have looked at since construction: what tests and benchmarks bound.
    [[nodiscard]] std::uint64_t visited() const { return m_tape.visited(); }

private:
    static constexpr std::size_t blockSize = 4096; ///< of forEach()

    SampleTape m_tape;
    LineBreaks m_breaks;
    std::uint64_t m_lost = 0;
    std::uint64_t m_clamped = 0;
    std::uint64_t m_revision = 0;
    std::uint64_t m_generation = 0; ///< cleared so many times
    bool m_broken = false;
};

template <class Visitor> void History::forEach(Instant from, Instant to, Visitor visit) const
{
    std::vector<Point> block;
    std::size_t index = lowerBound(from);
    for (bool begun = false;; begun = true) {
        const std::size_t following = read(index, to, blockSize, block);
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
