// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/settings.h"
#include "widgets/common/selection.h"
#include "widgets/common/theme.h"
#include "widgets/common/workbench.h"

#include <vector>

class QDockWidget;
class QMainWindow;

namespace mb {

class DeviceTree;
class PageKeys;

/// What stands at the sides of the pages and can be closed: the devices at the left, the inspector of the selected one at the right.
/// Where that would leave a page with too little they come over it when they are asked for, and go with the next press in the page.
/// Lives as long as its window. GUI thread.
class SideDocks : public QObject {
    Q_OBJECT
public:
    SideDocks(
        Workbench &workbench, Selection &selection, const ThemeSource &theme, Settings &settings, QMainWindow &window);

    [[nodiscard]] DeviceTree &devices() { return *m_tree; }
    /// Brings the devices back; seen while they are away.
    [[nodiscard]] QWidget *makeButton(QWidget *parent);
    /// F9 and F10, into the table of the window.
    void addTo(PageKeys &keys);
    /// Nothing stands beside the middle of the window, whatever happens, until what stood there is brought back.
    void putAway(bool away);
    /// Shows the inspector on the overview, where there is room for it, and hides it elsewhere. F10 is respected until that changes.
    void follow(bool overview);

Q_SIGNALS:
    void overlaidChanged();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void buildDevices();
    void forgetLink(const QString &address);
    void buildInspector(Selection &selection, const ThemeSource &theme);
    void flip(QDockWidget &dock);
    void layOver();
    void setOverlaid(bool overlaid);
    QDockWidget *addDock(const QString &name, const QString &title, QWidget *content, Qt::DockWidgetArea area);

    Workbench &m_workbench;
    const ThemeSource &m_theme;
    Settings &m_settings;
    QMainWindow &m_window;
    DeviceTree *m_tree = nullptr;
    QDockWidget *m_devices = nullptr;
    QDockWidget *m_inspector = nullptr;
    bool m_away = false;
    std::vector<QDockWidget *> m_before; ///< that stood there before they were put away
    bool m_useful = false;               ///< the inspector
    bool m_room = false;
    bool m_overlaid = false;
    bool m_hadDevices = true; ///< beside the pages, before they came over them
    int m_width = 0;          ///< of the devices while there is room for all, in pixels
};

} // namespace mb
