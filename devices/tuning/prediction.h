// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/metrics.h"
#include "tuning/simulatedloop.h"

namespace mb::tuning {

/// What a loop would do, of the model alone. Seconds since the edge; the measured value as the device would tell it.
struct Prediction {
    Trace measured; ///< counts/s, counts or A
    Trace duty;
    Metrics metrics;
    LoopShape shape{}; ///< of the loop that it is of
};

/// A step from `from` to `to`, held for `seconds`, with the friction of the model in a loop of this shape.
[[nodiscard]] Prediction predictStep(Mode loop, const PlantModel &plant, const ContinuousGains &gains, double from,
    double to, double seconds, const LoopShape &shape);
/// In a loop of which only this is known.
[[nodiscard]] Prediction predictStep(Mode loop, const PlantModel &plant, const ContinuousGains &gains, double from,
    double to, double seconds, double mostDuty = 1.0, double period = 0.0005);

} // namespace mb::tuning
