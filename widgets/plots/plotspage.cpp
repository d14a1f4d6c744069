// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotspage.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/emptystate.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/numberformat.h"
#include "widgets/plots/plotstack.h"
#include "widgets/plots/tracelist.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QMenu>
#include <QScrollArea>
#include <QShortcut>
#include <QStackedWidget>

#include <algorithm>
#include <array>

namespace mb {
namespace {

constexpr std::chrono::milliseconds tickTime{16};
constexpr std::array windows{2.0, 5.0, 10.0, 30.0, 60.0, 300.0, 1800.0};
constexpr int usualWindow = 2;
constexpr int sideWidth = 300;

} // namespace

PlotsPage::PlotsPage(Workbench &workbench, Selection &selection, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_selection(selection)
    , m_theme(theme)
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
    all->addWidget(m_pages);
    m_tick.setInterval(tickTime);
    connect(&m_tick, &QTimer::timeout, this, &PlotsPage::tick);
    connect(&workbench, &Workbench::changed, this, &PlotsPage::follow);
    connect(&selection, &Selection::changed, this, &PlotsPage::follow);
    follow();
}

QWidget *PlotsPage::buildPlots()
{
    m_plots = new QStackedWidget(this);
    m_stack = new PlotStack(m_theme, m_plots);
    m_stack->setObjectName(QStringLiteral("plotsStack"));
    m_stack->setWindow(windows.at(usualWindow));
    m_plots->addWidget(new EmptyState(m_theme, Symbol::Wave, tr("Nothing is plotted"),
        tr("Double click a signal in the list at the right."), m_plots));
    m_plots->addWidget(m_stack);
    connect(m_stack, &PlotStack::exported, this,
        [this](const QString &path) { m_workbench.report(Severity::Good, {}, tr("plot written to %1").arg(path)); });
    connect(m_stack, &PlotStack::exportFailed, this, [this](const QString &path) {
        m_workbench.report(Severity::Danger, {}, tr("%1 cannot be written").arg(path));
    });
    return m_plots;
}

QWidget *PlotsPage::buildBar()
{
    const Theme &theme = m_theme.theme();
    auto *bar = new QWidget(this);
    auto *row = new QHBoxLayout(bar);
    row->setContentsMargins(theme.u(12), theme.u(6), theme.u(12), theme.u(6));
    row->setSpacing(theme.u(8));
    m_pause = new CommandButton(m_theme, Symbol::Pause, tr("Pause view"), bar);
    m_pause->setKeyHint(QStringLiteral("P"));
    m_pause->setTextVariants({tr("Pause view"), tr("Follow live")});
    m_pause->setToolTip(tr("The recording goes on."));
    row->addWidget(m_pause);
    row->addStretch(1);
    buildView(*row);
    connect(m_pause, &QPushButton::clicked, this, [this] { m_stack->setLive(!m_stack->isLive()); });
    connect(m_stack, &PlotStack::liveChanged, this, [this](bool live) {
        m_pause->setText(live ? tr("Pause view") : tr("Follow live"));
        m_pause->setSymbol(live ? Symbol::Pause : Symbol::Play);
    });
    connect(new QShortcut(QKeySequence(Qt::Key_P), this), &QShortcut::activated, m_pause, &QPushButton::click);
    return bar;
}

void PlotsPage::buildView(QHBoxLayout &row)
{
    m_window = new QComboBox(this);
    for (const double seconds : windows)
        m_window->addItem(seconds < 60.0 ? tr("window %1 s").arg(formatNumber(seconds))
                                         : tr("window %1 min").arg(formatNumber(seconds / 60.0)));
    m_window->setCurrentIndex(usualWindow);
    m_window->setAccessibleName(tr("Length of the time axis"));
    auto *cursors = new IconButton(m_theme, Symbol::Cursors, tr("Cursors A and B"), this);
    cursors->setCheckable(true);
    cursors->setKeyHint(QStringLiteral("L"));
    auto *fit = new IconButton(m_theme, Symbol::Fit, tr("Fit time and value"), this);
    fit->setKeyHint(QStringLiteral("0"));
    auto *save = new CommandButton(m_theme, Symbol::Export, tr("Export"), this);
    save->setToolTip(tr("The picture as PNG, SVG or PDF, or what is visible as CSV"));
    row.addWidget(m_window);
    row.addWidget(cursors);
    row.addWidget(fit);
    row.addWidget(save);
    connect(m_window, qOverload<int>(&QComboBox::activated), this,
        [this](int place) { m_stack->setWindow(windows.at(static_cast<std::size_t>(place))); });
    connect(cursors, &QToolButton::toggled, m_stack, &PlotStack::setCursorsShown);
    connect(m_stack, &PlotStack::cursorsChanged, this, [this, cursors] {
        cursors->setChecked(m_stack->cursorsShown());
        showRows();
    });
    connect(fit, &QToolButton::clicked, m_stack, &PlotStack::fit);
    connect(new QShortcut(QKeySequence(Qt::Key_0), this), &QShortcut::activated, m_stack, &PlotStack::fit);
    connect(save, &QPushButton::clicked, this, [this, save] {
        auto *menu = new QMenu(save);
        menu->setAttribute(Qt::WA_DeleteOnClose);
        m_stack->fillMenu(*menu);
        menu->popup(save->mapToGlobal(QPoint(0, save->height())));
    });
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
    m_list = new TraceList(m_theme, side);
    m_list->setProperty("transparent", true);
    auto *scroll = new QScrollArea(side);
    scroll->setWidget(m_list);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    column->addWidget(scroll, 3);
    column->addWidget(separatorLine(Qt::Horizontal, side));
    m_signals = new SignalList(m_theme, side);
    column->addWidget(m_signals, 2);
    auto *hint = textLabel(tr("L cursors · 0 fits · + − zooms · P pauses"), TextRole::Caption, Tone::Dim, side);
    auto *foot = new QHBoxLayout;
    foot->setContentsMargins(theme.u(12), theme.u(6), theme.u(12), theme.u(8));
    foot->addWidget(hint);
    column->addWidget(separatorLine(Qt::Horizontal, side));
    column->addLayout(foot);
    connect(m_signals, &SignalList::toggled, this, &PlotsPage::choose);
    connect(m_list, &TraceList::removeRequested, this, [this](int id) {
        const auto found
            = std::find_if(m_traces.begin(), m_traces.end(), [id](const Trace &trace) { return trace.id == id; });
        if (found != m_traces.end())
            choose(Signal(found->signal), false);
    });
    connect(&m_theme, &ThemeSource::changed, side, [this, side] { side->setFixedWidth(m_theme.theme().u(sideWidth)); });
    return side;
}

void PlotsPage::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    m_tick.setTimerType(Qt::PreciseTimer);
    m_tick.start();
    m_drawn = 0;
    follow();
}

void PlotsPage::hideEvent(QHideEvent *event)
{
    m_tick.stop();
    QWidget::hideEvent(event);
}

} // namespace mb
