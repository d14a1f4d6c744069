// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/mainwindow.h"
#include "app/tourscript.h"
#include "model/family.h"

#include <QTemporaryDir>

namespace mb {

class QueueBoard;
struct QueueLine;

/// What the tour sees of service: values that wait for somebody to keep them, a queue of units, the verdict in production, the
/// journal. The script outlives this. GUI thread.
class ServiceTour : public QObject {
    Q_OBJECT
public:
    ServiceTour(Workbench &workbench, MainWindow &window, TourScript &script, QObject *parent);

    void planKeeping();
    void planQueue();
    void planProduction();
    void planFail();
    void planJournal();

private:
    [[nodiscard]] const DeviceView *unit(int DemoUnits::*which) const;
    [[nodiscard]] QString image() const;
    [[nodiscard]] QueueBoard &board() const;
    [[nodiscard]] bool isOver() const;
    void loosen();
    void enterProduction();
    void beginStrict();
    [[nodiscard]] const QueueLine *strictLine() const;
    void showVerdict(const QString &name);

    Workbench &m_workbench;
    MainWindow &m_window;
    TourScript &m_tour;
    QTemporaryDir m_folder; ///< of the recipe that a unit fails
};

} // namespace mb
