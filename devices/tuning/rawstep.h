// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/experimentplan.h"
#include "model/device.h"

#include <optional>

namespace mb::tuning {

class AutotuneRun;

/// Of a position loop, as the unit stores them.
struct RawGains {
    double p = 0.0;
    double d = 0.0;
};

/// A step of so many counts from where it stands, with these gains and no I in force while it lasts.
[[nodiscard]] ExperimentPlan rawStep(const AutotuneRun &run, RawGains gains, double counts, double seconds);

/// The unit's own profile leads to the targets of the plan, at this rate from the first passes of its loop on; 0: as it is.
void leadByProfile(const AutotuneRun &run, double rate, ExperimentPlan &plan);

/// The motor is not where the last experiment began, which counted from there.
[[nodiscard]] bool hasGone(const AutotuneRun &run);

/// What a device tells of its current, of those samples that come while it is driven. A, where it has a scale.
class DrawnCurrent {
public:
    explicit DrawnCurrent(const AutotuneRun &run);
    [[nodiscard]] double most() const { return m_most; }
    [[nodiscard]] double last() const { return m_last; }

private:
    double m_most = 0.0;
    double m_last = 0.0;
    std::optional<ChannelIndex> m_channel;
    Subscription m_subscription;
};

} // namespace mb::tuning
