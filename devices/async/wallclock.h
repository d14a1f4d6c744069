// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/sleeplog.h"

namespace mb {

/// Time stamps as Unix time, those of before and of after the computer slept.
struct WallClock {
    Duration offset{}; ///< what to add to a time stamp to get Unix time, but for what the computer has slept
    SleepLog sleeps;

    /// What to add to this time stamp.
    [[nodiscard]] Duration shiftAt(Instant time) const { return offset + sleeps.sleptAt(time); }
    [[nodiscard]] Duration unixTime(Instant time) const { return time.time_since_epoch() + shiftAt(time); }
};

} // namespace mb
