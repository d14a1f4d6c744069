// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/trial.h"
#include "tuning/pushfit.h"

namespace mb::tuning {

/// When a push began, and when its duty was all there. Seconds of its trial.
struct Edge {
    double at = 0.0;
    double whole = 0.0;
    std::vector<DutyStep> steps{}; ///< in which it came, s from `at`, where they are known
};

/// When a push of `trial` that was ordered then was carried out: at once, unless the device's own duty shows that it came later (its
/// frame was lost, its output grows slowly) or, by the clock of the samples, sooner. A sample tells that the edge lay between it and the
/// one before; where the program itself leads the set-point there in steps, each of which holds until the next, those tell it exactly.
/// At once where no duty is told. `friction`: duty that moves nothing, where it is known.
[[nodiscard]] Edge edgeOf(const Trial &trial, double ordered, double friction);

/// When it ended; one whose duty falls slowly is one that ended at once, but later.
[[nodiscard]] double releaseOf(const Trial &trial, double ordered);

} // namespace mb::tuning
