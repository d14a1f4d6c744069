// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/task.h"

namespace mb {
struct Experiment;
struct Family;
} // namespace mb

namespace mb::tuning {

class AutotuneRun;

/// The family's own experiment that finds what a raw gain of its loops puts out (Experiment "gain-scales"); nullptr: it has none.
[[nodiscard]] const Experiment *scaleExperimentOf(const Family &family);

/// Runs it before a loop is tuned, with no more duty than the tuning may use, its motor watched over by the guards of the tuning's
/// limits, once its direction is checked where this run of the program has not done that. Ends with the scales in the device's profile,
/// or with the run over; Refused, Unsafe with the cause.
[[nodiscard]] Task<void> findScales(AutotuneRun &run);

} // namespace mb::tuning
