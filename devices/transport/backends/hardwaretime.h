// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

#include <algorithm>

namespace mb {

/// Puts the stamps of an adapter's own free-running clock on our time line. The kernel's stamp of the same frame is
/// late by a varying delay (interrupts, USB), so the smallest difference seen counts; it is let grow by `drift` to
/// follow a slow clock. Never later than the kernel's stamp.
class HardwareTime {
public:
    [[nodiscard]] Instant align(Duration hardware, Instant arrived)
    {
        const Duration offset = arrived.time_since_epoch() - hardware;
        const Duration grown = m_offset + std::max(arrived - m_arrived, Duration::zero()) / drift;
        m_arrived = arrived;
        if (!m_known || offset - grown > restarted)
            m_offset = offset; // the first stamp, or the adapter began to count anew
        else
            m_offset = std::min(offset, grown);
        m_known = true;
        return Instant(hardware + m_offset);
    }
    void reset() { m_known = false; }

private:
    static constexpr int drift = 10'000; ///< one part in so many: 100 ppm
    static constexpr Duration restarted = std::chrono::milliseconds(200);

    bool m_known = false;
    Duration m_offset{};
    Instant m_arrived{};
};

} // namespace mb
