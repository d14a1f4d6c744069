// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/pushfit.h"

#include <optional>

namespace mb::tuning {

/// s, the lag of the same pushes by the usual regression of one mean speed on the one before, the duty and the sign: less exact than
/// fitPushes(), and by another way. Nothing where the lag is too short for it, or too few counts make a mean speed.
[[nodiscard]] std::optional<double> lagByRegression(std::span<const PushRecord> records, const PushFit &fit);

} // namespace mb::tuning
