// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotspage.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/emptystate.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/pagekeys.h"
#include "widgets/common/replaybar.h"
#include "widgets/common/turningrow.h"
#include "widgets/plots/analysisviews.h"
#include "widgets/plots/exportbar.h"
#include "widgets/plots/plotdialogs.h"
#include "widgets/plots/plotsbar.h"
#include "widgets/plots/plotscrubber.h"
#include "widgets/plots/recordingcontrol.h"
#include "widgets/plots/tracepanel.h"

#include <QDropEvent>
#include <QMenu>
#include <QMimeData>
#include <QStackedWidget>

#include <array>
#include <cmath>

namespace mb {
namespace {

constexpr std::chrono::milliseconds repaintTime{16};
constexpr double idleScroll = 0.25;   ///< silent devices scroll away this often
constexpr double analyseEvery = 0.5;  ///< seconds
constexpr int wideWidth = 1250;       ///< for the numbers of the recording
constexpr int tracesBesideFrom = 680; ///< units, for the lists of traces
constexpr double narrowestWindow = 0.01;
/// Samples per second to wish for, so that zooming does not change them all the time.
constexpr std::array<double, 5> rateSteps{20.0, 50.0, 100.0, 200.0, 500.0};

/// What is plotted comes as often as the screen can show it, and not more often.
std::vector<RateWish> wishesOf(const Workbench &workbench, const PlotBoard &board, const PlotStack &stack)
{
    std::vector<RateWish> wishes;
    const double columns = std::max(stack.width(), 1) / std::max(stack.view().window(), narrowestWindow);
    const auto step = std::ranges::find_if(rateSteps, [&](double rate) { return rate >= columns; });
    const double hertz = step == rateSteps.end() ? rateSteps.back() : *step;
    const auto add = [&](const Signal &signal) {
        const DeviceView *device = workbench.snapshot().device(signal.device);
        if (device && device->telemetry && PageRates::isFree(*device))
            wishes.push_back({signal.device, signal.channel, hertz});
    };
    for (const PlotBoard::Trace &trace : board.traces()) {
        add(trace.signal);
        const SignalBook::Derived *derived = board.book().derivedOf(trace.signal);
        for (const Signal &signal : derived ? derived->inputs : std::vector<Signal>())
            add(signal);
    }
    return wishes;
}

/// When the first of what is plotted was recorded.
double beginOf(const PlotBoard &board, double now)
{
    double first = now;
    for (const PlotBoard::Trace &trace : board.traces()) {
        const auto begin = trace.source->telemetry().first(trace.source->channel());
        first = begin ? std::min(first, plotKey(begin->time)) : first;
    }
    return first;
}

void addSamplesEntry(QMenu &menu, QWidget &page, PlotStack &stack, ExportBar &bar)
{
    menu.addAction(PlotsPage::tr("Export samples…"), &page, [&page, &stack, &bar] {
        const auto selection = stack.cursorsShown() ? std::optional(stack.cursorKeys()) : std::nullopt;
        askExport(
            page, stack.view().range(), selection, [&bar](const ExportChoice &choice) { bar.exportSamples(choice); });
    });
}

} // namespace

PlotsPage::PlotsPage(Workbench &workbench, Selection &selection, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_theme(theme)
    , m_stack(new PlotStack(theme, this))
    , m_board(new PlotBoard(workbench, *m_stack, this))
    , m_layoutBook(workbench, selection, *m_stack, *m_board)
{
    setObjectName(QStringLiteral("plotsPage"));
    m_pages = new QStackedWidget(this);
    m_pages->addWidget(new EmptyState(theme, Symbol::Wave, tr("No device yet"),
        tr("Open a link, or the simulated bench from the menu; its signals appear here."), m_pages));
    m_pages->addWidget(buildContent());
    auto *all = layoutIn<QVBoxLayout>(this);
    m_replay = new ReplayBar(workbench, theme, this);
    all->setSpacing(0);
    all->addWidget(m_replay);
    all->addWidget(m_pages);
    connectParts();
    connect(&selection, &Selection::changed, this, &PlotsPage::follow);
    addKeys();
    follow();
}

QWidget *PlotsPage::buildContent()
{
    auto *content = new QWidget(m_pages);
    auto *column = layoutIn<QVBoxLayout>(content, 0);
    auto *work = new TurningRow(m_theme, tracesBesideFrom, content);
    work->parts().setSpacing(0);
    work->parts().addWidget(buildPlots(), 1);
    work->parts().addWidget(m_panel = new TracePanel(m_workbench, *m_stack, *m_board, m_theme, work));
    connect(work, &TurningRow::arranged, m_panel, [panel = m_panel](bool turned) { // the plots have what it leaves
        panel->setMaximumWidth(turned ? QWIDGETSIZE_MAX : panel->sizeHint().width());
    });
    m_bar = new PlotsBar(
        m_workbench, *m_stack, m_theme, [this](QMenu &menu) { m_layoutBook.fillMenu(menu, *this); },
        [this](QMenu &menu) { fillExportMenu(menu); }, content);
    column->addWidget(m_bar);
    column->addWidget(separatorLine(Qt::Horizontal, content));
    column->addWidget(work, 1);
    return content;
}

QWidget *PlotsPage::buildPlots()
{
    auto *area = new QWidget(this);
    auto *column = layoutIn<QVBoxLayout>(area, 0);
    m_trigger = new TriggerControl(*m_stack, *m_board, m_theme, area);
    m_plots = new QStackedWidget(area);
    m_stack->setObjectName(QStringLiteral("plotsStack"));
    m_stack->exporter().setTable(nullptr);
    m_stack->input().acceptDrops(QLatin1String(signalMimeType));
    m_stack->setToolTip(
        tr("Wheel zooms time, Ctrl+wheel values, Shift+wheel moves · drag moves · Shift+drag zooms into a box\n"
           "double click or End returns to the present · right click for more"));
    m_plots->addWidget(new EmptyState(m_theme, Symbol::Wave, tr("Nothing is plotted"),
        tr("Double click a signal in the list at the right or under a device at the left, or drag it here."), m_plots));
    m_plots->addWidget(m_stack);
    m_plots->setAcceptDrops(true);
    m_plots->installEventFilter(this);
    m_against = new AgainstView(*m_stack, *m_board, m_theme, m_plots);
    m_plots->addWidget(m_against);
    m_spectrum = new SpectrumView(*m_stack, *m_board, m_theme, m_plots);
    m_plots->addWidget(m_spectrum);
    m_scrubber = new PlotScrubber(m_theme, *m_stack, area);
    m_exportBar = new ExportBar(m_workbench, *m_board, m_theme, area);
    column->addWidget(&m_trigger->bar());
    column->addWidget(m_exportBar);
    column->addWidget(m_plots, 1);
    column->addWidget(m_scrubber);
    return area;
}

void PlotsPage::connectParts()
{
    m_tick.setInterval(repaintTime);
    connect(&m_tick, &QTimer::timeout, this, [this] {
        if (m_stack->budget().isDue())
            draw();
    });
    connect(&m_workbench, &Workbench::changed, this, &PlotsPage::follow);
    const auto analyseAnew = [this] { // live it comes by itself, and keeps the scale that somebody has chosen
        if (m_stack->view().isLive())
            return;
        m_analysedAt = -1.0;
        m_drawn = {};
    };
    connect(&m_stack->view(), &PlotView::changed, this, analyseAnew);
    connect(m_board, &PlotBoard::changed, this, analyseAnew);
    connect(m_board, &PlotBoard::changed, this, &PlotsPage::boardChanged);
    connect(&m_layoutBook, &PlotLayoutBook::wasReset, this, [this] {
        m_trigger->disarm();
        follow();
    });
    connect(&m_stack->exporter(), &PlotExport::exported, this,
        [this](const QString &path) { m_workbench.report(Severity::Good, {}, tr("plot written to %1").arg(path)); });
    connect(&m_stack->exporter(), &PlotExport::exportFailed, this,
        [this](const QString &cause) { m_workbench.report(Severity::Danger, {}, cause); });
    connect(&m_stack->input(), &PlotInput::dropped, this, [this](const QByteArray &dropped, int strip) {
        const std::vector<Signal> all = signalsFromMime(dropped);
        if (all.size() == 1)
            m_board->choose(all.front(), true, m_board->paneOf(strip));
        else // a whole axis has several units
            addSignals(all);
    });
    connect(&m_stack->input(), &PlotInput::noteRequested, this, &PlotsPage::newNote);
    connect(
        m_stack, &PlotStack::menuRequested, this, [this](QMenu *menu, int, double key) { addMenuEntries(*menu, key); });
    connect(m_stack, &PlotStack::cursorsChanged, this, [this] {
        m_analysedAt = -1.0;
        m_panel->showRows();
    });
    connect(m_stack, &PlotStack::wordsUpdated, m_panel, &TracePanel::showRows);
    connect(m_bar, &PlotsBar::viewChosen, this, [this](int view) { showView(static_cast<View>(view)); });
    connect(m_bar, &PlotsBar::referencesWanted, m_board, &PlotBoard::keepReferences);
    connect(m_bar, &PlotsBar::triggerToggled, m_trigger, &TriggerControl::setOn);
    connect(m_trigger, &TriggerControl::armedChanged, m_bar, &PlotsBar::showTrigger);
    connect(m_panel, &TracePanel::triggerRequested, m_trigger, &TriggerControl::armOn);
    connect(m_panel, &TracePanel::derivedRequested, this, &PlotsPage::newDerived);
    connect(m_panel, &TracePanel::spectrumRequested, this, [this] { showView(View::Spectrum); });
}

void PlotsPage::addKeys()
{
    auto *keys = new PageKeys(*this);
    keys->add({Qt::Key_P}, tr("pauses the plots, and goes on"), [this] { m_bar->togglePause(); });
    keys->add({Qt::Key_0}, tr("fits time and value"),
        [this] { m_plots->currentWidget() == m_stack ? m_stack->fit() : curves(View::Spectrum).fit(); });
    keys->add({Qt::Key_L}, tr("cursors: arrows move one, C changes to the other"), [this] {
        m_stack->setCursorsShown(!m_stack->cursorsShown());
        if (m_stack->cursorsShown())
            m_stack->setFocus(Qt::ShortcutFocusReason);
    });
    keys->add({Qt::Key_T}, tr("watches for a trigger, or no more"), [this] { m_bar->toggleTrigger(); });
    keys->add({Qt::Key_R}, tr("records, or ends the recording"), [this] { m_bar->recording().toggle(); });
    keys->note({Qt::Key_Plus, Qt::Key_Minus}, tr("in the plots: less or more time"));
    keys->note({Qt::Key_PageUp, Qt::Key_PageDown}, tr("in the plots: larger or smaller values"));
    keys->note({Qt::Key_N}, tr("in the plots: writes a note at this time"));
}

void PlotsPage::addSignals(const std::vector<Signal> &wanted)
{
    for (const Signal &signal : wanted)
        m_board->choose(signal, true);
}

CurvePlot &PlotsPage::curves(View view)
{
    return view == View::Against ? m_against->plot() : m_spectrum->plot();
}

void PlotsPage::showView(View view)
{
    m_bar->showView(static_cast<int>(view));
    const int timePage = m_board->traces().empty() ? 0 : 1;
    m_plots->setCurrentIndex(view == View::Time ? timePage : view == View::Against ? 2 : 3);
    m_analysedAt = -1.0;
    refreshView(plotKey(m_board->present()));
    if (view != View::Time)
        curves(view).fit();
}

void PlotsPage::setLayoutFolder(const QString &folder)
{
    m_layoutBook.setFolder(folder);
    follow();
}

void PlotsPage::setRecorder(Recorder *recorder, const QString &folder)
{
    m_bar->recording().setRecorder(recorder, folder);
}

void PlotsPage::follow()
{
    const auto &devices = m_workbench.snapshot().devices;
    m_pages->setCurrentIndex(devices.empty() && m_board->traces().empty() ? 0 : 1);
    m_panel->signalList().setDevices(devices);
    m_board->follow();
    m_replay->setLink(m_board->link());
    m_layoutBook.follow();
    if (!isVisible())
        return;
    m_board->followRates();
    m_rates.wish(wishesOf(m_workbench, *m_board, *m_stack));
    if (m_plots->currentWidget() != m_stack || !m_stack->view().isLive()) // else when the tags are written
        m_panel->showRows();
    m_bar->recording().follow();
}

void PlotsPage::boardChanged()
{
    const auto &traces = m_board->traces();
    m_panel->followBoard();
    m_trigger->follow();
    m_against->follow();
    m_spectrum->follow();
    if (m_plots->currentIndex() <= 1)
        m_plots->setCurrentIndex(traces.empty() ? 0 : 1);
    if (!traces.empty())
        m_scrubber->setSource(traces.front().source, traces.front().style.look());
    if (m_board->isTouched())
        m_layoutBook.remember();
    m_panel->showRows();
    m_drawn = {};
    draw();
}

void PlotsPage::draw()
{
    if (!isVisible())
        return;
    m_board->book().advance();
    const double now = plotKey(m_board->present());
    const std::uint64_t present = m_board->revision();
    if (m_board->traces().empty() || (present == m_drawn.revision && std::abs(now - m_drawn.at) < idleScroll))
        return;
    m_drawn = {present, now};
    const Painting painting(m_stack->budget());
    m_trigger->poll(now);
    m_stack->refresh(now);
    m_scrubber->setSession(beginOf(*m_board, now), now);
    m_scrubber->follow();
    refreshView(now);
}

void PlotsPage::refreshView(double now)
{
    const int page = m_plots->currentIndex();
    const bool first = m_analysedAt < 0.0;
    if (page < 2 || (!first && now - m_analysedAt < analyseEvery))
        return;
    if (!first && !m_stack->view().isLive() && !m_stack->cursorsShown())
        return; // nothing moves
    // The time plot is not drawn now, but its window goes on.
    m_analysedAt = now;
    if (m_stack->view().isLive() && !m_stack->view().heldKey())
        m_stack->follow(now);
    page == 2 ? m_against->refresh() : m_spectrum->refresh();
    if (first)
        curves(page == 2 ? View::Against : View::Spectrum).fit();
}

void PlotsPage::fillExportMenu(QMenu &menu)
{
    if (m_plots->currentWidget() != m_stack)
        return mb::fillExportMenu(
            menu, curves(m_plots->currentWidget() == m_against ? View::Against : View::Spectrum), m_workbench);
    m_stack->exporter().fillMenu(menu);
    addSamplesEntry(menu, *this, *m_stack, *m_exportBar);
}

void PlotsPage::addMenuEntries(QMenu &menu, double key)
{
    menu.addSeparator();
    menu.addAction(tr("Note at this time…\tN"), this, [this, key] { newNote(key); });
    menu.addAction(tr("Keep what is seen as a reference"), m_board, &PlotBoard::keepReferences);
    QAction *clear = menu.addAction(tr("Remove references"), m_board, &PlotBoard::clearReferences);
    clear->setEnabled(!m_board->references().empty());
    menu.addAction(tr("Derived signal…"), this, &PlotsPage::newDerived);
    menu.addAction(tr("Spectrum of what is seen"), this, [this] { showView(View::Spectrum); });
    menu.addAction(tr("X-Y"), this, [this] { showView(View::Against); });
    menu.addAction(
        tr("Trigger: stands still at an edge or a level") + QStringLiteral("\tT"), m_bar, &PlotsBar::toggleTrigger);
    addSamplesEntry(menu, *this, *m_stack, *m_exportBar);
}

void PlotsPage::newDerived()
{
    const auto check
        = [this](const QString &name, const QString &formula) { return m_board->book().whatIsWrong(name, formula); };
    askDerived(*this, m_theme, m_board->book().variables(), check,
        [this](const QString &name, const QString &unit, const QString &formula) {
            if (const auto added = m_board->addDerived(name, unit, formula); !added)
                m_workbench.report(Severity::Danger, {}, tr("%1: %2").arg(name, errorText(added.error())));
        });
}

void PlotsPage::newNote(double key)
{
    askNote(*this, [this, key](const QString &text) {
        m_board->addNote(key, text);
        if (!m_board->notes().empty())
            m_bar->recording().note(m_board->notes().back().time, text);
    });
}

void PlotsPage::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    m_tick.setTimerType(Qt::PreciseTimer);
    m_tick.start();
    m_drawn.revision = 0;
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
    m_bar->recording().setWide(width() > m_theme.theme().u(wideWidth));
}

void PlotsPage::hideEvent(QHideEvent *event)
{
    m_tick.stop();
    QWidget::hideEvent(event);
    m_rates.wish({});
}

} // namespace mb
