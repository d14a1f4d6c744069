// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/gainrules.h"
#include "tuning/metrics.h"

namespace mb::tuning {

/// What a loop would do, of the model alone. Seconds since the edge; the measured value as the device would tell it.
struct Prediction {
    Trace measured; ///< counts/s, counts or A
    Trace duty;
    Metrics metrics;
};

/// A step from `from` to `to`, held for `seconds`, with the output held within ±`mostDuty`, the integral frozen while it is, and
/// the friction of the model. `period` of the device's loop, s.
[[nodiscard]] Prediction predictStep(Mode loop, const PlantModel &plant, const ContinuousGains &gains, double from,
    double to, double seconds, double mostDuty = 1.0, double period = 0.0005);

} // namespace mb::tuning
