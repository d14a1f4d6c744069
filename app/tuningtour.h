// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/tourstage.h"

namespace mb {

/// What the tour sees of tuning: a loop as it was found and after one change, over each other; then one press of the page Design, and
/// the same step once more. The stage outlives this. GUI thread.
class TuningTour {
public:
    explicit TuningTour(TourStage &stage)
        : m_stage(stage)
    {
    }
    void plan();

private:
    void planTrials();
    void planDesign();
    void planTrial(const char *name, double p, double i, bool second);
    void arm();
    void tryGains(double p, double i);
    [[nodiscard]] double overshoot();
    [[nodiscard]] const DeviceView *unit() const { return m_stage.device(&DemoUnits::overshooting); }

    TourStage &m_stage;
    double m_found = 0.0; ///< overshoot as it was found, share of its step
};

} // namespace mb
