// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/tuning/matrix/stepprobe.h"

namespace mb::test {

struct BestGains {
    tuning::ContinuousGains gains;
    ShaftResponse response;
};

/// The gains with the least ITAE on the unit itself, of those within the bounds of every proposal: sensitivity of the true linear
/// model at most 1.7, and 1.9 with 20 % more gain and 30 % more delay, overshoot at most 5 %, no more current than is allowed, one count at most 10 % of duty
/// through D, the step at most three full duties through P, natural frequency of a position loop at most twice that of its set-points. PI in a loop of velocity or current; PD or PID in a position loop, as the family's proposals have it. `also` is written with
/// each (friction help). A grid is looked at from the first of the phases, its best from three, and the best of these, with what lies beside
/// it, from all, over which their means are the least. The best few, the best first; empty where none is within the bounds from each.
/// What is chosen by its luck has had some: the mean over other phases tells what it is worth.
[[nodiscard]] std::vector<BestGains> bruteForce(StepProbe &probe, const Cell &cell, const tuning::PlantModel &truth,
    const std::vector<ParameterChange> &also, const std::vector<StepPhase> &phases);

/// Within the bounds that a step shows.
[[nodiscard]] bool isWithinBounds(const StepProbe &probe, const ShaftResponse &response);

/// Within the bounds that do not need a step.
[[nodiscard]] bool isWithinBounds(
    const Cell &cell, const tuning::PlantModel &truth, const tuning::ContinuousGains &gains, double step);

} // namespace mb::test
