// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace mb::supermodified {

/// A profiled move that may pass its target (README.md#passed-target). All in ticks, as the node counts.
class ProfiledRun {
public:
    /// `overrun`: behind the target, from which the move has gone wrong.
    ProfiledRun(double from, double target, double overrun)
        : m_target(target)
        , m_direction(target < from ? -1.0 : 1.0)
        , m_overrun(overrun)
    {
    }
    [[nodiscard]] bool hasPassed(double position) const { return (position - m_target) * m_direction > m_overrun; }

private:
    double m_target;
    double m_direction;
    double m_overrun;
};

} // namespace mb::supermodified
