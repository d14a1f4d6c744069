// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

namespace mb {

/// What lies beyond a nanosecond is cut off.
[[nodiscard]] constexpr Duration fromSeconds(double seconds)
{
    return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds));
}

/// Unix time, of a Clock or whatever else has a time line and what to add to it.
template <class TimeLine> [[nodiscard]] double unixSeconds(const TimeLine &clock)
{
    return std::chrono::duration<double>(clock.now().time_since_epoch() + clock.unixOffset()).count();
}

} // namespace mb
