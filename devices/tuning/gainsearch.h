// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/simulatedloop.h"

namespace mb::tuning {

/// Counts beside a target that nobody asks to be mended.
constexpr double nearTarget = 4.0;

/// What the rules of gainrules.h do not know: the step that matters, and the loop that takes it.
struct SearchTask {
    LoopBounds bounds;
    double mostMs = 1.6;
    double mostMsOff = 1.9;
    double step = 0.0;         ///< from rest, in the unit of the loop
    double overshoot = 0.0;    ///< of the step, that costs nothing
    bool isHeldToRule = false; ///< P is at most what the rule was asked for
    double setPoints
        = 0.0; ///< s between set-points of a profile, which a position loop must not answer one by one; 0: none
    ContinuousGains least; ///< that the device can have, of each gain that is not 0
    LoopShape shape;
    double quickest = 0.0; ///< s, 1/omega of a position loop that is not to be outrun; 0: none
    bool isProven = false; ///< a loop on this model was seen to do what it predicts
};

/// Gains around those of a rule that make the integral of time times error of this step smallest, on the model: what friction,
/// whole counts and the steps of an integral leave for the rule to lose. Not quicker than the rule was asked to be (P of a velocity
/// loop, natural frequency of a position loop), within the same bounds, and hardly without overshoot, also of a motor
/// that is 15 % slower than thought, or whose friction the integral carries already. `start` itself where nothing is better.
[[nodiscard]] Design searched(Mode loop, const PlantModel &plant, const Design &start, const SearchTask &task);

/// s², integral of time times error over the step, of the steps of `task` on the model alone; the search makes the mean over its doubts
/// smallest.
[[nodiscard]] double errorOfSteps(
    Mode loop, const PlantModel &plant, const ContinuousGains &gains, const SearchTask &task);

} // namespace mb::tuning
