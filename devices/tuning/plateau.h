// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/trial.h"
#include "tuning/prediction.h"

#include <optional>
#include <vector>

namespace mb::tuning {

/// As metrics.h has it, of the holds of velocity trials, the worst of them.
[[nodiscard]] std::optional<double> settledWidely(const std::vector<Trial> &trials);

/// σ of what is measured about its own line while it should rest, of the step: the second half of each hold, or where a motor that friction
/// has kept waiting settles later what is left then, a quarter at least; the worst of them.
[[nodiscard]] double swingOf(const Trial &trial);
[[nodiscard]] double swingOf(const Prediction &predicted, double step);

/// Empty where a position that nothing but friction holds at its end rests there, within `counts`; else that it does not: a light rotor
/// swings in the play before its load, quicker than it is seen.
[[nodiscard]] Message judgePlace(const Trial &trial, double counts);

/// Empty where a loop rests as it was predicted to; else how it swings. A loop whose sensor stands on one side of a play that its load
/// is on the other side of may do so for as long as it is driven, and its edges and averages hardly show it.
[[nodiscard]] Message judgeRest(double measured, const Prediction &predicted, double step);

} // namespace mb::tuning
