// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/searchtask.h"

namespace mb::tuning {

constexpr double shortestLag = 0.3e-3; ///< s, L/R of motors
constexpr double longestLag = 1.4e-3;

/// What searched() is, for a current loop: P and I with the least integral of time times error of this step, within the sensitivities of
/// `task` for every lag of 0.3 to 1.4 ms where nobody has seen that of its winding, else for the one that was seen, and hardly beyond them
/// as far as it may be off (PlantModel::lagDoubt). `start` itself where nothing is better.
[[nodiscard]] Design searchedCurrent(const PlantModel &plant, const Design &start, const SearchTask &task);

/// What errorOfSteps() is, for a current loop: of the mean motor alone.
[[nodiscard]] double errorOfCurrents(const PlantModel &plant, const ContinuousGains &gains, const SearchTask &task);

} // namespace mb::tuning
