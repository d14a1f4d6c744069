// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/windowhold.h"

#include "app/closing.h"
#include "app/mainwindow.h"
#include "app/unfinished.h"
#include "widgets/help/helpwindow.h"

#include <QApplication>

#include <algorithm>

namespace mb {
namespace {

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

bool isHeld(MainWindow &window, Workbench &workbench)
{
    const LampState lamp = window.arming().state();
    return (lamp != LampState::Safe && lamp != LampState::Stopped) || window.arming().hasMotion()
        || window.closing().isEnding() || !unfinishedIn(window, workbench).empty() || hasOtherWindows(window)
        || QGuiApplication::mouseButtons() != Qt::NoButton;
}

} // namespace mb
