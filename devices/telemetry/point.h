// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

#include <cmath>
#include <limits>

namespace mb {

/// A sample, or a break of the line where the value is not a number.
struct Point {
    Instant time{};
    double value = std::numeric_limits<double>::quiet_NaN();

    [[nodiscard]] bool isGap() const { return std::isnan(value); }
};

} // namespace mb
