// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/tuning/matrix/matrixunit.h"

namespace mb::test {

/// What a linear model of a cell's motor and loop is: of the motor's own figures, not of anything measured. Dead time as
/// the rules count it: half the window of the velocity, one and a half periods of the loop, L/R. Of a current loop the winding itself: gain
/// 1/R of the supply, lag L/R.
[[nodiscard]] tuning::PlantModel groundTruth(const Cell &cell, double speed);

/// What raw gains of its loop make, as its firmware has it, where they are not scaled by a law that the family tells (Supermodified, each
/// dialect); nothing elsewhere.
[[nodiscard]] std::optional<tuning::TriedScale> trueScale(const Cell &cell);

/// Of a rotor turn, as the unit counts them (a Supermodified has its encoder on the output).
[[nodiscard]] double countsOfTurn(const Cell &cell);

/// s between two passes of its loop.
[[nodiscard]] double cycleOf(const Cell &cell);

} // namespace mb::test
