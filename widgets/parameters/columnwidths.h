// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/parameters/parameterdelegate.h"

#include <array>

namespace mb {

/// Pixels of every column; 0 hides it.
using ColumnWidths = std::array<int, ParameterModel::ColumnCount>;

/// Numbers get what they need, states what an unedited row says; names and keys share the rest and end in "…" where it is
/// too little, and what is left then goes to what a state was before an edit. Where
/// even their least width does not fit, the columns raw, key and reference go, in this order; the tooltip and the line
/// below the table have them.
[[nodiscard]] ColumnWidths columnWidthsFor(
    const ParameterModel &model, const ParameterDelegate &delegate, const Theme &theme, const QFont &body, int room);

} // namespace mb
