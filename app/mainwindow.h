// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/pageid.h"
#include "app/settings.h"
#include "widgets/common/selection.h"
#include "widgets/common/theme.h"
#include "widgets/common/workbench.h"
#include "widgets/control/arming.h"

#include <QMainWindow>

#include <functional>
#include <vector>

class QDockWidget;
class QLabel;
class QStackedWidget;

namespace mb {

class BannerStack;
class Closing;
class Conditions;
class DemoStripe;
class DeviceLine;
class HeaderBar;
class HelpDesk;
class LiveStateBar;
class PageKeys;
class PageTabs;
class ProductionFace;
class ServiceDesk;
class StationLamp;
class WindowMenu;

/// The one window: header with links, lamp and STOP; devices at the left; pages; inspector at the right; status bar.
/// Composes, decides nothing about devices.
class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    MainWindow(Workbench &workbench, ThemeSource &theme, Settings &settings, QWidget *parent = nullptr);
    ~MainWindow() override;

    [[nodiscard]] Arming &arming() { return *m_arming; }
    [[nodiscard]] Selection &selection() { return m_selection; }
    [[nodiscard]] HelpDesk &help() { return *m_help; }
    [[nodiscard]] BannerStack &banners() { return *m_banners; }
    /// Pages are made when they are asked for first, the others once the window has been painted.
    [[nodiscard]] QWidget *page(PageId id);
    void showPage(PageId id);
    [[nodiscard]] PageId shownPage() const;
    /// Puts it above the pages, below what is said of the device; the window owns it from now on.
    void addAbovePages(QWidget &strip);
    /// Production (F11), the queue of the page Firmware and the journal are there with it. Before a page is made. The desk outlives
    /// the window.
    void setService(ServiceDesk &desk);
    [[nodiscard]] ProductionFace *production() const { return m_production; }
    /// A recording, as the menu opens it.
    void openFile(const QString &path);
    /// Every key, in a window of its own.
    void listKeys();

Q_SIGNALS:
    void pageMade(mb::PageId id, QWidget *page);
    /// Somebody wants another language, theme or size: they are in the settings.
    void lookChosen();
    /// The machine is to be saved into a folder, or opened from one.
    void projectWanted(bool open);

protected:
    void showEvent(QShowEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;
    void closeEvent(QCloseEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void buildHeader();
    void buildMenu();
    void buildDevices();
    void buildPages();
    void buildInspector();
    void buildStatus();
    void buildActions();
    void addPage(const QString &title, std::function<QWidget *(QWidget *)> make);
    QWidget *makeOverview(QWidget *parent);
    void makePages(int from);
    void follow();
    void followLinks(const Snapshot &shot);
    void followPages();
    void followLine();
    void listCommands();
    void followInspector();
    void showNotice(const Notice &notice);
    void showFootprint();
    void whenDeactivated();

    Workbench &m_workbench;
    ThemeSource &m_theme;
    Settings &m_settings;
    Selection m_selection;
    Arming *m_arming = nullptr;
    Closing *m_closing = nullptr;
    HelpDesk *m_help = nullptr;
    HeaderBar *m_header = nullptr;
    WindowMenu *m_menu = nullptr;
    DemoStripe *m_stripe = nullptr;
    QDockWidget *m_devices = nullptr;
    QDockWidget *m_inspector = nullptr;
    bool m_inspectorUseful = false;
    PageTabs *m_tabs = nullptr;
    BannerStack *m_banners = nullptr;
    Conditions *m_conditions = nullptr;
    PageKeys *m_keys = nullptr;
    DeviceLine *m_line = nullptr;
    LiveStateBar *m_states = nullptr;
    QStackedWidget *m_pages = nullptr;
    QStackedWidget *m_faces = nullptr; ///< the pages, or production
    ProductionFace *m_production = nullptr;
    StationLamp *m_station = nullptr;
    std::vector<std::function<QWidget *(QWidget *)>> m_makers; ///< by place in m_pages
    QLabel *m_message = nullptr;
    QLabel *m_footprint = nullptr;
    QTimer m_messageTime;
    QTimer m_footprintTime;
};

} // namespace mb
