// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "telemetry/samplechunk.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <vector>

namespace mb {

/// Where the line of a recording is broken, in the order of time, and how many samples are known missing until there.
class LineBreaks {
public:
    struct Break {
        TapePosition before;     ///< the sample that does not connect
        std::uint64_t lostSoFar; ///< this break included
    };
    using Iterator = std::vector<Break>::const_iterator;

    void add(TapePosition before, std::uint64_t lostSoFar) { m_breaks.push_back({before, lostSoFar}); }
    void clear() { m_breaks.clear(); }

    [[nodiscard]] Iterator begin() const { return m_breaks.begin(); }
    [[nodiscard]] Iterator end() const { return m_breaks.end(); }
    /// The first break at or after `position`, looked for from `start` on.
    [[nodiscard]] Iterator from(TapePosition position, Iterator start) const
    {
        return std::partition_point(
            start, m_breaks.end(), [position](const Break &gap) { return gap.before < position; });
    }
    [[nodiscard]] Iterator from(TapePosition position) const { return from(position, m_breaks.begin()); }
    /// Samples missing at the breaks of [first, after).
    [[nodiscard]] std::uint64_t lostBetween(Iterator first, Iterator after) const
    {
        if (first == after)
            return 0;
        return std::prev(after)->lostSoFar - (first == m_breaks.begin() ? 0 : std::prev(first)->lostSoFar);
    }
    [[nodiscard]] std::size_t memoryUse() const { return m_breaks.capacity() * sizeof(Break); }

private:
    std::vector<Break> m_breaks;
};

} // namespace mb
