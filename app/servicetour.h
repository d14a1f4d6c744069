// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/mainwindow.h"
#include "app/tourscript.h"
#include "model/family.h"

namespace mb {

class QueueBoard;

/// What the tour sees of service: values that wait for somebody to keep them, a queue of units, the verdict in production, the
/// journal. The script outlives this. GUI thread.
class ServiceTour : public QObject {
    Q_OBJECT
public:
    ServiceTour(Workbench &workbench, MainWindow &window, TourScript &script, QObject *parent);

    void planKeeping();
    void planQueue();
    void planProduction();
    void planJournal();

private:
    [[nodiscard]] const DeviceView *unit(int DemoUnits::*which) const;
    [[nodiscard]] QString image() const;
    [[nodiscard]] QueueBoard &board() const;
    [[nodiscard]] bool isOver() const;
    void loosen();
    void enterProduction();

    Workbench &m_workbench;
    MainWindow &m_window;
    TourScript &m_tour;
};

} // namespace mb
