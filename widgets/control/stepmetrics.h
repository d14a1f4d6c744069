// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/history.h"

#include <optional>
#include <span>

namespace mb {

/// What a step response says (tuning.md 3.11). Fractions are of the height of the step; times from its beginning.
struct StepMetrics {
    bool moved = false;                ///< at least 5 % of the way; without it there are no other numbers
    bool unsteady = false;             ///< it still swings at the end: no other numbers either
    std::optional<double> overshoot;   ///< fraction; 0 when it is within the noise
    std::optional<double> rise;        ///< seconds from 10 to 90 % of the final value
    std::optional<double> settle;      ///< seconds until it stays within the band
    std::optional<double> steadyError; ///< 1 − final value: a loop may settle nicely in the wrong place
    double band = 0.02;                ///< of settling: wider than 2 % where the noise is
    double noise = 0.0;                ///< σ of the tail, fraction
    Instant peakAt{};
    double peak = 0.0; ///< in units of the samples
};

/// `samples` from a little before `start` to the end of what counts, in order of time, without gaps in it (points that are
/// not numbers are skipped). `from` is what was measured before, or nothing to take the median of what lies before `start`.
[[nodiscard]] StepMetrics measureStep(
    std::span<const Point> samples, Instant start, std::optional<double> from, double target);

} // namespace mb
