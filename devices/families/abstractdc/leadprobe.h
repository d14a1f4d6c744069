// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

#include <cstdint>

namespace mb::abstractdc {

/// How far a target may lead its feedback while nobody knows the gains of the loop, in the unit of the target. It begins where
/// a strong loop stays within the drive's 16 bits (README.md#wraps), and grows fourfold each time that the output was read with
/// the target so far ahead and was not even at full power: a wrap is 128 times that. Where no output is read it stays. Where a gain of
/// a loop that runs is written it begins with what either value allows: once the write has failed nobody knows which is in force.
class LeadProbe {
public:
    /// Another loop, or the motor was stopped: what was seen says nothing any more.
    void reset() { *this = {}; }
    [[nodiscard]] double most() const { return m_most; }
    void limit(double most);
    /// A set-point went out, `far`: as far ahead as it may.
    void sent(bool far, Instant now);
    /// A voltage log of the loop that runs, PWM units.
    void heard(std::int32_t output, Instant time);

private:
    double m_most = 1000.0; ///< 32 units of output for one of error are within 32 000
    bool m_far = false;
    Instant m_since{}; ///< the target is as far ahead as it may be
};

} // namespace mb::abstractdc
