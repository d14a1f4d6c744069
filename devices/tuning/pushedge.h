// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/trial.h"

namespace mb::tuning {

/// When a push began, and when its duty was all there. Seconds of its trial.
struct Edge {
    double at = 0.0;
    double whole = 0.0;
};

/// When the order of a push was carried out: at once, unless the device's own duty shows that it came later (its frame was lost, its
/// output grows slowly) or, by the clock of the samples, sooner. A sample tells that the edge lay between it and the one before.
/// `duty` nullptr: not told. `friction`: duty that moves nothing, where it is known.
[[nodiscard]] Edge edgeOf(const Signal *duty, double ordered, double target, double friction);

/// When it ended; one whose duty falls slowly is one that ended at once, but later.
[[nodiscard]] double releaseOf(const Signal *duty, double ordered, double target);

} // namespace mb::tuning
