// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sidedock.h"

#include <QDockWidget>

namespace mb {

QDockWidget *makeSideDock(
    QMainWindow &window, const QString &name, const QString &title, QWidget *content, Qt::DockWidgetArea area)
{
    auto *dock = new QDockWidget(title, &window);
    dock->setObjectName(name);
    dock->setTitleBarWidget(new QWidget(dock)); // the content has its own head
    dock->setWidget(content);
    content->setMinimumSize(1, 1); // on a small screen it is cut before the Arm button and STOP are
    dock->setFeatures(QDockWidget::DockWidgetClosable);
    window.addDockWidget(area, dock);
    return dock;
}

} // namespace mb
