// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

namespace mb {

/// What lies beyond a nanosecond is cut off.
[[nodiscard]] constexpr Duration fromSeconds(double seconds)
{
    return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds));
}

} // namespace mb
