// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

#include <algorithm>
#include <cstdint>

namespace mb {

/// How much of a line is in use, over whole seconds of its traffic.
class LineLoad {
public:
    /// `bits` on the wire at `time`; times do not run backwards.
    void count(Instant time, std::uint64_t bits)
    {
        if (time - m_second >= window) {
            m_bitsBefore = time - m_second < 2 * window ? m_bits : 0;
            m_bits = 0;
            m_second = time;
        }
        m_bits += bits;
    }
    /// Fraction of `bitrate` in use, 0…1.
    [[nodiscard]] double fraction(Instant now, int bitrate) const
    {
        const auto age = now - m_second;
        if (age >= 2 * window || bitrate <= 0)
            return 0.0;
        return std::min(1.0, static_cast<double>(age >= window ? m_bits : m_bitsBefore) / bitrate);
    }

private:
    static constexpr Duration window = std::chrono::seconds(1);
    Instant m_second{};
    std::uint64_t m_bits = 0;
    std::uint64_t m_bitsBefore = 0;
};

} // namespace mb
