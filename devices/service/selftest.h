// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/experiment.h"
#include "service/recipe.h"
#include "service/visit.h"

namespace mb::service {

/// What a self-test has measured.
struct TestFinding {
    std::vector<TestValue> values;     ///< one for each limit of the recipe, judged
    std::optional<std::int64_t> trial; ///< of the step, in the notebook
    std::optional<Error> failure;      ///< a guard, a stop, a value out of limits; nothing: it passed
    Ending ending = Ending::None;      ///< of the failure
};

/// The step of the recipe, and before it pushes of duty where a limit asks for a figure of the motor. The motor stands
/// afterwards, or the failure says that nobody has seen it stand. The stream's lease is the caller's to renew. Fails where the
/// step could not begin; OutOfRange where that would leave its limits.
[[nodiscard]] Task<TestFinding> runSelfTest(
    Device &device, SetPointStream &stream, SelfTest test, tuning::ExperimentSurroundings surroundings);

/// Against its limits.
[[nodiscard]] TestValue judged(const Acceptance &limit, std::optional<double> value);

} // namespace mb::service
