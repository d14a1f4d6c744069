// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/experimentplan.h"
#include "model/device.h"
#include "model/setpointstream.h"

namespace mb::tuning {

constexpr double leastNudged = 8.0; ///< counts, of a shaft that has moved

/// Turns the shaft of a device that cannot blink a little to and fro, twice, and yields how far it went at first, in counts. Pushes
/// harder until it moves, at most with 30 % of full duty; where it does not, nothing follows. Without a duty command it is sent a short
/// way, and that is a closed loop: the check of its direction comes first, up to that way for one that holds softly, and its travel is
/// guarded. Unsafe where the check, a guard
/// or the stream ends it, and Cancelled by the interruption. The motor is told to stop before it ends.
[[nodiscard]] Task<double> nudge(
    Device &device, SetPointStream &stream, int axis, const ExperimentSurroundings &surroundings);

} // namespace mb::tuning
