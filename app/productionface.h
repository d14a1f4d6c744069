// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <vector>

class QDockWidget;
class QMainWindow;
class QStackedWidget;
class QWidget;

namespace mb {

/// The window in production: full screen, nothing but its header and the bench; and back as it was. GUI thread.
class ProductionFace : public QObject {
    Q_OBJECT
public:
    /// `faces` is the middle of the window with its pages; the bench is added to it.
    ProductionFace(QMainWindow &window, QStackedWidget &faces, QWidget &bench, std::vector<QDockWidget *> docks);
    void show(bool on);
    [[nodiscard]] bool isShown() const;

private:
    QMainWindow &m_window;
    QStackedWidget &m_faces;
    QWidget &m_bench;
    std::vector<QDockWidget *> m_docks;
    std::vector<QDockWidget *> m_hidden; ///< that were there before
};

} // namespace mb
