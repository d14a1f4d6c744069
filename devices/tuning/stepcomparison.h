// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/trial.h"
#include "tuning/simulatedloop.h"

#include <vector>

namespace mb::tuning {

/// Two sets of gains by what was measured of their steps, over what both have: integral of time times error, of a velocity that an exact
/// integral brings to its target and of a position beyond what can be told and what is near enough; of currents the means of all steps.
[[nodiscard]] double errorRatio(
    const std::vector<Trial> &now, const std::vector<Trial> &before, const LoopShape &shape);

/// `now` leaves less error than so many times that of `before`, as far as noise lets that be told. The loop's shape is one of both.
[[nodiscard]] bool isBetter(
    const std::vector<Trial> &now, const std::vector<Trial> &before, const LoopShape &shape, double times = 1.0);

} // namespace mb::tuning
