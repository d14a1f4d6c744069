// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/productionface.h"

#include "app/sidedocks.h"

#include <QMainWindow>
#include <QStackedWidget>
#include <QStatusBar>

namespace mb {

ProductionFace::ProductionFace(QMainWindow &window, QStackedWidget &faces, QWidget &bench, SideDocks &docks)
    : QObject(&window)
    , m_window(window)
    , m_faces(faces)
    , m_bench(bench)
    , m_docks(docks)
{
    faces.addWidget(&bench);
}

bool ProductionFace::isShown() const
{
    return m_faces.currentWidget() == &m_bench;
}

void ProductionFace::show(bool on)
{
    if (on == isShown())
        return;
    m_docks.putAway(on);
    m_window.statusBar()->setVisible(!on);
    m_faces.setCurrentIndex(on ? m_faces.indexOf(&m_bench) : 0);
    m_window.setWindowState(
        on ? m_window.windowState() | Qt::WindowFullScreen : m_window.windowState() & ~Qt::WindowFullScreen);
    if (on)
        m_bench.setFocus(Qt::OtherFocusReason);
}

} // namespace mb
