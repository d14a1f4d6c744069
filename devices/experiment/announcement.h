// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/experimentplan.h"

namespace mb::tuning {

/// What a stimulus may make of a motor at most: what is expected of it, and never more than its guards allow.
struct Extent {
    double duty = 1.0;            ///< of full
    std::optional<double> speed;  ///< counts/s; nothing: neither known nor bounded
    std::optional<double> travel; ///< counts from where it stands
};

/// `gain` of the motor, counts/s per duty at most; 0: not known, and its guards alone are the bound. `lag`: s in which it stops, where
/// that is known. Its travel is counted from `origin`, `gone` counts from which it stands.
[[nodiscard]] Extent extentOf(
    const ExperimentPlan &plan, const Trial &trial, double origin, double gain, double lag = 0.0, double gone = 0.0);

/// Of whatever stays within these bounds, where nothing more is known of it.
[[nodiscard]] Extent extentOf(const Envelope &bounds);

/// In a sentence, rounded up to two figures; a speed that is not known is named, too.
[[nodiscard]] Message textOf(const Extent &extent);

/// Says it before the motor moves; what the check of its direction may make of it, where that comes first, too, and a limit of current that was given and
/// that nobody can hold.
void announce(const Device &device, const ExperimentSurroundings &surroundings, const ExperimentPlan &plan,
    const Trial &trial, double origin, double gone);

} // namespace mb::tuning
