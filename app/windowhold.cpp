// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/windowhold.h"

#include "app/closing.h"
#include "app/mainwindow.h"
#include "widgets/common/serviceview.h"
#include "widgets/help/helpwindow.h"

#include <QApplication>

#include <algorithm>

namespace mb {
namespace {

bool isAnythingRunning(const Workbench &workbench)
{
    const auto &jobs = workbench.snapshot().operations;
    return workbench.service().running || std::ranges::any_of(jobs, [](const OperationView &job) {
        return job.status.state == OperationStatus::State::Running;
    });
}

bool hasOtherWindows(const MainWindow &window)
{
    const QWidgetList all = QApplication::topLevelWidgets();
    return std::ranges::any_of(all, [&window](const QWidget *other) {
        const Qt::WindowType type = other->windowType();
        return other != &window && other->isVisible() && !qobject_cast<const HelpWindow *>(other)
            && (type == Qt::Window || type == Qt::Dialog || type == Qt::Popup);
    });
}

} // namespace

bool isHeld(MainWindow &window, const Workbench &workbench)
{
    const LampState lamp = window.arming().state();
    return (lamp != LampState::Safe && lamp != LampState::Stopped) || window.arming().hasMotion()
        || window.closing().isEnding() || isAnythingRunning(workbench) || hasOtherWindows(window)
        || QGuiApplication::mouseButtons() != Qt::NoButton;
}

} // namespace mb
