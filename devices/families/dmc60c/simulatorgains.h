// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/dmc60c/simulatoroptions.h"

namespace mb::dmc60c::simulation {

/// Writes what a tuned axis would have stored, by the rules of tuning for this motor, load and velocity window: SIMC PI
/// for velocity in slot 0, critically damped PD for position in slot 1. `Overshoot` is a velocity loop about 20 % too
/// lively.
void storeGains(
    ParameterBank &bank, StoredGains kind, const MotorParameters &motor, double load, VelocityWindow window);

} // namespace mb::dmc60c::simulation
