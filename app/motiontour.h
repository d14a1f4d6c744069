// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/tourstage.h"

namespace mb {

class PlotsPage;

/// What the tour sees of a motor that is driven by hand: the live view, every state of the plots, the bus. The stage outlives this.
/// GUI thread.
class MotionTour {
    Q_DECLARE_TR_FUNCTIONS(mb::MotionTour)
public:
    explicit MotionTour(TourStage &stage)
        : m_stage(stage)
    {
    }
    void plan();

private:
    void planStep();
    void planCursors();
    void planTrigger();
    void planViews();
    void onPlots(const char *name, std::function<void(PlotsPage &)> act);
    void show(PageId page, const char *name, std::chrono::milliseconds time);
    void addSignals(PlotsPage &page);
    void drive();
    [[nodiscard]] bool comesToSpeed();
    [[nodiscard]] const DeviceView *unit() const { return m_stage.device(&DemoUnits::tuned); }

    TourStage &m_stage;
    Instant m_drivenAt{};
};

} // namespace mb
