// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/plantmodel.h"

/// What pushes and steps leave in a winding, in squares of duty: one push of full duty and the brake after it leave 1, wherever the motor
/// takes little of it for its friction.
namespace mb::tuning {

/// Of a winding that warms, R grows by 0.39 % a kelvin and the magnets lose 0.2 %: the lag goes with R/k², the speed with 1/k. The share
/// of the one that the other grows by.
constexpr double speedOfWarming = 0.25;
constexpr double heatThatStays = 0.95; ///< until the next push or step

/// The motor of a model, which is of the cold one, with so much of it.
[[nodiscard]] inline PlantModel warmed(PlantModel plant, double heat)
{
    plant.tau *= 1.0 + plant.warming * heat;
    plant.gain *= 1.0 + speedOfWarming * plant.warming * heat;
    return plant;
}

/// What `seconds` of a duty at a speed (counts/s) add: what is neither turned into speed nor given back is the current's.
[[nodiscard]] inline double heatOf(const PlantModel &plant, double duty, double speed, double seconds)
{
    const double beyond = duty - speed / plant.gain;
    return beyond * beyond * seconds / plant.tau;
}

} // namespace mb::tuning
