// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/metrics.h"
#include "tuning/simulatedloop.h"

namespace mb::tuning {

/// What a loop would do, of the model alone. Seconds since the edge; the measured value as the device would tell it.
struct Prediction {
    Trace measured; ///< counts/s, counts or A
    Trace duty;
    Metrics metrics;   ///< its peak current where the model knows what the motor draws
    LoopShape shape{}; ///< of the loop that it is of
};

/// s, beyond which nothing is predicted: a lag without end is no reason for a prediction without end.
constexpr double longestPrediction = 60.0;

/// A step from `from` to `to`, held for `seconds` (at most longestPrediction), with the friction of the model in a loop of this shape.
[[nodiscard]] Prediction predictStep(Mode loop, const PlantModel &plant, const ContinuousGains &gains, double from,
    double to, double seconds, const LoopShape &shape);
/// In a loop of which only this is known.
[[nodiscard]] Prediction predictStep(Mode loop, const PlantModel &plant, const ContinuousGains &gains, double from,
    double to, double seconds, double mostDuty = 1.0, double period = 0.0005);

/// Sums of the error over the first `seconds` alone: a trial whose hold is as long has no more of it, and the two can be compared.
void sumOver(Prediction &prediction, Mode loop, double to, double seconds);

} // namespace mb::tuning
