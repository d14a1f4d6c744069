// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace mb {

/// Seconds for the whole range of a set-point from one end to the other, as they stand in the list; 0 is a step.
constexpr std::array slewTimes{0.0, 0.2, 1.0, 5.0};
constexpr int usualSlew = 2;

} // namespace mb
