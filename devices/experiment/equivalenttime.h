// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/trace.h"

#include <vector>

namespace mb::tuning {

/// Seconds to wait before the edge of run `index` of `count`, so that the samples of all runs together lie `period/count`
/// apart: the first does not wait.
[[nodiscard]] double ditherOf(int index, int count, double period);

/// One response out of repeats of the same: all samples in the order of their time since each run's own edge.
[[nodiscard]] Trace merged(const std::vector<Trace> &runs);

/// Their mean at every time that one of them has, the others read between their samples: as fine as all of them together, and
/// without the jumps from one run to the other that merged() has where they differ.
[[nodiscard]] Trace averaged(const std::vector<Trace> &runs);

/// The mean of all runs in each `period` of the time since their edges, later over a `share` of that time.
[[nodiscard]] Trace meanOf(const std::vector<Trace> &runs, double period, double share = 0.0);

} // namespace mb::tuning
