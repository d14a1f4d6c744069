// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>

class QDockWidget;

namespace mb {

/// A part at a side of the window that can be closed, with a head of its own.
[[nodiscard]] QDockWidget *makeSideDock(
    QMainWindow &window, const QString &name, const QString &title, QWidget *content, Qt::DockWidgetArea area);

} // namespace mb
