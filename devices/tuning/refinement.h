// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/trial.h"
#include "tuning/simulatedloop.h"

#include <optional>
#include <vector>

namespace mb::tuning {

/// A closed loop that was seen to step: what it had been told, and how it is made.
struct SteppedLoop {
    ContinuousGains gains;
    LoopShape shape;
    std::vector<Trial> trials; ///< steps from rest and back, all of one loop
    double mostLater = 0.0;    ///< s that the link may take, where the model's delay is without it
    bool isTried = false;      ///< by its gains alone: fitted with its link, and its full output may not be known
    double heat = 0.0;         ///< in its winding before the first of them (windingheat.h)
};

/// Heat in its winding after the last of these steps, if its motor is `plant`.
[[nodiscard]] double heatAfter(const SteppedLoop &stepped, const PlantModel &plant);

/// The motor next to `plant` with which this loop, as warm as it was, makes the steps that were measured: gain, lag, friction and delay up to a third off,
/// no further than the steps ask for. A loop that does not do what was predicted tells best where its model is wrong. Nothing where no
/// such motor explains them clearly better than `plant` does.
[[nodiscard]] std::optional<PlantModel> refinedBy(const SteppedLoop &stepped, const PlantModel &plant);

} // namespace mb::tuning
