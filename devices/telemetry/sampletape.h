// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "telemetry/chunkstore.h"
#include "telemetry/point.h"
#include "telemetry/samplechunk.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace mb {

/// The samples of one channel in the order of their times, in chunks with 32-bit time offsets, and over them a pyramid
/// of extremes (factor 16) and sums that is kept on append, so that extremes and moments of any stretch cost what its
/// ends cost. Values are doubles (counts exact to 2^53) and extremes are exact; times are whole microseconds. 13.6 bytes
/// a sample, pyramid included; beyond the budget of a ChunkStore the oldest full chunks move to its file, and everything
/// else goes on as before. Not thread-safe by itself (queries count their work).
class SampleTape : NonCopyable {
public:
    /// Number, mean and sum of squared differences from it; two of them join without loss.
    struct Moments {
        double count = 0.0;
        double mean = 0.0;
        double squares = 0.0;
    };

    ~SampleTape();

    /// Rounded down.
    [[nodiscard]] static Micros toMicros(Instant time);
    [[nodiscard]] static Instant toInstant(Micros time) { return Instant(std::chrono::microseconds(time)); }

    /// A finite value, not before lastTime(); yields where it lies.
    TapePosition append(Micros time, double value);
    /// From now on chunks beyond the store's budget go to its file. Once, before the first sample.
    void keepIn(std::shared_ptr<ChunkStore> store);
    void clear();

    [[nodiscard]] std::size_t size() const { return m_size; }
    /// Of the newest sample; the least there is before the first.
    [[nodiscard]] Micros lastTime() const { return m_lastTime; }
    [[nodiscard]] TapePosition end() const { return positionOf(m_chunks.size(), 0); }
    [[nodiscard]] TapePosition next(TapePosition position) const;
    [[nodiscard]] TapePosition previous(TapePosition position) const;
    /// Number of the sample in the whole recording, and back.
    [[nodiscard]] std::size_t indexOf(TapePosition position) const;
    [[nodiscard]] TapePosition positionAt(std::size_t index) const;
    [[nodiscard]] Micros timeAt(TapePosition position) const;
    [[nodiscard]] Point pointAt(TapePosition position) const;
    /// The first sample not before `time`, at `from` or after it.
    [[nodiscard]] TapePosition search(Micros time, TapePosition from = 0) const;
    /// Extremes of [from, to), which is not empty, and where they are first met.
    [[nodiscard]] Extent range(TapePosition from, TapePosition to) const;
    /// Of [from, to), which is not empty; one step for each chunk.
    [[nodiscard]] Moments moments(TapePosition from, TapePosition to) const;

    /// Bytes allocated in memory; chunks that went to the file of a store are not among them.
    [[nodiscard]] std::size_t memoryUse() const;
    /// Samples and nodes that queries have looked at since construction.
    [[nodiscard]] std::uint64_t visited() const { return m_visited; }

private:
    static constexpr std::size_t levelCount = 4;

    /// Sums over one chunk, of the differences from its first value: exact where values are large and close.
    struct Sums {
        double first = 0.0;
        double sum = 0.0;
        double squares = 0.0;
    };
    /// A chunk is in memory, or in a place of the store.
    struct Release {
        ChunkStore *store = nullptr; ///< nullptr: allocated
        void operator()(SampleChunk *chunk) const;
    };

    [[nodiscard]] static std::size_t chunkOf(TapePosition position) { return position / SampleChunk::size; }
    [[nodiscard]] static std::uint32_t placeOf(TapePosition position) { return position % SampleChunk::size; }
    [[nodiscard]] static TapePosition positionOf(std::size_t chunk, std::uint32_t place)
    {
        return static_cast<TapePosition>(chunk) * SampleChunk::size + place;
    }
    static void join(Moments &moments, const Sums &sums, double count);

    [[nodiscard]] SampleChunk &chunkFor(Micros time);
    /// Moves the oldest chunks that are still in memory to the file, while the store is over its budget.
    void moveOut();
    void include(SampleChunk &chunk, TapePosition position, double value);
    void addMoments(std::size_t chunk, std::uint32_t from, std::uint32_t to, Moments &moments) const;
    void addPlaces(std::size_t chunk, std::uint32_t from, std::uint32_t to, Extent &sum) const;
    void addChunks(std::size_t from, std::size_t to, Extent &sum) const;

    std::shared_ptr<ChunkStore> m_store; ///< outlives the chunks
    std::vector<std::unique_ptr<SampleChunk, Release>> m_chunks;
    std::size_t m_movedOut = 0;                           ///< so many of the first chunks are in the file
    std::vector<Sums> m_sums;                             ///< of the chunks
    std::vector<Micros> m_starts;                         ///< of the chunks
    std::array<std::vector<Extent>, levelCount> m_levels; ///< one node for 1, 16, 256, 4096 chunks
    std::size_t m_size = 0;
    Micros m_lastTime = std::numeric_limits<Micros>::min();
    mutable std::uint64_t m_visited = 0;
};

} // namespace mb
