// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/gainscale.h"
#include "tuning/trial.h"

#include <string>
#include <vector>

namespace mb::tuning {

/// How large a step proves a loop: clear of noise and friction, and within duty and envelope. In the unit of the loop.
[[nodiscard]] double proofStep(
    Mode loop, const PlantModel &plant, const ContinuousGains &gains, const Envelope &envelope);

/// The device has a least output that overcomes friction, and an error that is good enough.
[[nodiscard]] bool hasFrictionHelp(const Family &family);
/// Adds the least output that overcomes friction, and the error that is good enough, where the slot has them: a position loop
/// without I comes to rest before its target otherwise.
void addFrictionHelp(const Family &family, int axis, int slot, const PlantModel &plant, ScaledGains &into);

/// Of each metric the worse of the trials; nothing where one of them has none.
[[nodiscard]] Metrics worseOf(const std::vector<Trial> &trials);

/// The error at rest that this loop leaves, in the unit of the loop: where friction holds P, and below what moves the integral.
[[nodiscard]] double restingError(const Family &family, const PlantModel &plant, const ContinuousGains &gains);

/// Empty when a proof did what was predicted; else what it did instead, with the numbers. `resting` error in the unit of the step.
[[nodiscard]] std::string judgeProof(const Metrics &measured, const Metrics &predicted, double step, double resting);

} // namespace mb::tuning
