// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/searchtask.h"

/// The search for gains of a loop on its model: around those that a rule gives, for those that leave least error.
namespace mb::tuning {

/// Counts beside a target that nobody asks to be mended.
constexpr double nearTarget = 4.0;

/// Gains around those of a rule that make the integral of time times error of this step smallest, on the model: what friction,
/// whole counts and the steps of an integral leave for the rule to lose. Not quicker than the rule was asked to be (P of a velocity
/// loop, natural frequency of a position loop), within the same bounds, and hardly without overshoot, also of a motor
/// that is 15 % slower than thought, or whose friction the integral carries already. `start` itself where nothing is better. Of steps that
/// a profile leads it is the integral of these, and hardly without overshoot also where nothing leads.
[[nodiscard]] Design searched(Mode loop, const PlantModel &plant, const Design &start, const SearchTask &task);

/// s², integral of time times error over the step, of the steps of `task` on the model alone; the search makes the mean over its doubts
/// smallest.
[[nodiscard]] double errorOfSteps(
    Mode loop, const PlantModel &plant, const ContinuousGains &gains, const SearchTask &task);

} // namespace mb::tuning
