// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/tourstage.h"

#include <QTemporaryDir>

namespace mb {

class QueueBoard;
struct QueueLine;

/// What the tour sees of service: values that wait for somebody to keep them, a queue of units, the verdict in production, the
/// journal. The stage outlives this. GUI thread.
class ServiceTour {
public:
    explicit ServiceTour(TourStage &stage)
        : m_stage(stage)
    {
    }

    void planKeeping();
    void planQueue();
    void planProduction();
    void planFail();
    void planJournal();

private:
    [[nodiscard]] const DeviceView *unit() const { return m_stage.device(&DemoUnits::tuned); }
    [[nodiscard]] QueueBoard &board() const;
    [[nodiscard]] bool isOver() const;
    void loosen();
    void enterProduction();
    void beginStrict();
    [[nodiscard]] const QueueLine *strictLine() const;
    void showVerdict(const char *name);

    TourStage &m_stage;
    QTemporaryDir m_folder; ///< of the recipe that a unit fails
};

} // namespace mb
