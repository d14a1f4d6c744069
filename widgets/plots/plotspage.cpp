// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotspage.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/emptystate.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/ratekeeper.h"
#include "widgets/common/replaybar.h"
#include "widgets/plots/curveplot.h"
#include "widgets/plots/exportjob.h"
#include "widgets/plots/plotscrubber.h"
#include "widgets/plots/tracelist.h"
#include "widgets/plots/triggerbar.h"

#include <QComboBox>
#include <QDropEvent>
#include <QHBoxLayout>
#include <QMimeData>
#include <QProgressBar>
#include <QScrollArea>
#include <QStackedWidget>

namespace mb {
namespace {

constexpr std::chrono::milliseconds repaintTime{16};
constexpr std::chrono::milliseconds rememberAfter{1000};
constexpr double firstWindow = 10.0;
constexpr int sideWidth = 300;

} // namespace

PlotsPage::PlotsPage(Workbench &workbench, Selection &selection, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_selection(selection)
    , m_theme(theme)
    , m_stack(new PlotStack(theme, this))
    , m_board(new PlotBoard(workbench, *m_stack, this))
    , m_trigger(*m_stack)
{
    setObjectName(QStringLiteral("plotsPage"));
    m_pages = new QStackedWidget(this);
    m_empty = new EmptyState(theme, Symbol::Wave, tr("No device yet"),
        tr("Open a link, or the simulated bench from the menu; its signals appear here."), m_pages);
    auto *content = new QWidget(m_pages);
    auto *grid = new QGridLayout(content);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(0);
    grid->addWidget(buildPlots(), 2, 0);
    grid->addWidget(buildBar(), 0, 0, 1, 3);
    grid->addWidget(separatorLine(Qt::Horizontal, content), 1, 0, 1, 3);
    grid->addWidget(separatorLine(Qt::Vertical, content), 2, 1);
    grid->addWidget(buildSide(), 2, 2);
    grid->setColumnStretch(0, 1);
    grid->setRowStretch(2, 1);
    m_pages->addWidget(m_empty);
    m_pages->addWidget(content);
    auto *all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    m_replay = new ReplayBar(workbench, theme, this);
    all->setSpacing(0);
    all->addWidget(m_replay);
    all->addWidget(m_pages);
    connectStack();
    addKeys();
    follow();
}

PlotsPage::~PlotsPage()
{
    if (m_remember.isActive())
        rememberLayout();
}

QWidget *PlotsPage::buildPlots()
{
    auto *area = new QWidget(this);
    auto *column = new QVBoxLayout(area);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    m_triggerBar = new TriggerBar(m_theme, area);
    m_triggerBar->hide();
    m_plots = new QStackedWidget(area);
    m_stack->setObjectName(QStringLiteral("plotsStack"));
    m_stack->setWindow(firstWindow);
    m_stack->setOwnTable(false);
    m_stack->acceptDrops(QLatin1String(signalMimeType));
    m_stack->setToolTip(
        tr("Wheel zooms time, Ctrl+wheel values, Shift+wheel moves · drag moves · Shift+drag zooms into a box\n"
           "double click or End returns to the present · right click for more"));
    m_plots->addWidget(new EmptyState(m_theme, Symbol::Wave, tr("Nothing is plotted"),
        tr("Double click a signal in the list at the right or under a device at the left, or drag it here."), m_plots));
    m_plots->addWidget(m_stack);
    m_plots->setAcceptDrops(true);
    m_plots->installEventFilter(this);
    buildAgainst(*m_plots);
    m_plots->addWidget(m_againstPage);
    m_spectrum = new CurvePlot(m_theme, tr("Spectrum"), m_plots);
    m_spectrum->setAxes(tr("frequency, Hz"), tr("amplitude"), true);
    m_plots->addWidget(m_spectrum);
    m_scrubber = new PlotScrubber(m_theme, *m_stack, area);
    column->addWidget(m_triggerBar);
    column->addWidget(buildJob());
    column->addWidget(m_plots, 1);
    column->addWidget(m_scrubber);
    return area;
}

void PlotsPage::connectStack()
{
    m_tick.setInterval(repaintTime);
    connect(&m_tick, &QTimer::timeout, this, &PlotsPage::tick);
    m_remember.setSingleShot(true);
    m_remember.setInterval(rememberAfter);
    connect(&m_remember, &QTimer::timeout, this, &PlotsPage::rememberLayout);
    connect(&m_workbench, &Workbench::changed, this, &PlotsPage::follow);
    connect(&m_selection, &Selection::changed, this, &PlotsPage::follow);
    connect(m_board, &PlotBoard::changed, this, &PlotsPage::boardChanged);
    connect(m_stack, &PlotStack::exported, this,
        [this](const QString &path) { m_workbench.report(Severity::Good, {}, tr("plot written to %1").arg(path)); });
    connect(m_stack, &PlotStack::exportFailed, this,
        [this](const QString &cause) { m_workbench.report(Severity::Danger, {}, cause); });
    connect(m_stack, &PlotStack::dropped, this, [this](const QByteArray &dropped, int strip) {
        const std::vector<Signal> all = signalsFromMime(dropped);
        if (all.size() == 1)
            m_board->choose(all.front(), true, m_board->paneOf(strip));
        else // a whole axis has several units
            addSignals(all);
    });
    connect(m_stack, &PlotStack::noteRequested, this, &PlotsPage::newNote);
    connect(
        m_stack, &PlotStack::menuRequested, this, [this](QMenu *menu, int, double key) { addMenuEntries(*menu, key); });
    connect(m_stack, &PlotStack::triggerLevelMoved, this, [this](double level) {
        m_triggerBar->setLevel(level);
        arm();
    });
    connect(m_triggerBar, &TriggerBar::changed, this, &PlotsPage::arm);
    connect(m_triggerBar, &TriggerBar::closed, this, &PlotsPage::triggerOff);
}

QWidget *PlotsPage::buildJob()
{
    const Theme &theme = m_theme.theme();
    m_jobBar = new QWidget(this);
    auto *row = new QHBoxLayout(m_jobBar);
    row->setContentsMargins(theme.u(12), theme.u(4), theme.u(12), theme.u(4));
    m_progress = new QProgressBar(m_jobBar);
    m_progress->setRange(0, 100);
    m_progress->setAccessibleName(tr("Progress of the export"));
    auto *cancel = new CommandButton(m_theme, tr("Cancel"), m_jobBar);
    row->addWidget(textLabel(tr("Writing samples"), TextRole::Caption, Tone::Dim, m_jobBar));
    row->addWidget(m_progress, 1);
    row->addWidget(cancel);
    m_jobBar->hide();
    m_job = new ExportJob(this);
    connect(cancel, &QPushButton::clicked, m_job, &ExportJob::cancel);
    connect(m_job, &ExportJob::progressed, m_progress, &QProgressBar::setValue);
    connect(m_job, &ExportJob::finished, this, &PlotsPage::finished);
    return m_jobBar;
}

QWidget *PlotsPage::buildSide()
{
    const Theme &theme = m_theme.theme();
    auto *side = new QWidget(this);
    side->setFixedWidth(theme.u(sideWidth));
    auto *column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto *head = new QHBoxLayout;
    head->setContentsMargins(theme.u(12), theme.u(8), theme.u(12), theme.u(8));
    head->addWidget(new SectionLabel(tr("Traces"), side));
    head->addStretch(1);
    head->addWidget(textLabel(tr("rate      lost"), TextRole::Caption, Tone::Dim, side));
    column->addLayout(head);
    column->addWidget(separatorLine(Qt::Horizontal, side));
    buildLists(*side);
    auto *hint
        = textLabel(tr("L cursors · 0 fits · + − zooms · P pauses · N note"), TextRole::Caption, Tone::Dim, side);
    auto *foot = new QHBoxLayout;
    foot->setContentsMargins(theme.u(12), theme.u(6), theme.u(12), theme.u(8));
    foot->addWidget(hint);
    column->addWidget(separatorLine(Qt::Horizontal, side));
    column->addLayout(foot);
    connect(&m_theme, &ThemeSource::changed, side, [this, side] { side->setFixedWidth(m_theme.theme().u(sideWidth)); });
    return side;
}

void PlotsPage::buildLists(QWidget &side)
{
    auto *column = static_cast<QVBoxLayout *>(side.layout());
    m_list = new TraceList(m_theme, &side);
    m_list->setProperty("transparent", true);
    auto *scroll = new QScrollArea(&side);
    scroll->setWidget(m_list);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    column->addWidget(scroll, 3);
    column->addWidget(separatorLine(Qt::Horizontal, &side));
    m_signals = new SignalList(m_theme, &side);
    column->addWidget(m_signals, 2);
    connect(
        m_signals, &SignalList::toggled, this, [this](const Signal &signal, bool on) { m_board->choose(signal, on); });
    connect(m_signals, &SignalList::newDerivedRequested, this, &PlotsPage::newDerived);
    connect(m_signals, &SignalList::removeDerivedRequested, m_board, &PlotBoard::removeDerived);
    connect(m_list, &TraceList::removeRequested, this, [this](int id) {
        if (const PlotBoard::Trace *trace = m_board->traceOf(id))
            m_board->choose(Signal(trace->signal), false);
    });
    connect(m_list, &TraceList::menuRequested, this, &PlotsPage::showRowMenu);
}

void PlotsPage::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    m_tick.setTimerType(Qt::PreciseTimer);
    m_tick.start();
    m_drawn = 0;
    follow();
}

bool PlotsPage::eventFilter(QObject *watched, QEvent *event)
{
    const bool enters = event->type() == QEvent::DragEnter || event->type() == QEvent::DragMove;
    if (!enters && event->type() != QEvent::Drop)
        return QWidget::eventFilter(watched, event);
    auto *drop = static_cast<QDropEvent *>(event);
    const std::vector<Signal> carried = signalsFromMime(drop->mimeData()->data(QLatin1String(signalMimeType)));
    if (!carried.empty())
        drop->acceptProposedAction();
    if (!enters)
        addSignals(carried);
    return true;
}

void PlotsPage::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    followWidth();
}

void PlotsPage::hideEvent(QHideEvent *event)
{
    m_tick.stop();
    QWidget::hideEvent(event);
    RateKeeper::of(m_workbench).wish(this, {});
}

} // namespace mb
