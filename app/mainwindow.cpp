// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow.h"

#include "app/armkey.h"
#include "app/closing.h"
#include "app/conditions.h"
#include "app/footprint.h"
#include "app/helpdesk.h"
#include "app/keydesk.h"
#include "app/linkchips.h"
#include "app/productionface.h"
#include "app/sidedock.h"
#include "app/stationlamp.h"
#include "app/windowmenu.h"
#include "model/registry.h"
#include "widgets/common/banner.h"
#include "widgets/common/commandpalette.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/headerbar.h"
#include "widgets/common/icons.h"
#include "widgets/common/labels.h"
#include "widgets/common/losses.h"
#include "widgets/common/noticestrip.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/pagekeys.h"
#include "widgets/common/segmented.h"
#include "widgets/common/spoken.h"
#include "widgets/connection/deviceline.h"
#include "widgets/connection/devicetree.h"
#include "widgets/connection/inspector.h"
#include "widgets/connection/livestatebar.h"
#include "widgets/connection/overviewpage.h"
#include "widgets/control/tunepage.h"
#include "widgets/design/designpage.h"
#include "widgets/firmware/firmwarepage.h"
#include "widgets/monitor/buspage.h"
#include "widgets/monitor/logpage.h"
#include "widgets/parameters/keepbar.h"
#include "widgets/parameters/parameterspage.h"
#include "widgets/plots/plotspage.h"
#include "widgets/report/reportspage.h"
#include "widgets/service/productionpage.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDateTime>
#include <QDockWidget>
#include <QScrollArea>
#include <QStackedWidget>
#include <QStatusBar>
#include <QVBoxLayout>
#include <QWindow>

#include <utility>

namespace mb {
namespace {

constexpr std::chrono::milliseconds againLater(200);
constexpr std::chrono::seconds messageTime{8}, footprintTime{1};
constexpr int tallEnough = 520;  ///< for the line of the device above its page
constexpr int roomyWidth = 1024; ///< for devices, a page and the inspector beside each other

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
    buildDevices();
    buildPages();
    buildInspector();
    buildStatus();
    buildActions();
    restoreGeometry(settings.geometry());
    connect(&workbench, &Workbench::changed, this, &MainWindow::follow);
    connect(m_arming, &Arming::changed, this, &MainWindow::follow);
    connect(&m_selection, &Selection::changed, this, &MainWindow::follow);
    showPage(PageId::Overview);
    follow();
}

MainWindow::~MainWindow() = default;

void MainWindow::buildHeader()
{
    auto *top = new QWidget(this);
    auto *column = new QVBoxLayout(top);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    m_header = new HeaderBar(m_theme, top);
    auto *strip = new NoticeStrip(m_theme, top); // nothing below moves when a notice comes or goes
    m_stripe = &strip->stripe();
    m_banners = &strip->banners();
    m_conditions = new Conditions(m_workbench, *m_arming, *m_banners, this);
    column->addWidget(m_header);
    column->addWidget(strip);
    setMenuWidget(top);
    buildMenu();
    m_station = new StationLamp(m_workbench, *m_arming, m_selection, *m_header);
    connect(&m_header->stopButton(), &StopButton::stopPressed, this, [this] { m_arming->stopAll(tr("button")); });
    connect(m_header, &HeaderBar::linkActivated, this, [this] { showPage(PageId::Bus); });
    connect(m_header, &HeaderBar::linksActivated, this, [this] { showPage(PageId::Bus); });
    connect(m_header, &HeaderBar::recordingActivated, this, [this] { showPage(PageId::Bus); });
    connect(m_header, &HeaderBar::noticesActivated, this, [this] { showPage(PageId::Log); });
}

void MainWindow::buildMenu()
{
    m_menu = new WindowMenu(m_workbench, m_theme, m_settings, *this);
    m_header->setMenu(&m_menu->menu());
    connect(m_menu, &WindowMenu::framesOpened, this, [this](const QString &address) {
        showPage(PageId::Bus);
        qobject_cast<BusPage *>(page(PageId::Bus))->showLink(address.toStdString());
    });
    connect(m_menu, &WindowMenu::commandsRequested, this, &MainWindow::listCommands);
    connect(m_menu, &WindowMenu::projectWanted, this, &MainWindow::projectWanted);
    connect(m_menu, &WindowMenu::helpWanted, this, [this](const QString &topic) { (void)m_help->open(topic); });
    connect(m_menu, &WindowMenu::keysRequested, this, &MainWindow::listKeys);
    // the window itself may be another one then
    connect(m_menu, &WindowMenu::lookChosen, this, &MainWindow::lookChosen, Qt::QueuedConnection);
}

void MainWindow::buildDevices()
{
    auto *tree = new DeviceTree(m_workbench, m_selection, m_theme, this);
    m_devices = makeSideDock(*this, QStringLiteral("devicesDock"), tr("Devices"), tree, Qt::LeftDockWidgetArea);
    connect(tree, &DeviceTree::collapseRequested, m_devices, &QWidget::hide);
    connect(tree, &DeviceTree::addLinkRequested, m_menu, &WindowMenu::addLink);
    connect(tree, &DeviceTree::simulateRequested, m_menu, &WindowMenu::openSimulation);
    connect(tree, &DeviceTree::plotRequested, this, [this](const std::vector<Signal> &wanted) {
        showPage(PageId::Plots);
        qobject_cast<PlotsPage *>(page(PageId::Plots))->addSignals(wanted);
    });
    tree->setKept([this](const QString &address) { return m_settings.links().contains(address); });
    connect(tree, &DeviceTree::keepLinkRequested, this, [this](const QString &address, bool keep) {
        keep ? m_settings.addLink(address) : m_settings.removeLink(address);
    });
    connect(tree, &DeviceTree::closeLinkRequested, this, [this](const QString &address) {
        m_settings.removeLink(address);
        if (address.startsWith(QLatin1String("sim:")))
            m_settings.removeLink(QStringLiteral("sim:")); // which stood for this one too
        m_workbench.send(orders::CloseLink{address.toStdString()});
    });
}

void MainWindow::addPage(const QString &title, std::function<QWidget *(QWidget *)> make)
{
    m_tabs->addTab(title);
    auto *scroll = new QScrollArea(m_pages); // for large fonts in a small window
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFocusPolicy(Qt::NoFocus);
    m_pages->addWidget(scroll);
    m_makers.push_back(std::move(make));
}

void MainWindow::buildPages()
{
    auto *central = new QWidget(this);
    auto *column = new QVBoxLayout(central);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    m_tabs = new PageTabs(m_theme, central);
    m_tabs->setAccessibleName(tr("Pages"));
    m_pages = new QStackedWidget(central);
    auto *row = new QHBoxLayout;
    row->addWidget(m_tabs, 1);
    row->addWidget(m_help->makeButton([this] { return shownPage(); }, central));
    column->addLayout(row);
    column->addWidget(separatorLine(Qt::Horizontal, central));
    column->addWidget(m_line = new DeviceLine(m_workbench, m_selection, m_theme, central));
    column->addWidget(m_states = new LiveStateBar(m_workbench, m_selection, m_theme, central));
    column->addWidget(m_pages, 1);
    column->addWidget(new KeepBar(m_workbench, m_theme, central));
    m_faces = new QStackedWidget(this);
    m_faces->addWidget(central);
    setCentralWidget(m_faces);
    m_faces->setMinimumSize(1, 1);
    central->setMinimumSize(1, 1); // as the docks
    addPage(tr("Overview"), [this](QWidget *parent) { return makeOverview(parent); });
    addPage(tr("Parameters"),
        [this](QWidget *parent) { return new ParametersPage(m_workbench, m_selection, m_theme, *m_banners, parent); });
    addPage(tr("Tune"),
        [this](QWidget *parent) { return new TunePage(m_workbench, m_selection, *m_arming, m_theme, parent); });
    addPage(tr("Design"),
        [this](QWidget *parent) { return new DesignPage(m_workbench, m_selection, *m_arming, m_theme, parent); });
    addPage(tr("Plots"), [this](QWidget *parent) { return new PlotsPage(m_workbench, m_selection, m_theme, parent); });
    addPage(tr("Firmware"),
        [this](QWidget *parent) { return new FirmwarePage(m_workbench, m_selection, m_theme, parent); });
    addPage(tr("Bus"), [this](QWidget *parent) { return new BusPage(m_workbench, *m_arming, m_theme, parent); });
    addPage(tr("Log"), [this](QWidget *parent) { return new LogPage(m_workbench, m_theme, parent); });
    addPage(tr("Reports"), [this](QWidget *parent) { return new ReportsPage(m_workbench, m_theme, parent); });
    connect(m_tabs, &QTabBar::currentChanged, this, &MainWindow::followPages);
    connect(m_banners, &BannerStack::allRequested, this, [this] { showPage(PageId::Log); });
}

void MainWindow::addAbovePages(QWidget &strip)
{
    auto *column = static_cast<QBoxLayout *>(m_pages->parentWidget()->layout());
    column->insertWidget(column->indexOf(m_pages), &strip);
}

void MainWindow::setService(ServiceDesk &desk)
{
    m_closing->setService(desk);
    m_station->setService(desk);
    auto *bench = new ProductionPage(desk, m_workbench, families(), m_theme, m_faces);
    m_production = new ProductionFace(*this, *m_faces, *bench, {m_devices, m_inspector});
    connect(bench, &ProductionPage::leaveRequested, m_production, [this] { m_production->show(false); });
    connect(this, &MainWindow::pageMade, this, [&desk](PageId, QWidget *page) {
        if (auto *firmware = qobject_cast<FirmwarePage *>(page))
            firmware->setService(desk, families());
        else if (auto *reports = qobject_cast<ReportsPage *>(page))
            reports->setService(desk, families());
    });
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

void MainWindow::buildInspector()
{
    auto *scroll = new QScrollArea(this); // what only the user knows of a device may be long
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setSizeAdjustPolicy(QAbstractScrollArea::AdjustToContents);
    auto *inspector = new Inspector(m_workbench, m_selection, m_theme, scroll);
    scroll->setWidget(inspector);
    m_inspector
        = makeSideDock(*this, QStringLiteral("inspectorDock"), tr("Inspector"), scroll, Qt::RightDockWidgetArea);
    m_inspector->hide();
    resizeDocks({m_devices}, {m_devices->widget()->sizeHint().width()}, Qt::Horizontal); // whatever is in the list
    for (QWidget *part : inspector->findChildren<QWidget *>())
        part->ensurePolished();    // what a button needs depends on the style sheet
    inspector->setMinimumWidth(1); // long words of one device are elided, and hold nothing wide
    scroll->setMinimumWidth(inspector->sizeHint().width() + scroll->verticalScrollBar()->sizeHint().width());
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

void MainWindow::buildStatus()
{
    m_message = new ElidedLabel({}, this);
    m_footprint = textLabel({}, TextRole::Caption, Tone::Dim, this);
    statusBar()->setSizeGripEnabled(false);
    statusBar()->setMinimumWidth(1);
    const int edge = m_theme.theme().u(12);
    m_message->setContentsMargins(edge, 0, 0, 0);
    m_footprint->setContentsMargins(0, 0, edge, 0);
    m_footprint->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
    statusBar()->addWidget(m_message, 1);
    statusBar()->addPermanentWidget(m_footprint);
    m_messageTime.setSingleShot(true);
    connect(&m_messageTime, &QTimer::timeout, m_message, [label = m_message] {
        label->clear();
        setSpoken(*label, {}, {});
    });
    connect(&m_workbench, &Workbench::noticed, this, &MainWindow::showNotice);
    m_footprintTime.setInterval(footprintTime);
    connect(&m_footprintTime, &QTimer::timeout, this, &MainWindow::showFootprint);
    m_footprintTime.start();
    showFootprint();
}

void MainWindow::buildActions()
{
    m_keys = new PageKeys(*this);
    noteFixedKeys(*m_keys);
    qApp->installEventFilter(new ArmKey(m_header->lamp(), *this));
    m_keys->add({Qt::Key_F1}, tr("shows these keys; once more, the help for this page"), [this] { listKeys(); });
    m_keys->add({Qt::Key_F11}, tr("production: unit after unit, full screen; and back"),
        [this] { m_production ? m_production->show(!m_production->isShown()) : void(); });
    for (int i = 0; i < m_tabs->count(); ++i) {
        const QKeySequence key(QStringLiteral("Ctrl+%1").arg(i + 1));
        m_keys->add({key}, tr("shows page %1").arg(m_tabs->tabText(i)), [this, i] { m_tabs->setCurrentIndex(i); });
    }
    m_keys->add(
        {Qt::Key_F9}, tr("shows or hides the devices"), [this] { m_devices->setVisible(!m_devices->isVisible()); });
    m_keys->add({Qt::Key_F10}, tr("shows or hides the inspector"),
        [this] { m_inspector->setVisible(!m_inspector->isVisible()); });
    m_menu->addTo(*m_keys);
    auto *desk = new KeyDesk(*this, m_settings, [this](int place) { return page(static_cast<PageId>(place)); });
    connect(this, &MainWindow::pageMade, desk, &KeyDesk::apply);
    m_menu->setKeys(*desk);
    connect(qApp, &QGuiApplication::applicationStateChanged, this, [this](Qt::ApplicationState state) {
        if (state == Qt::ApplicationInactive)
            whenDeactivated();
    });
}

/// Of the page that is shown, then those of the window: made from the same tables as the keys themselves.
void MainWindow::listKeys()
{
    QWidget *const shown = page(static_cast<PageId>(m_tabs->currentIndex()));
    const auto *ofPage = shown->findChild<PageKeys *>(QString(), Qt::FindDirectChildrenOnly);
    showKeys(*this, m_tabs->tabText(m_tabs->currentIndex()), {ofPage, m_keys},
        [this] { (void)m_help->open(m_help->topicOf(shownPage())); });
}

/// Keys of the window and of every page, the menu, and the buttons of the page that is shown.
void MainWindow::listCommands()
{
    std::vector<Command> commands;
    const int shown = m_tabs->currentIndex();
    addButtons(commands, m_tabs->tabText(shown), *page(static_cast<PageId>(shown)));
    for (int i = 0; i < m_tabs->count(); ++i) {
        const auto id = static_cast<PageId>(i);
        const auto *keys = page(id)->findChild<PageKeys *>(QString(), Qt::FindDirectChildrenOnly);
        if (keys && m_tabs->isTabEnabled(i))
            addCommands(commands, m_tabs->tabText(i), *keys, [this, id] { showPage(id); });
    }
    addCommands(commands, tr("Window"), *m_keys, [] {});
    addCommands(commands, tr("Menu"), m_menu->menu());
    (new CommandPalette(std::move(commands), this))->open();
}

QWidget *MainWindow::page(PageId id)
{
    const auto place = static_cast<std::size_t>(id);
    auto *scroll = static_cast<QScrollArea *>(m_pages->widget(static_cast<int>(id)));
    if (!scroll->widget()) {
        scroll->setWidget(m_makers[place](m_pages));
        Q_EMIT pageMade(id, scroll->widget());
    }
    return scroll->widget();
}

/// One a turn of the event loop, so that keys wait for one at most. Never while a motor may move: it may take longer than its lease.
void MainWindow::makePages(int from)
{
    if (from >= m_pages->count())
        return;
    if (m_arming->state() != LampState::Safe && m_arming->state() != LampState::Stopped) {
        QTimer::singleShot(againLater, this, [this, from] { makePages(from); });
        return;
    }
    (void)page(static_cast<PageId>(from));
    QTimer::singleShot(0, this, [this, from] { makePages(from + 1); });
}

void MainWindow::showEvent(QShowEvent *event)
{
    QMainWindow::showEvent(event);
    if (windowHandle())
        windowHandle()->installEventFilter(this);
}

bool MainWindow::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Expose && watched == windowHandle()) {
        watched->removeEventFilter(this);
        QTimer::singleShot(0, this, [this] { makePages(0); });
    }
    return QMainWindow::eventFilter(watched, event);
}

void MainWindow::showPage(PageId id)
{
    m_tabs->setCurrentIndex(static_cast<int>(id));
    followPages();
}

PageId MainWindow::shownPage() const
{
    return static_cast<PageId>(m_tabs->currentIndex());
}

void MainWindow::openFile(const QString &path)
{
    m_menu->openFile(path);
}

void MainWindow::followPages()
{
    m_pages->setCurrentIndex(m_tabs->currentIndex());
    page(static_cast<PageId>(m_pages->currentIndex()))->setFocus();
    followLine();
    followInspector();
}

/// What the device is and does, above the pages that are about it; where the window is low the page needs the room.
void MainWindow::followLine()
{
    const auto id = static_cast<PageId>(m_tabs->currentIndex());
    const bool ofDevice = id == PageId::Parameters || id == PageId::Tune || id == PageId::Design;
    const bool tall = height() >= m_theme.theme().u(tallEnough);
    m_states->setWanted(id == PageId::Tune && tall);
    m_line->setVisible(ofDevice && tall && m_workbench.snapshot().device(m_selection.device()));
}

/// On the overview, where there is room for it. F10 is respected until that changes.
void MainWindow::followInspector()
{
    const bool overview = static_cast<PageId>(m_tabs->currentIndex()) == PageId::Overview;
    const bool room = width() >= m_theme.theme().u(roomyWidth);
    const bool useful = overview && room && !m_workbench.snapshot().devices.empty();
    if (std::exchange(m_inspectorUseful, useful) != useful)
        m_inspector->setVisible(useful);
}

void MainWindow::resizeEvent(QResizeEvent *event)
{
    QMainWindow::resizeEvent(event);
    if (event->size().height() != event->oldSize().height())
        followLine();
    followInspector();
}

void MainWindow::follow()
{
    const Snapshot &shot = m_workbench.snapshot();
    followLinks(shot);
    m_conditions->follow();
    m_header->setNotices(m_banners->count());
    m_station->follow();
    const bool any = !shot.devices.empty();
    const QString reason = any ? QString() : tr("needs a device; open a link first");
    m_tabs->setUnavailable(static_cast<int>(PageId::Parameters), reason);
    for (const PageId id : {PageId::Tune, PageId::Design})
        m_tabs->setUnavailable(static_cast<int>(id), reason);
    followInspector();
}

void MainWindow::followLinks(const Snapshot &shot)
{
    std::vector<LinkStatus> chips;
    bool simulated = false;
    QStringList recordings;
    for (const LinkView &link : shot.links) {
        chips.push_back(chipOf(link, shot));
        simulated = simulated || link.simulated;
        if (link.replay)
            recordings += qt(link.name);
    }
    m_header->setLinks(chips);
    m_header->setRecording(recordingTime(shot));
    m_stripe->setSources(simulated ? tr("simulated bench") : QString(), recordings);
}

void MainWindow::showNotice(const Notice &notice)
{
    const auto seconds
        = std::chrono::duration_cast<std::chrono::seconds>(notice.time.time_since_epoch() + m_workbench.unixOffset());
    const QString time = QDateTime::fromSecsSinceEpoch(seconds.count()).toString(QStringLiteral("HH:mm:ss"));
    const QString words = (notice.device.isEmpty() ? QString() : notice.device + QStringLiteral(": ")) + notice.text;
    m_message->setText(time + QLatin1Char(' ') + words);
    announce(*m_message, words);
    setTone(*m_message,
        notice.severity == Severity::Danger        ? Tone::Danger
            : notice.severity == Severity::Caution ? Tone::Caution
                                                   : Tone::Text);
    if (notice.severity == Severity::Danger)
        m_messageTime.stop();
    else
        m_messageTime.start(messageTime);
}

void MainWindow::showFootprint()
{
    const auto [samples, lost] = samplesOn(m_workbench.snapshot());
    m_footprint->setText(tr("samples %1   lost %2   memory %3")
                             .arg(formatCount(static_cast<qint64>(samples)), formatCount(static_cast<qint64>(lost)),
                                 formatBytes(residentBytes())));
}

void MainWindow::whenDeactivated()
{
    if (m_arming->hasMotion())
        m_arming->stopMoved(tr("the window lost the focus"));
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
