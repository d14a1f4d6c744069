// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/reportunit.h"

namespace mb {

/// What the motor answered to sines of duty, beside its model, each with its coherence. Empty where none were made, or no model tells how
/// sluggish the motor is.
[[nodiscard]] QString sweepHtml(const ReportUnit &unit);

} // namespace mb
