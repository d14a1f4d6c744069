// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <optional>

namespace mb {

/// The value axis of one strip: follows the data without jumping. It grows at once, to round numbers with some room;
/// it shrinks only when the data has left much of it empty for two seconds.
class AutoRange {
public:
    struct Range {
        double lower = -1.0;
        double upper = 1.0;
        bool operator==(const Range &other) const = default;
    };
    /// Smallest and largest value now in sight; `now` in seconds, not running backwards. Noise below `least` does not fill the
    /// strip: the range is never smaller (see leastSpan()).
    Range update(double lowest, double highest, double now, double least = 0.0);
    Range current() const { return m_range; }
    /// The next update fits at once.
    void reset();
    /// The range that update() would choose with no past.
    static Range fitted(double lowest, double highest, double least = 0.0);

private:
    Range m_range;
    bool m_set = false;
    std::optional<double> m_looseSince;
};

/// The smallest span worth looking at of such a quantity around such a value, in the unit that is shown.
double leastSpan(TraceRole role, double magnitude);

/// The largest of 1, 2, 5 × 10ⁿ that is not above `rough` (> 0).
double roundStep(double rough);

} // namespace mb
