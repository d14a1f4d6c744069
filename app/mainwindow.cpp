// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow.h"

#include "app/armkey.h"
#include "app/closing.h"
#include "app/conditions.h"
#include "app/helpdesk.h"
#include "app/linkchips.h"
#include "app/pagestack.h"
#include "app/productionface.h"
#include "app/sidedocks.h"
#include "app/stationlamp.h"
#include "app/statusbar.h"
#include "app/windowkeys.h"
#include "app/windowmenu.h"
#include "model/registry.h"
#include "widgets/common/banner.h"
#include "widgets/common/headerbar.h"
#include "widgets/common/holdbutton.h"
#include "widgets/common/icons.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/noticestrip.h"
#include "widgets/connection/deviceactions.h"
#include "widgets/connection/devicetree.h"
#include "widgets/connection/overviewpage.h"
#include "widgets/control/tunepage.h"
#include "widgets/design/designpage.h"
#include "widgets/firmware/firmwarepage.h"
#include "widgets/monitor/buspage.h"
#include "widgets/monitor/logpage.h"
#include "widgets/parameters/parameterspage.h"
#include "widgets/plots/plotspage.h"
#include "widgets/report/reportspage.h"
#include "widgets/service/productionpage.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QCloseEvent>
#include <QStackedWidget>
#include <utility>

namespace mb {
namespace {

constexpr int leastHeight = 240; ///< units

} // namespace

MainWindow::MainWindow(Workbench &workbench, ThemeSource &theme, Settings &settings, QWidget *parent)
    : QMainWindow(parent)
    , m_workbench(workbench)
    , m_theme(theme)
    , m_settings(settings)
    , m_arming(new Arming(workbench, this))
    , m_closing(new Closing(workbench, *m_arming, *this))
    , m_help(new HelpDesk(workbench, m_selection, theme, *this))
{
    setWindowTitle(tr("MotorBench"));
    setWindowIcon(applicationIcon());
    resize(1440, 900);
    buildHeader();
    buildMenu();
    buildPages();
    buildDocks(); // beside the pages: they take what these leave
    buildProduction();
    buildStatus();
    m_keys = new WindowKeys(
        {*m_pages, *m_docks, *m_menu, *m_help, settings}, *this,
        [this] { m_production->show(!m_production->isShown()); }, [this] { rename(); });
    qApp->installEventFilter(new ArmKey(m_header->lamp(), *this));
    // Never so narrow that the Arm button or STOP is cut, or that the devices beside it are squeezed to nothing.
    setMinimumSize(m_header->minimumSizeHint().width(), theme.theme().u(leastHeight));
    restoreGeometry(settings.geometry());
    connect(&workbench, &Workbench::changed, this, &MainWindow::follow);
    connect(m_arming, &Arming::changed, this, &MainWindow::follow);
    connect(m_arming, &Arming::changed, &m_selection, &Selection::keep);
    connect(&m_selection, &Selection::changed, this, &MainWindow::follow);
    connect(qApp, &QGuiApplication::applicationStateChanged, this, [this](Qt::ApplicationState state) {
        if (state == Qt::ApplicationInactive && m_arming->hasMotion())
            m_arming->stopMoved(tr("the window lost the focus"));
    });
    showPage(PageId::Overview);
    follow();
}

MainWindow::~MainWindow() = default;

void MainWindow::buildHeader()
{
    auto *top = new QWidget(this);
    auto *column = layoutIn<QVBoxLayout>(top, 0);
    m_header = new HeaderBar(m_theme, top);
    auto *strip = new NoticeStrip(m_theme, top); // nothing below moves when a notice comes or goes
    m_stripe = &strip->stripe();
    m_banners = &strip->banners();
    m_conditions = new Conditions(m_workbench, *m_arming, *m_banners, this);
    column->addWidget(m_header);
    column->addWidget(strip);
    setMenuWidget(top);
    m_station = new StationLamp(m_workbench, *m_arming, *m_closing, m_selection, *m_header);
    connect(&m_header->stopButton(), &StopButton::stopPressed, this, [this] { m_arming->stopAll(tr("button")); });
    // what is held to arm or to begin must not act after it
    connect(m_arming, &Arming::stopSent, this, [this] {
        m_header->lamp().giveUp();
        for (HoldButton *button : findChildren<HoldButton *>())
            button->giveUp();
    });
    connect(m_header, &HeaderBar::linkActivated, this, &MainWindow::showFrames);
    connect(m_header, &HeaderBar::linksActivated, this, [this] { showPage(PageId::Bus); });
    connect(m_header, &HeaderBar::recordingActivated, this, [this] { showPage(PageId::Bus); });
    connect(m_header, &HeaderBar::noticesActivated, this, [this] { showPage(PageId::Log); });
}

void MainWindow::showFrames(const QString &link)
{
    showPage(PageId::Bus);
    qobject_cast<BusPage *>(page(PageId::Bus))->showLink(link.toStdString());
}

void MainWindow::buildMenu()
{
    m_menu = new WindowMenu(m_workbench, m_theme, m_settings, *this);
    m_header->setMenu(&m_menu->menu());
    connect(m_menu, &WindowMenu::framesOpened, this, &MainWindow::showFrames);
    connect(m_menu, &WindowMenu::projectWanted, this, &MainWindow::projectWanted);
    connect(m_menu, &WindowMenu::helpWanted, this, [this](const QString &topic) { (void)m_help->open(topic); });
    // the window itself may be another one then
    connect(m_menu, &WindowMenu::lookChosen, this, &MainWindow::lookChosen, Qt::QueuedConnection);
}

void MainWindow::buildDocks()
{
    m_docks = new SideDocks(m_workbench, m_selection, m_theme, m_settings, *this);
    m_pages->addBeforeTabs(*m_docks->makeButton(m_pages));
    const DeviceTree *const tree = &m_docks->devices();
    connect(tree, &DeviceTree::addLinkRequested, m_menu, &WindowMenu::addLink);
    connect(tree, &DeviceTree::simulateRequested, m_menu, &WindowMenu::openSimulation);
    connect(tree, &DeviceTree::plotRequested, this, [this](const std::vector<Signal> &wanted) {
        showPage(PageId::Plots);
        qobject_cast<PlotsPage *>(page(PageId::Plots))->addSignals(wanted);
    });
}

void MainWindow::buildPages()
{
    m_faces = new QStackedWidget(this);
    m_faces->setMinimumSize(1, 1);
    m_pages = new PageStack(m_workbench, m_selection, *m_arming, m_theme, m_faces);
    m_pages->addBesideTabs(*m_help->makeButton([this] { return shownPage(); }, m_pages));
    m_faces->addWidget(m_pages);
    setCentralWidget(m_faces);
    addPages();
    connect(m_pages, &PageStack::pageMade, this, &MainWindow::pageMade);
    connect(m_pages, &PageStack::shownChanged, this, &MainWindow::followInspector);
    // whoever turns a page works with what is selected
    connect(m_pages, &PageStack::shownChanged, &m_selection, &Selection::keep);
    connect(m_banners, &BannerStack::allRequested, this, [this] { showPage(PageId::Log); });
}

/// In the order of PageId.
void MainWindow::addPages()
{
    m_pages->add(tr("Overview"), [this](QWidget *parent) { return makeOverview(parent); });
    m_pages->add(tr("Parameters"),
        [this](QWidget *parent) { return new ParametersPage(m_workbench, m_selection, m_theme, *m_banners, parent); });
    m_pages->add(tr("Tune"),
        [this](QWidget *parent) { return new TunePage(m_workbench, m_selection, *m_arming, m_theme, parent); });
    m_pages->add(tr("Design"),
        [this](QWidget *parent) { return new DesignPage(m_workbench, m_selection, *m_arming, m_theme, parent); });
    m_pages->add(
        tr("Plots"), [this](QWidget *parent) { return new PlotsPage(m_workbench, m_selection, m_theme, parent); });
    m_pages->add(tr("Firmware"),
        [this](QWidget *parent) { return new FirmwarePage(m_workbench, m_selection, families(), m_theme, parent); });
    m_pages->add(tr("Bus"), [this](QWidget *parent) { return new BusPage(m_workbench, *m_arming, m_theme, parent); });
    m_pages->add(tr("Log"), [this](QWidget *parent) { return new LogPage(m_workbench, m_theme, parent); });
    m_pages->add(tr("Reports"),
        [this](QWidget *parent) { return new ReportsPage(m_workbench, m_selection, families(), m_theme, parent); });
}

void MainWindow::addAbovePages(QWidget &strip)
{
    m_pages->addAbovePages(strip);
}

void MainWindow::buildStatus()
{
    auto *const status = new StatusBar(m_workbench, m_theme, this);
    setStatusBar(status);
    connect(m_pages, &PageStack::shownChanged, status, [this, status, wasLog = false]() mutable {
        const bool isLog = shownPage() == PageId::Log;
        if (std::exchange(wasLog, isLog) || isLog) // what came meanwhile was read there, too
            status->forget();
    });
}

void MainWindow::buildProduction()
{
    auto *bench = new ProductionPage(m_workbench, families(), m_theme, m_faces);
    m_production = new ProductionFace(*this, *m_faces, *bench, *m_docks);
    connect(bench, &ProductionPage::leaveRequested, m_production, [this] { m_production->show(false); });
}

QWidget *MainWindow::makeOverview(QWidget *parent)
{
    auto *overview = new OverviewPage(m_workbench, m_selection, m_theme, parent);
    connect(overview, &OverviewPage::simulateRequested, m_menu, &WindowMenu::openSimulation);
    connect(overview, &OverviewPage::addLinkRequested, m_menu, &WindowMenu::addLink);
    connect(overview, &OverviewPage::openRecordingRequested, m_menu, &WindowMenu::openRecording);
    connect(overview, &OverviewPage::updateRequested, this, [this] { showPage(PageId::Firmware); });
    return overview;
}

/// What can be edited where the focus is goes first, as it would without this key.
void MainWindow::rename()
{
    auto *const list = qobject_cast<QAbstractItemView *>(QApplication::focusWidget());
    if (m_production->isShown())
        findChild<ProductionPage *>()->goToSerial();
    else if (list && list->currentIndex().flags().testFlag(Qt::ItemIsEditable))
        list->edit(list->currentIndex());
    else
        askRename(m_workbench, m_selection.device(), *this);
}

void MainWindow::listKeys()
{
    m_keys->list();
}

QWidget *MainWindow::page(PageId id)
{
    return m_pages->page(id);
}

void MainWindow::showPage(PageId id)
{
    m_pages->showPage(id);
}

PageId MainWindow::shownPage() const
{
    return m_pages->shown();
}

void MainWindow::openFile(const QString &path)
{
    m_menu->openFile(path);
}

void MainWindow::followInspector()
{
    m_docks->follow(shownPage() == PageId::Overview);
}

void MainWindow::resizeEvent(QResizeEvent *event)
{
    QMainWindow::resizeEvent(event);
    followInspector();
}

void MainWindow::follow()
{
    const Snapshot &shot = m_workbench.snapshot();
    showLinks(*m_header, *m_stripe, shot);
    m_conditions->follow();
    m_header->setNotices(m_banners->count());
    m_station->follow();
    const QString reason = shot.devices.empty() ? tr("needs a device; open a link first") : QString();
    for (const PageId id : {PageId::Tune, PageId::Design})
        m_pages->setUnavailable(id, reason);
    followInspector();
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    if (!m_closing->mayClose()) {
        event->ignore();
        return;
    }
    m_settings.setGeometry(saveGeometry());
    event->accept();
}

} // namespace mb
