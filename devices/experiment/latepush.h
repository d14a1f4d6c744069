// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/trial.h"
#include "model/device.h"

namespace mb::tuning {

/// s from the set-point of a velocity's step until P and I put out `duty`, as long as the motor stands: a weak integral overcomes friction
/// late. 0 where it does at once, and where its gains or what a raw gain puts out are not
/// known, or its duty is told anyway; five at most.
[[nodiscard]] double secondsUntilPush(const Device &device, const Trial &trial, double duty);

} // namespace mb::tuning
