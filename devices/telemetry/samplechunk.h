// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace mb {

/// Whole microseconds on the clock's time line.
using Micros = std::int64_t;
/// Where a sample lies on a SampleTape: chunk number and place in the chunk, 2^32 samples, 58 GB. The end is place 0 of
/// the chunk after the last.
using TapePosition = std::uint32_t;

/// Extremes of a stretch of samples and where they are first met. Without initialisers: chunks are allocated unwritten,
/// so that the pages of a channel that is hardly used are never touched.
struct Extent {
    double low;
    double high;
    TapePosition lowAt;
    TapePosition highAt;

    [[nodiscard]] static Extent nothing()
    {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        return {infinity, -infinity, 0, 0};
    }
    /// `later` follows what is in the node already.
    void add(const Extent &later)
    {
        if (later.low < low) {
            low = later.low;
            lowAt = later.lowAt;
        }
        if (later.high > high) {
            high = later.high;
            highAt = later.highAt;
        }
    }
    /// Takes one more sample in, as the only one of a fresh node; whether that changed anything.
    bool take(bool fresh, TapePosition position, double value)
    {
        if (fresh) {
            *this = {value, value, position, position};
            return true;
        }
        if (value < low) {
            low = value;
            lowAt = position;
            return true;
        }
        if (value > high) {
            high = value;
            highAt = position;
            return true;
        }
        return false;
    }
};

/// The 4096 samples that are allocated at a time, or fewer when they span more than 32 bits of microseconds (71
/// minutes).
struct SampleChunk {
    static constexpr std::uint32_t size = 4096;

    std::size_t firstIndex; ///< number of the first sample in the whole recording
    std::uint32_t count;
    std::array<double, size> values;
    std::array<std::uint32_t, size> offsets; ///< microseconds since the chunk's start
    std::array<Extent, size / 16> fine;
    std::array<Extent, size / 256> coarse;

    /// The first place from `least` on whose offset is not below `offset`, or `count`. Guesses as if samples came at
    /// regular times, and searches outwards from there.
    [[nodiscard]] std::uint32_t search(Micros offset, std::uint32_t least, std::uint64_t &visited) const
    {
        ++visited;
        const std::uint32_t last = count - 1;
        if (least >= count || offset > offsets[last])
            return count;
        if (offset <= offsets[least])
            return least;
        const auto span = static_cast<std::uint64_t>(offsets[last] - offsets[least]);
        const auto part = static_cast<std::uint64_t>(offset) - offsets[least];
        std::uint32_t low = least; // its offset is below,
        std::uint32_t high = last; // and this one's is not
        const auto guess = least + static_cast<std::uint32_t>(part * (last - least) / span);
        if (offsets[guess] < offset)
            searchUp(offset, guess, low, high, visited);
        else
            searchDown(offset, guess, low, high, visited);
        for (; high - low > 1; ++visited) {
            const std::uint32_t middle = low + (high - low) / 2;
            (offsets[middle] < offset ? low : high) = middle;
        }
        return high;
    }

private:
    /// Narrows what lies between `low` and `high`, from a `guess` that is below.
    void searchUp(
        Micros offset, std::uint32_t guess, std::uint32_t &low, std::uint32_t &high, std::uint64_t &visited) const
    {
        low = guess;
        std::uint32_t step = 1;
        for (; low + step < high && offsets[low + step] < offset; step *= 2) {
            low += step;
            ++visited;
        }
        high = std::min(high, low + step);
    }
    /// The same from one that is not.
    void searchDown(
        Micros offset, std::uint32_t guess, std::uint32_t &low, std::uint32_t &high, std::uint64_t &visited) const
    {
        high = guess;
        std::uint32_t step = 1;
        for (; low + step < high && offsets[high - step] >= offset; step *= 2) {
            high -= step;
            ++visited;
        }
        low = std::max(low, high < step ? low : high - step);
    }
};

} // namespace mb
