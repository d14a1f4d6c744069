// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/trial.h"
#include "tuning/pushfit.h"

#include <optional>
#include <vector>

namespace mb::tuning {

/// How a push ended: the motor rolled on with no duty, its windings shorted, and came to rest.
struct RollOut {
    double speed = 0.0;    ///< counts/s when the duty ended, without its sign
    double distance = 0.0; ///< counts from there to rest
};

/// Of the pushes of a trial in duty mode whose rest was seen. `friction`: duty that moves nothing.
[[nodiscard]] std::vector<RollOut> rollOutsOf(const Trial &trial, const PushFit &fit, double friction);

/// How many times as strongly a current brakes this motor as it drives it: a gear that loses torque loses it both ways, so that the
/// motor stops sooner than it starts. 1 where nothing is lost; median of the roll-outs. `friction` counts/s, what it takes of every final
/// speed. Nothing without roll-outs, or where they are longer than those of a motor that loses nothing (its windings were open).
[[nodiscard]] std::optional<double> brakingOf(const std::vector<RollOut> &rolls, double tau, double friction);

} // namespace mb::tuning
