// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/dmc60c/simulatorparameters.h"

#include <cstdint>

/// The arithmetic of one pass of the 500 µs loop, in integers as in the device: gains are 16.16 throttle units per unit
/// of the error, the accumulator is the bare sum of errors.
namespace mb::dmc60c::simulation {

struct Gains {
    std::int32_t p = 0;
    std::int32_t i = 0;
    std::int32_t d = 0;
    std::int32_t iZone = 0; ///< bound of the accumulator, 0: none but its 32 bits
    std::int32_t f = 0;

    /// `first` is the wire number of the proportional gain.
    [[nodiscard]] static Gains of(const ParameterBank &bank, std::uint8_t first);
};

/// A slot: gains and what follows them in the table.
struct Slot {
    Gains gains;
    std::int32_t allowableError = 0;
    std::int32_t ramp = 0;
    std::int32_t forwardMax = fullDuty;
    std::int32_t reverseMax = -fullDuty - 1;
    std::int32_t forwardNominal = 0;
    std::int32_t reverseNominal = 0;

    [[nodiscard]] static Slot of(const ParameterBank &bank, int slot);
};

/// `fraction`: bits behind the point of set-point and feedback, 0 for counts, 16 for amperes.
class Pid {
public:
    void reset() { *this = Pid(); }
    /// Makes the integral term equal `throttle`.
    void preload(const Gains &gains, std::int32_t throttle, int fraction);
    /// Throttle units, before any limit.
    [[nodiscard]] std::int64_t step(
        const Gains &gains, std::int64_t setPoint, std::int64_t feedback, std::int32_t allowableError, int fraction);

private:
    std::int64_t m_sum = 0;
    std::int64_t m_lastError = 0;
    bool m_primed = false;
};

/// `duty` moved from `present` by at most `step`; 0 means at once.
[[nodiscard]] std::int32_t ramped(std::int32_t present, std::int32_t duty, std::int32_t step);
/// Nominal and maximal duty and the ramp of a slot. `outside`: the error is beyond the allowable one.
[[nodiscard]] std::int32_t shaped(const Slot &slot, std::int64_t throttle, std::int32_t present, bool outside);

/// Parameters 32…36 and 61…64: after the peak current has been exceeded for its duration the current is held at the
/// continuous limit, until the demand has been below what that allows for 50 ms.
class CurrentLimiter {
public:
    void reset();
    /// The duty allowed. `current` is 16.16 A.
    [[nodiscard]] std::int32_t step(
        const ParameterBank &bank, std::int32_t demand, std::int32_t present, std::int64_t current);
    [[nodiscard]] bool isActive() const { return m_active; }

private:
    [[nodiscard]] bool isExceeded(const ParameterBank &bank, std::int64_t magnitude);

    Pid m_pid;
    bool m_active = false;
    int m_loopsAbovePeak = 0;
    int m_loopsBelow = 0;
};

} // namespace mb::dmc60c::simulation
