// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "telemetry/telemetry.h"

#include <memory>

namespace mb {

/// Reads one channel from a time on, sample by sample, in blocks, so that the lock is never held long; goes on later
/// where it was when more has been recorded, and at the beginning where that was forgotten. Any thread, one at a time.
class SampleCursor {
public:
    SampleCursor(std::shared_ptr<const Telemetry> telemetry, ChannelIndex channel, Instant from = Instant::min());

    /// The next sample that is not later than `to`, or a gap before one (its value is not a number, its time that of the
    /// sample before); nullptr when there is none yet. Valid until the next call.
    [[nodiscard]] const Point *peek(Instant to = Instant::max());
    void pop() { ++m_place; }
    struct Place {
        std::size_t block = 0; ///< number of the sample that it begins with
        std::size_t point = 0;
        bool begun = false;
        std::uint64_t generation = 0;
    };
    [[nodiscard]] Place place() const { return {m_blockBegin, m_place, m_begun, m_generation}; }
    /// Goes back to a place where it was: what came since is read again.
    void rewind(Place place);
    [[nodiscard]] const Telemetry &telemetry() const { return *m_telemetry; }
    [[nodiscard]] ChannelIndex channel() const { return m_channel; }
    /// The number of the sample that the next block begins with.
    [[nodiscard]] std::size_t index() const { return m_index; }

private:
    std::shared_ptr<const Telemetry> m_telemetry;
    ChannelIndex m_channel;
    Instant m_from;
    std::uint64_t m_generation; ///< of the samples that it counts
    std::size_t m_index = 0;
    std::size_t m_blockBegin = 0;
    bool m_begun = false;
    std::vector<Point> m_block;
    std::size_t m_place = 0;
};

} // namespace mb
