// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/experimentplan.h"

namespace mb::tuning {

/// Where the motor stands before an experiment.
struct StartPlace {
    double position = 0.0; ///< counts, as the plan counts them
    double origin = 0.0;   ///< from where its travel is counted
    double gone = 0.0;     ///< counts from there
};
/// What the plan makes of its loop. OutOfRange where that would leave the envelope, or goes nowhere.
[[nodiscard]] Result<Stimulus> stimulusWithin(
    const Family &family, const Envelope &envelope, const ExperimentPlan &plan, const StartPlace &start);

/// Where a first step of a mode goes, well inside what is known of its bounds: a number that people would choose, from `here`, counts.
/// `turn`: counts of one. Nothing where nothing bounds it.
[[nodiscard]] std::optional<double> usualTarget(
    const Family &family, Mode mode, const Envelope &known, double here, double turn);

/// Gains stay when the trial ends well; what cannot be read back, and was never written here, stays whatever happens.
[[nodiscard]] Keep usualKeep(const Family &family, std::span<const ParameterStore::Entry> entries,
    const DeviceProfile &profile, const std::vector<ParameterChange> &gains);

} // namespace mb::tuning
