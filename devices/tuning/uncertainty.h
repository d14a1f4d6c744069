// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/prediction.h"
#include "tuning/tunereport.h"

namespace mb::tuning {

/// ± of a model, two standard errors each.
struct PlantErrors {
    double gain = 0.0;
    double tau = 0.0;
    double delay = 0.0;
    double friction = 0.0;
    double leastTau = 0.0; ///< s: no motor has less, whatever the error

    friend bool operator==(const PlantErrors &, const PlantErrors &) = default;
};
/// Of the model that a tuning stands on: of its identification, or as much as steps have corrected it since; nothing where there was none.
[[nodiscard]] PlantErrors errorsOf(const TuneReport &report);

/// Between what a predicted step may lie: lowest and highest at the times of the prediction.
struct PredictionBand {
    Trace low;
    Trace high;
};

/// Where `predicted` would be if gain, tau and delay were off by their errors, each way and together: the envelope of all corners.
/// Of a step from 0 to `to`, as predictStep(). Pure.
[[nodiscard]] PredictionBand bandOf(const Prediction &predicted, Mode loop, const PlantModel &plant,
    const PlantErrors &errors, const ContinuousGains &gains, double to, double mostDuty = 1.0, double period = 0.0005);

} // namespace mb::tuning
