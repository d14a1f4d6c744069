// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/trace.h"

#include <optional>

namespace mb::tuning {

/// The limit cycle of a position under ±d duty that changes sign where the position crosses its middle.
struct RelayCycle {
    double period = 0.0;    ///< s, median of the cycles used
    double amplitude = 0.0; ///< counts, half of what lies between its ends
    double scatter = 0.0;   ///< of the periods, over their median
    int cycles = 0;
};

/// Reads the cycles 3 to 8 of a record; nothing for fewer than three of them, or where their periods scatter by more than 10 %.
[[nodiscard]] std::optional<RelayCycle> readRelay(const Trace &position);

/// The exact cycle of K/(s(τs+1)), whatever delays or hysteresis make it: what has half the period `half`.
struct ExactCycle {
    double amplitude = 0.0; ///< counts
    double speed = 0.0;     ///< counts/s at the change of sign
};
/// `gain` counts/s per duty; `duty` and `friction` as fractions, friction below duty; `braking` as PlantModel has it.
[[nodiscard]] ExactCycle exactCycle(
    double gain, double duty, double friction, double tau, double half, double braking = 1.0);

/// τ of the motor out of a measured cycle and a known gain, s; nothing where no τ up to 20 s explains it. Reads up to 20 % low
/// with a gear that loses 40 % of its torque, where nobody knows by how much more that brakes: safe for a proportional gain.
[[nodiscard]] std::optional<double> tauFromRelay(
    const RelayCycle &cycle, double gain, double duty, double friction, double braking = 1.0);

} // namespace mb::tuning
