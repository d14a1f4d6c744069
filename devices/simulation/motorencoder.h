// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

namespace mb {

/// What is mounted on the simulated shaft and counts: whole counts of the shaft's exact place, the right way round or the other, or
/// none any more.
class MotorEncoder {
public:
    /// `place`: of the shaft, in counts.
    [[nodiscard]] std::int64_t counts(double place) const
    {
        return m_deadCount ? *m_deadCount : static_cast<std::int64_t>(std::floor(m_origin + m_sign * place));
    }
    /// Counts the other way round from here on.
    void setReversed(bool reversed, double place)
    {
        const double sign = reversed ? -1.0 : 1.0;
        m_origin += (m_sign - sign) * place;
        m_sign = sign;
    }
    /// Stays where it is.
    void setDead(bool dead, double place)
    {
        if (dead != m_deadCount.has_value())
            m_deadCount = dead ? std::optional(counts(place)) : std::nullopt;
    }

private:
    double m_sign = 1.0;
    double m_origin = 0.0; ///< counts
    std::optional<std::int64_t> m_deadCount;
};

} // namespace mb
