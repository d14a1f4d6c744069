// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/experiment.h"

namespace mb::service {

/// What pushes of duty tell of a motor; what is empty could not be found out.
struct MotorFigures {
    std::optional<double> resistance;   ///< Ω, of motor, leads and bridge; needs a current and a bus voltage
    std::optional<double> friction;     ///< V, duty where the unit tells no bus voltage
    std::optional<double> gain;         ///< counts/s per V, or per full duty
    bool encoder = false;               ///< it counted with the duty, both ways
    std::optional<tuning::Trial> ended; ///< the push that did not end by itself: a guard, a stop
};

/// Pushes of two sizes both ways, each from standstill, as long as the motor needs (at most 1 s), within the limits.
/// Fails where nothing has moved.
[[nodiscard]] Task<MotorFigures> measureMotor(Device &device, SetPointStream &stream, int axis, int slot,
    Envelope limits, tuning::ExperimentSurroundings surroundings);

} // namespace mb::service
