// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/setpoint.h"

#include <cstdint>
#include <optional>

namespace mb::supermodified {

/// Where one node is, and where its loop was told to go. It counts from 0 after each Start (README.md#start); positions stay
/// continuous here.
class MotionCount {
public:
    /// Ticks from where the motor is to where an un-profiled move may put the set-point of its loop.
    struct Step {
        std::int64_t low = 0;
        std::int64_t high = 0;
        /// The end that is farther away.
        [[nodiscard]] double farther() const;
    };

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
    /// What a position order makes the error of the loop; D1 and D2 add a distance to the set-point, not to the position. Nothing where
    /// the one it counts from is not known; where the motor is not `started`, a Start goes before it.
    [[nodiscard]] std::optional<Step> stepOf(const SetPoint &setPoint, bool started) const;

    /// From the motor to the set-point of its loop, as far as it is known.
    [[nodiscard]] std::optional<Step> error() const;

    /// The node told it.
    void told(std::int64_t raw);
    /// A Start is on its way; whether it is done is not known before its answer.
    void startSent() { m_startSentAt = m_position; }
    /// With the first position that is told after a Start without an answer, before told(): true when the node has counted from 0
    /// since, and the origin is another one.
    [[nodiscard]] bool mayHaveStarted(std::int64_t raw);
    void started();
    /// The node does this order now.
    void began(const SetPoint &setPoint);
    /// Somebody else may have moved it.
    void doubted();
    /// The node was stopped and counts from 0, and so do set-points.
    void zeroed();

private:
    /// Ticks between which the set-point of the loop is, as the node counts.
    struct Range {
        std::int64_t low = 0;
        std::int64_t high = 0;
        [[nodiscard]] Range with(const Range &other) const;
        [[nodiscard]] Range moved(std::int64_t ticks) const { return {low + ticks, high + ticks}; }
    };
    [[nodiscard]] std::optional<Range> after(const SetPoint &setPoint) const;

    std::int64_t m_origin = 0;
    std::optional<std::int64_t> m_position;
    std::optional<Range> m_setPoint;
    std::optional<std::int64_t> m_startSentAt; ///< as the node counted then; until its answer
    bool m_halted = false;                     ///< since m_position was told
};

} // namespace mb::supermodified
