// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QMainWindow;
class QStackedWidget;
class QWidget;

namespace mb {

class SideDocks;

/// The window in production: full screen, nothing but its header and the bench; and back as it was. GUI thread.
class ProductionFace : public QObject {
    Q_OBJECT
public:
    /// `faces` is the middle of the window with its pages; the bench is added to it.
    ProductionFace(QMainWindow &window, QStackedWidget &faces, QWidget &bench, SideDocks &docks);
    void show(bool on);
    [[nodiscard]] bool isShown() const;

private:
    QMainWindow &m_window;
    QStackedWidget &m_faces;
    QWidget &m_bench;
    SideDocks &m_docks;
};

} // namespace mb
