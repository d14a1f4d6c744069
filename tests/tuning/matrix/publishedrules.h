// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/tuning/matrix/matrixunit.h"

namespace mb::test {

/// Largest gain of P alone, and the period it swings with, of a model.
struct Ultimate {
    double gain = 0.0;
    double period = 0.0; ///< s
};
[[nodiscard]] Ultimate ultimateOf(Mode loop, const tuning::PlantModel &plant);

/// PI in a velocity loop, PID in a position loop.
[[nodiscard]] tuning::ContinuousGains zieglerNichols(Mode loop, const Ultimate &ultimate);
[[nodiscard]] tuning::ContinuousGains tyreusLuyben(Mode loop, const Ultimate &ultimate);

/// Gain and lag by least squares on differences of positions, as SysId fits them, out of the pushes that a tuning recorded; the rest
/// of the model is `known`. Nothing where the regression gives no stable motor.
[[nodiscard]] std::optional<tuning::PlantModel> regressed(
    const std::vector<tuning::Trial> &trials, const tuning::PlantModel &known);

} // namespace mb::test
