// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/refinement.h"

namespace mb::tuning {

/// The winding of a motor as the steps of its current loop tell it.
struct WindingFit {
    double lag = 0.0;      ///< s, L/R
    double lagError = 0.0; ///< share of it, two standard errors
    double late = 0.0;     ///< s from an order to the first sample that shows it, on the average
    double gain = 1.0;     ///< times that of the model
    double left = 0.0;     ///< of the step, what is left over of a sample beyond its noise
};

/// Fits lag, lateness and gain of the model to all samples of the beginning of each step, as one response: orders come at any time
/// between two passes of the loop, so that a response of a step is one of many. What is little known beforehand (L/R of motors is
/// 0.2 to 1.5 ms) holds the fit where the steps tell less. Nothing where there are no steps.
[[nodiscard]] std::optional<WindingFit> fitWinding(const SteppedLoop &stepped, const PlantModel &plant);

/// The model with the lag that these steps tell; nothing where they tell it no better than it was known.
[[nodiscard]] std::optional<PlantModel> withWindingOf(const SteppedLoop &stepped, const PlantModel &plant);

} // namespace mb::tuning
