// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

#include <cstdint>
#include <deque>
#include <optional>

namespace mb::supermodified {

/// Speed from positions: the node's own reading comes 10 times a second, is 11 % off in D1 and D2, and is always 0 in some builds
/// (README.md#speeds). The slope over the last 50 ms, or over one pair where positions come more slowly.
class VelocityEstimate {
public:
    /// Counts per second; nothing for the first position.
    std::optional<double> add(Instant time, std::int64_t position)
    {
        while (m_points.size() > 1 && time - m_points[1].time >= window)
            m_points.pop_front();
        m_points.push_back({time, position});
        const Point &first = m_points.front();
        if (time <= first.time)
            return std::nullopt;
        m_counts = position - first.position;
        return static_cast<double>(m_counts) / std::chrono::duration<double>(time - first.time).count();
    }
    /// The next position does not continue the last one.
    void interrupt()
    {
        m_points.clear();
        m_counts = 0;
    }
    /// More than what an idle encoder flickers.
    [[nodiscard]] bool isTurning() const { return m_counts > flicker || m_counts < -flicker; }

private:
    struct Point {
        Instant time{};
        std::int64_t position = 0;
    };
    static constexpr Duration window = std::chrono::milliseconds(50);
    static constexpr std::int64_t flicker = 2;
    std::deque<Point> m_points;
    std::int64_t m_counts = 0;
};

} // namespace mb::supermodified
