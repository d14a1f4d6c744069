// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/parameters/parametermodel.h"
#include "widgets/parameters/stagededits.h"

#include <vector>

namespace mb {

/// What the axes of a board have in common: the same rows, with another prefix. Axes count from 1.

/// The row of `axis` that stands for the same as this one of another axis; nothing for rows of the board.
[[nodiscard]] std::optional<ParameterIndex> twinOf(const Family &family, ParameterIndex index, int axis);
/// The gains and limits of axis `from`, staged ones before known ones, as changes of axis `to`. What is not known is left out;
/// inputs, masks and counters belong to the wiring of an axis and stay.
[[nodiscard]] std::vector<ParameterChange> gainsOfAxis(
    const Family &family, const StagedEdits &edits, int from, int to);
/// The values of `axis` beside those of every other.
[[nodiscard]] ParameterReference axisReference(const Family &family, const StagedEdits &edits, int axis);

} // namespace mb
