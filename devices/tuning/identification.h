// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/trial.h"
#include "tuning/plantfit.h"
#include "tuning/plantmodel.h"
#include "tuning/ramp.h"
#include "tuning/velocityfilter.h"

#include <string>
#include <vector>

namespace mb::tuning {

/// A motor as pushes of duty show it.
struct MotorFound {
    PushFit pushes;
    GainFit line;
    std::optional<VelocityFilter> filter;   ///< nothing where the device tells no velocity of its own
    double braking = 1.0;                   ///< as PlantModel::braking
    std::optional<double> restNoise;        ///< counts, σ of a quarter of a second at rest, before the first push
    std::optional<double> latency;          ///< s from the order of a push until it is seen to move; of all the median
    std::optional<RampFound> ramp;          ///< nothing where there was none, or it told nothing
    double heat = 0.0;                      ///< that the pushes have left in its winding (windingheat.h)
    PlantModel plant{};                     ///< of the loop, as it was found: before steps corrected it
    double supply = 0.0;                    ///< V at rest, which `line` is per full duty of; 0: not told
    std::string unit = "counts/s per duty"; ///< of the gain
};

/// One gate of quality: why a model may not be believed.
struct Gate {
    std::string name; ///< "fit", "friction", "asymmetric load", "resolution", "current limit"
    Message detail;   ///< with the number
    bool passed = true;
    Message remedy{};   ///< what helps where it has not passed; empty: nothing is known
    bool warns = false; ///< passed, and yet to be looked at
};

/// The pushes of trials in duty mode, each from its own edge. Trials that moved nothing give none. `friction`: duty that moves nothing,
/// where it is known; it matters where a duty grows slowly.
[[nodiscard]] std::vector<PushRecord> pushesOf(const Trial &trial, double friction = 0.0);

/// Fits what the trials recorded: pushes of two sizes, both ways. `cycle`: s between two passes of the loop that takes them, 0: not
/// known. OutOfRange where they do not tell it.
[[nodiscard]] Result<MotorFound> identify(const std::vector<Trial> &pushes, double cycle = 0.0);

/// All gates, those that passed too.
[[nodiscard]] std::vector<Gate> gatesOf(const MotorFound &found, const std::vector<Trial> &pushes);

} // namespace mb::tuning
