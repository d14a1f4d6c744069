// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/tracepanel.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/pagekeys.h"
#include "widgets/plots/tracelist.h"

#include <QMenu>
#include <QScrollArea>

namespace mb {
namespace {

constexpr int sideWidth = 300;

/// nullptr: what comes of this link is of now.
const LinkView *replayAt(const Snapshot &shot, const std::string &link)
{
    const LinkView *const view = shot.link(link);
    return view && view->replay ? view : nullptr;
}

} // namespace

TracePanel::TracePanel(
    Workbench &workbench, PlotStack &stack, PlotBoard &board, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_stack(stack)
    , m_board(board)
    , m_theme(theme)
{
    const auto u = [&theme](int size) { return theme.theme().u(size); };
    setMinimumWidth(u(sideWidth));
    auto *column = layoutIn<QVBoxLayout>(this, 0);
    auto *head = new QHBoxLayout;
    head->setContentsMargins(u(12), u(8), u(20), u(8)); // as the rows beside their scroll bar
    head->addWidget(new SectionLabel(tr("Traces"), this));
    head->addStretch(1);
    head->addWidget(textLabel(tr("rate      lost"), TextRole::Caption, Tone::Dim, this));
    column->addLayout(head);
    column->addWidget(separatorLine(Qt::Horizontal, this));
    buildLists();
    auto *foot = new QHBoxLayout;
    foot->setContentsMargins(u(12), u(6), u(12), u(8));
    QLabel *const keys = textLabel({}, TextRole::Caption, Tone::Dim, this);
    nameKeys(*keys, tr("%1 cursors · %2 fits · + − zooms · %3 pauses · N note"),
        {QStringLiteral("L"), QStringLiteral("0"), QStringLiteral("P")});
    keys->setWordWrap(true);
    foot->addWidget(keys);
    column->addWidget(separatorLine(Qt::Horizontal, this));
    column->addLayout(foot);
    connect(&theme, &ThemeSource::changed, this, [this] { setMinimumWidth(m_theme.theme().u(sideWidth)); });
}

QSize TracePanel::sizeHint() const
{
    return {m_theme.theme().u(sideWidth), QWidget::sizeHint().height()};
}

void TracePanel::buildLists()
{
    auto *column = static_cast<QVBoxLayout *>(layout());
    m_list = new TraceList(m_theme, this);
    m_list->setProperty("transparent", true);
    auto *scroll = new QScrollArea(this);
    scroll->setWidget(m_list);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    column->addWidget(scroll, 3);
    column->addWidget(separatorLine(Qt::Horizontal, this));
    m_signals = new SignalList(m_theme, this);
    column->addWidget(m_signals, 2);
    connect(
        m_signals, &SignalList::toggled, this, [this](const Signal &signal, bool on) { m_board.choose(signal, on); });
    connect(m_signals, &SignalList::newDerivedRequested, this, &TracePanel::derivedRequested);
    connect(m_signals, &SignalList::removeDerivedRequested, &m_board, &PlotBoard::removeDerived);
    connect(m_list, &TraceList::removeRequested, this, [this](int id) {
        if (const PlotBoard::Trace *trace = m_board.traceOf(id))
            m_board.choose(Signal(trace->signal), false);
    });
    connect(m_list, &TraceList::menuRequested, this, &TracePanel::showMenu);
}

void TracePanel::followBoard()
{
    std::set<Signal> chosen;
    for (const PlotBoard::Trace &trace : m_board.traces())
        chosen.insert(trace.signal);
    QStringList derived;
    for (const SignalBook::Derived &signal : m_board.book().derived())
        derived << signal.name;
    m_signals->setDerived(derived);
    m_signals->setChosen(chosen);
}

QString TracePanel::bareText(const PlotBoard::Trace &trace, double value) const
{
    TraceStyle bare = trace.style;
    bare.unit.clear();
    return m_stack.readings().valueText(bare, value);
}

QString TracePanel::statisticsOf(const PlotBoard::Trace &trace) const
{
    const auto found = m_stack.readings().selection(trace.id);
    if (!found)
        return {};
    const auto bare = [&](double value) { return bareText(trace, value); };
    QString text = tr("mean %1 · σ %2 · %3 … %4 · %5 samples")
                       .arg(bare(found->mean), formatSignificant(found->deviation, 3), bare(found->low),
                           bare(found->high), formatCount(static_cast<qint64>(found->count)));
    if (found->lost > 0)
        text += tr(" · %1 lost").arg(formatCount(static_cast<qint64>(found->lost)));
    return text;
}

void TracePanel::showRows()
{
    std::vector<TraceList::Row> rows;
    const Snapshot &shot = m_workbench.snapshot();
    for (const PlotBoard::Trace &trace : m_board.traces()) {
        const DeviceView *device = shot.device(trace.signal.device);
        const LinkView *link = device ? shot.link(device->link) : nullptr;
        TraceList::Row row;
        row.id = trace.id;
        row.look = trace.style.look();
        row.name = trace.style.name;
        row.source = link ? QString::fromStdString(link->name) : device ? QString() : tr("derived");
        if (replayAt(shot, m_board.book().linkOf(trace.signal)) != replayAt(shot, m_board.link()))
            row.source = tr("%1, of another time").arg(row.source);
        row.rate = tr("%1 Hz").arg(formatNumber(trace.source->rate()));
        row.lost = tr("%1 lost").arg(formatCount(static_cast<qint64>(trace.source->lost())));
        row.lossy = trace.source->lossy();
        const PlotReadings &readings = m_stack.readings();
        const auto latest = trace.source->latest();
        row.value = latest ? readings.valueText(trace.style, *latest) : QString(UnknownMark);
        if (m_stack.cursorsShown()) {
            const auto [a, b] = m_stack.cursorKeys();
            row.cursors = tr("A %1   B %2")
                              .arg(bareText(trace, readings.valueAt(trace.id, a)),
                                  readings.valueText(trace.style, readings.valueAt(trace.id, b)));
            row.statistics = statisticsOf(trace);
        }
        rows.push_back(row);
    }
    m_list->setRows(std::move(rows));
}

void TracePanel::showMenu(int id, const QPoint &at)
{
    const PlotBoard::Trace *trace = m_board.traceOf(id);
    if (!trace)
        return;
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const int strip = trace->style.strip;
    menu->addAction(tr("In a pane of its own"), this, [this, id] { m_board.moveToPane(id, m_board.paneOf(-1)); });
    QAction *above = menu->addAction(
        tr("Into the pane above"), this, [this, id, strip] { m_board.moveToPane(id, m_board.paneOf(strip - 1)); });
    above->setEnabled(strip > 0);
    menu->addAction(tr("With its unit"), this, [this, id] { m_board.moveToPane(id, {}); });
    QAction *second = menu->addAction(
        tr("Scale at the right"), this, [this, id, on = !trace->second] { m_board.setSecondAxis(id, on); });
    second->setCheckable(true);
    second->setChecked(trace->second);
    menu->addSeparator();
    menu->addAction(tr("Trigger on it\tT"), this, [this, id] { Q_EMIT triggerRequested(id); });
    menu->addAction(tr("Keep all as references"), &m_board, &PlotBoard::keepReferences);
    QAction *clear = menu->addAction(tr("Remove references"), &m_board, &PlotBoard::clearReferences);
    clear->setEnabled(!m_board.references().empty());
    menu->addAction(tr("Spectrum"), this, &TracePanel::spectrumRequested);
    menu->addSeparator();
    menu->addAction(tr("Remove the trace"), this, [this, signal = trace->signal] { m_board.choose(signal, false); });
    menu->popup(at);
}

} // namespace mb
