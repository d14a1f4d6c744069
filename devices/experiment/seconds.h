// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

#include <cmath>

namespace mb::tuning {

[[nodiscard]] inline double inSeconds(Duration time)
{
    return std::chrono::duration<double>(time).count();
}
/// Nearest nanosecond.
[[nodiscard]] inline Duration ofSeconds(double seconds)
{
    return Duration(std::llround(seconds * 1e9));
}

} // namespace mb::tuning
