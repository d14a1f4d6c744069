// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/loadrecording.h"
#include "widgets/plots/plotstack.h"

namespace mb {

/// Fills an empty stack with a recording: a trace for each channel that has samples, a strip for each unit, its clock, its
/// watermark, and all of it in view. Yields the numbers of the traces by channel; -1 for one without samples. GUI thread.
std::vector<int> showRecording(PlotStack &stack, const LoadedRecording &recording);

} // namespace mb
