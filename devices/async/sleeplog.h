// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

#include <vector>

namespace mb {

/// When the computer slept, by who looks often: time stamps stand still meanwhile, and the time of day does not.
class SleepLog {
public:
    /// `slept` is Clock::slept(). A sleep lies at the look before the one that saw it; what it was before the first look counts for all times.
    void look(Instant now, Duration slept);
    /// Clock::slept() as it was at that time.
    [[nodiscard]] Duration sleptAt(Instant time) const;

private:
    struct Sleep {
        Instant after{};
        Duration total{}; ///< slept by then
    };
    std::vector<Sleep> m_sleeps; ///< in the order of time; the first is what was before
    Instant m_lookedAt{};
};

} // namespace mb
