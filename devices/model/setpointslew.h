// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

namespace mb {

/// The limit of this program on how fast a set-point may change (docs/names.md#set-points-by-hand), whatever is typed. A value; the caller brings the time.
class SetPointSlew {
public:
    /// Largest change per second; 0 jumps.
    void setRate(double rate) { m_rate = rate; }
    /// From where the motor is, so that the first command never makes it jump.
    void start(double present, Instant now);
    void setTarget(double target) { m_target = target; }
    /// Goes on from here: the time until now does not count.
    void resume(Instant now) { m_at = now; }
    /// The set-point for `now`; times do not run backwards.
    double advance(Instant now);

    [[nodiscard]] double value() const { return m_value; }
    [[nodiscard]] double target() const { return m_target; }
    [[nodiscard]] bool isThere() const { return m_value == m_target; }

private:
    double m_rate = 0.0;
    double m_value = 0.0;
    double m_target = 0.0;
    Instant m_at{};
};

} // namespace mb
