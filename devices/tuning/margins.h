// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/setpoint.h"
#include "tuning/plantmodel.h"

#include <complex>

namespace mb::tuning {

/// How far a loop is from swinging.
struct Margins {
    double ms = 0.0;        ///< largest sensitivity; infinite for an unstable loop
    double gain = 0.0;      ///< factor that the gain may grow by
    double phase = 0.0;     ///< degrees
    double crossover = 0.0; ///< rad/s
    double turnover = 0.0;  ///< rad/s, with which it would swing with so much more gain; 0: with none
    [[nodiscard]] bool isStable() const { return gain > 1.0 && phase > 0.0; }
};

/// Of the open loop, rad/s.
[[nodiscard]] std::complex<double> openLoop(
    Mode loop, const PlantModel &plant, const ContinuousGains &gains, double omega);
/// `points` a decade: 400 are exact to a thousandth, 30 to a hundredth.
[[nodiscard]] Margins marginsOf(Mode loop, const PlantModel &plant, const ContinuousGains &gains, int points = 400);

} // namespace mb::tuning
