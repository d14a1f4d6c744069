// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

#include <algorithm>
#include <optional>

namespace mb::supermodified {

/// How long to wait for answers on one line: what was measured, four times its scatter, and how late this machine is itself
/// (RFC 6298 without its doubling). An idle machine with a plain port stays at the protocol's own times.
class AnswerTime {
public:
    static constexpr Duration ceiling = std::chrono::milliseconds(200); ///< README.md#time-outs

    /// From the end of a question to the start of its answer, late ones included.
    void add(Duration took)
    {
        if (!m_mean) {
            m_mean = took;
            m_scatter = took / 2;
            return;
        }
        m_scatter += (std::max(took - *m_mean, *m_mean - took) - m_scatter) / 4;
        m_mean = *m_mean + (took - *m_mean) / 8;
    }
    /// A deadline of this program was served so long after its time.
    void addLateness(Duration late) { m_lateness = std::max(late, m_lateness * 7 / 8); }

    /// At least `least`, at most the ceiling or `least`.
    [[nodiscard]] Duration patience(Duration least) const
    {
        const Duration wanted = m_mean.value_or(Duration::zero()) + 4 * m_scatter + m_lateness;
        return std::max(least, std::min(wanted, ceiling));
    }

private:
    std::optional<Duration> m_mean;
    Duration m_scatter{};
    Duration m_lateness{};
};

} // namespace mb::supermodified
