// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plots/plotstrips.h"

namespace mb {

/// Gives a trace a colour or a pattern that none of the others has: `used` are their looks.
void chooseColour(TraceStyle &style, const std::vector<TraceLook> &used);

} // namespace mb
