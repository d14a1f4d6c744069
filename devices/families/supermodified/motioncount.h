// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/setpoint.h"

#include <cstdint>
#include <optional>

namespace mb::supermodified {

/// Where one node is. It counts from 0 after each Start (README.md#start); positions stay continuous here.
class MotionCount {
public:
    /// What to add to the node's count.
    [[nodiscard]] std::int64_t origin() const { return m_origin; }
    /// As the node counts; nothing before it told.
    [[nodiscard]] std::optional<std::int64_t> ofNode() const { return m_position; }
    /// As set-points count.
    [[nodiscard]] std::optional<std::int64_t> position() const
    {
        return m_position ? std::optional(*m_position + m_origin) : std::nullopt;
    }
    /// The target as the node takes it.
    [[nodiscard]] std::int64_t targetOf(const SetPoint &setPoint) const;

    /// The node told it.
    void told(std::int64_t raw) { m_position = raw; }
    void started();
    /// The node was stopped and counts from 0, and so do set-points.
    void zeroed();

private:
    std::int64_t m_origin = 0;
    std::optional<std::int64_t> m_position;
};

} // namespace mb::supermodified
