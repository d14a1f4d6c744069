// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transport/link.h"

#include <algorithm>
#include <cstdint>
#include <optional>

namespace mb {

/// How much of a link's line is in use, over whole seconds of its traffic.
class LineLoad {
public:
    /// Counts anew each time the link is opened. Both outlive this.
    LineLoad(Link &link, const Clock &clock)
        : m_opened(link.stateChanged().add([this, &clock](LinkState state) {
            if (state == LinkState::Open)
                begin(clock.now());
        }))
    {
    }
    /// `bits` on the wire at `time`; times do not run backwards.
    void count(Instant time, std::uint64_t bits)
    {
        if (!m_second)
            begin(time);
        if (const auto age = time - *m_second; age >= window) {
            m_bitsBefore = age < 2 * window ? m_bits : 0;
            m_bits = 0;
            m_second = time;
        }
        m_bits += bits;
    }
    /// What was counted belongs to another time.
    void forget() { begin(std::nullopt); }
    /// Fraction of `bitrate` in use, 0…1; nothing before the first second is over, and where the rate is not known.
    [[nodiscard]] std::optional<double> fraction(Instant now, int bitrate) const
    {
        const Duration age = m_second ? now - *m_second : Duration::zero();
        const auto bits = age >= 2 * window ? std::uint64_t{0} : age >= window ? m_bits : m_bitsBefore;
        if (!bits || bitrate <= 0)
            return std::nullopt;
        return std::min(1.0, static_cast<double>(*bits) / bitrate);
    }

private:
    static constexpr Duration window = std::chrono::seconds(1);
    void begin(std::optional<Instant> second)
    {
        m_second = second;
        m_bits = 0;
        m_bitsBefore.reset();
    }

    std::optional<Instant> m_second;
    std::uint64_t m_bits = 0;
    std::optional<std::uint64_t> m_bitsBefore;
    Subscription m_opened;
};

} // namespace mb
