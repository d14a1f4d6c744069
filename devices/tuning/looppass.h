// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/identification.h"

namespace mb {
struct Family;
} // namespace mb

namespace mb::tuning {

/// s between two passes of the loop of a device that tells its velocity anew at each of them, as the rises and falls of a velocity
/// step show it. Nothing where they show too few.
[[nodiscard]] std::optional<double> passOf(const Trial &trial);

/// The pass that a family counts on, against the one that was seen. Nothing where the family does not tell it, or nothing was seen.
[[nodiscard]] std::optional<Gate> passGate(const Family &family, const Trial &trial);

} // namespace mb::tuning
