// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/simulatedloop.h"

#include <algorithm>

namespace mb::tuning {

/// What the rules of gainrules.h do not know: the step that matters, and the loop that takes it.
struct SearchTask {
    LoopBounds bounds;
    double mostMs = 1.6;
    double mostMsOff = 1.9;
    double step = 0.0;         ///< from rest, in the unit of the loop
    double overshoot = 0.0;    ///< of the step, that costs nothing
    bool isHeldToRule = false; ///< P is at most what the rule was asked for
    double setPoints
        = 0.0; ///< s between set-points of a hand, which a position loop must not answer one by one; 0: none
    ContinuousGains least; ///< that the device can have, of each gain that is not 0
    LoopShape shape;
    double quickest = 0.0; ///< s, 1/omega of a position loop that is not to be outrun; 0: none
    bool isProven = false; ///< a loop on this model was seen to do what it predicts
    double steepest
        = 0.0; ///< counts/s² per duty at the start of a push, at least, wherever a margin is looked at: pushes tell it better
               ///< than what corrected the model; 0: as the model has it
};

/// The motor whose margins are held.
[[nodiscard]] inline PlantModel atLeastAsSteep(PlantModel plant, double steepest)
{
    if (steepest > 0.0)
        plant.tau = std::min(plant.tau, plant.gain / steepest);
    return plant;
}

} // namespace mb::tuning
