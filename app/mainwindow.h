// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/pageid.h"
#include "app/settings.h"
#include "widgets/common/selection.h"
#include "widgets/common/theme.h"
#include "widgets/common/workbench.h"
#include "widgets/control/arming.h"

#include <QMainWindow>

class QStackedWidget;

namespace mb {

class BannerStack;
class Closing;
class Conditions;
class DemoStripe;
class HeaderBar;
class HelpDesk;
class PageStack;
class ProductionFace;
class SideDocks;
class StationLamp;
class WindowKeys;
class WindowMenu;

/// The one window: header with links, Arm button and STOP; devices at the left; pages; inspector at the right; status bar.
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
    [[nodiscard]] Closing &closing() { return *m_closing; }
    /// Pages are made when they are asked for first, the others once the window has been painted.
    [[nodiscard]] QWidget *page(PageId id);
    void showPage(PageId id);
    [[nodiscard]] PageId shownPage() const;
    /// Puts it above the pages, below what is said of the device; the window owns it from now on.
    void addAbovePages(QWidget &strip);
    [[nodiscard]] ProductionFace &production() const { return *m_production; }
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
    void closeEvent(QCloseEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void buildHeader();
    void buildMenu();
    void buildDocks();
    void buildPages();
    void addPages();
    void buildStatus();
    void buildProduction();
    QWidget *makeOverview(QWidget *parent);
    void showFrames(const QString &link);
    void rename();
    void follow();
    void followInspector();

    Workbench &m_workbench;
    ThemeSource &m_theme;
    Settings &m_settings;
    Selection m_selection;
    Arming *m_arming = nullptr;
    Closing *m_closing = nullptr;
    HelpDesk *m_help = nullptr;
    HeaderBar *m_header = nullptr;
    DemoStripe *m_stripe = nullptr;
    BannerStack *m_banners = nullptr;
    Conditions *m_conditions = nullptr;
    WindowMenu *m_menu = nullptr;
    StationLamp *m_station = nullptr;
    SideDocks *m_docks = nullptr;
    PageStack *m_pages = nullptr;
    QStackedWidget *m_faces = nullptr; ///< the pages, or production
    ProductionFace *m_production = nullptr;
    WindowKeys *m_keys = nullptr;
};

} // namespace mb
