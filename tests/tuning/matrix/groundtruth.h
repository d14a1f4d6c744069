// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/tuning/matrix/matrixunit.h"

namespace mb::test {

/// What a linear model of a cell's motor and loop is: of the motor's own figures, not of anything measured. Dead time as
/// the rules count it: half the window of the velocity, one and a half periods of the loop, L/R.
[[nodiscard]] tuning::PlantModel groundTruth(const Cell &cell, double speed);

} // namespace mb::test
