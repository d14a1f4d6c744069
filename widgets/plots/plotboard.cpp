// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotboard.h"

#include "model/axis.h"
#include "widgets/common/axistext.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"
#include "widgets/plots/fixedtrace.h"
#include "widgets/plots/tracecolours.h"

#include <algorithm>

namespace mb {
namespace {

constexpr double referenceSpan = 1.0; ///< windows beside what is seen that are kept, too
constexpr std::size_t mostNotes = 1000;
constexpr std::size_t mostAbsent = 200;

/// Everything of an axis has its colour, also in several panes; where that is taken in a pane, as any other trace.
void dressAxis(PlotBoard::Trace &trace, int axis, const std::vector<PlotBoard::Trace> &all)
{
    if (axis == 0 || trace.style.role == TraceRole::Setpoint)
        return;
    const TraceRole wished = axisColour(axis);
    for (const PlotBoard::Trace &other : all) {
        if (&other == &trace)
            break; // what follows is not dressed yet
        if (other.style.strip == trace.style.strip && other.style.look().colourRole() == wished)
            return;
    }
    trace.style.colour = wished;
}

std::vector<PlotMark> marksOf(const std::vector<TimedNote> &notes)
{
    std::vector<PlotMark> marks;
    for (const TimedNote &note : notes)
        marks.push_back({plotKey(note.time), QString::fromStdString(note.text)});
    return marks;
}

} // namespace

PlotBoard::PlotBoard(Workbench &workbench, PlotStack &stack, QObject *parent)
    : QObject(parent)
    , m_workbench(workbench)
    , m_stack(stack)
    , m_kept(workbench.kept<Kept>())
    , m_book(workbench)
{
    stack.strips().setMarks(marksOf(m_kept.notes));
}

const PlotBoard::Trace *PlotBoard::traceOf(int id) const
{
    const auto found = std::ranges::find(m_traces, id, &Trace::id);
    return found == m_traces.end() ? nullptr : &*found;
}

void PlotBoard::choose(const Signal &signal, bool on, const QString &pane)
{
    const auto found = std::ranges::find(m_traces, signal, &Trace::signal);
    const bool there = found != m_traces.end();
    if (on && there && !pane.isEmpty())
        return moveToPane(found->id, pane);
    if (on == there || (on && !m_book.rowOf(signal)))
        return;
    m_touched = true;
    if (on)
        m_traces.push_back({signal, pane, false, {}, m_places++});
    else
        m_traces.erase(found);
    rebuild();
}

QString PlotBoard::paneOf(int strip)
{
    if (strip >= 0 && strip < m_panes.size())
        return m_panes.at(strip);
    QString pane;
    do
        pane = QStringLiteral("pane %1").arg(++m_newPanes);
    while (m_panes.contains(pane));
    return pane;
}

void PlotBoard::moveToPane(int id, const QString &pane)
{
    for (Trace &trace : m_traces) {
        if (trace.id == id)
            trace.pane = pane;
    }
    m_touched = true;
    rebuild();
}

void PlotBoard::setSecondAxis(int id, bool second)
{
    for (Trace &trace : m_traces) {
        if (trace.id == id)
            trace.second = second;
    }
    m_touched = true;
    rebuild();
}

void PlotBoard::setTraces(std::vector<Trace> traces, bool touched)
{
    m_traces.clear();
    m_absent.clear();
    for (Trace &trace : traces) {
        trace.place = m_places++;
        (m_book.rowOf(trace.signal) ? m_traces : m_absent).push_back(std::move(trace));
    }
    m_touched = touched;
    rebuild();
}

void PlotBoard::reset()
{
    m_kept.references.clear();
    setTraces({}, false);
}

std::vector<const PlotBoard::Trace *> PlotBoard::wished() const
{
    std::vector<const Trace *> all;
    for (const auto *traces : {&m_traces, &m_absent}) {
        for (const Trace &trace : *traces)
            all.push_back(&trace);
    }
    std::ranges::sort(all, [](const Trace *a, const Trace *b) { return a->place < b->place; });
    return all;
}

int PlotBoard::stripOf(const QString &pane, const QString &unit)
{
    const QString key = pane.isEmpty() ? unit : pane;
    if (!m_panes.contains(key))
        m_panes << key;
    return m_panes.indexOf(key);
}

void PlotBoard::dress(Trace &trace)
{
    const Channel &row = *m_book.rowOf(trace.signal);
    const ShownUnit unit = shownUnit(row, m_units);
    const auto telemetry = m_book.telemetryOf(trace.signal);
    if (!trace.source || &trace.source->telemetry() != telemetry.get())
        trace.source = std::make_shared<TelemetrySource>(telemetry, trace.signal.channel);
    trace.source->setScale(unit.scale);
    trace.row = &row;
    trace.address = m_book.addressOf(trace.signal);
    trace.style = {};
    trace.style.name = m_book.nameOf(trace.signal);
    trace.style.unit = unit.text;
    trace.style.role = roleOf(row.quantity);
    trace.style.mostDecimals = mostDecimals(row.quantity, unit);
    trace.style.secondAxis = trace.second;
    trace.style.strip = stripOf(trace.pane, unit.text);
    dressAxis(trace, axisOf(row.key), m_traces);
    if (!trace.style.colour)
        chooseColour(trace.style, m_used);
    m_used.push_back(trace.style.look());
    trace.id = m_stack.strips().addTrace(trace.style, trace.source);
}

void PlotBoard::rebuild()
{
    m_stack.strips().clear();
    m_panes.clear();
    m_used.clear();
    bool simulated = false;
    bool replayed = false;
    for (Trace &trace : m_traces) {
        dress(trace);
        for (const DeviceView *device : m_book.devicesOf(trace.signal)) {
            const LinkView *const link = m_workbench.snapshot().link(device->link);
            simulated = simulated || (link && link->simulated);
            replayed = replayed || (link && link->replay);
        }
    }
    for (Reference &reference : m_kept.references) {
        reference.style.strip = stripOf(reference.pane, reference.style.unit);
        reference.id = m_stack.strips().addTrace(reference.style, reference.trace);
    }
    m_stack.strips().setWatermark(simulated ? tr("DEMO") : replayed ? tr("REPLAY") : QString());
    followRates();
    Q_EMIT changed();
}

std::string PlotBoard::link() const
{
    for (const Trace &trace : m_traces) {
        if (const std::string link = m_book.linkOf(trace.signal); !link.empty())
            return link;
    }
    return {};
}

/// What a person wants waits for its device; the usual traces of one that was selected do not.
bool PlotBoard::letGo()
{
    const auto there = [this](const Trace &trace) { return m_book.rowOf(trace.signal) != nullptr; };
    const auto gone = std::stable_partition(m_traces.begin(), m_traces.end(), there);
    const bool any = gone != m_traces.end();
    for (auto trace = gone; m_touched && trace != m_traces.end(); ++trace) {
        trace->source.reset();
        m_absent.push_back(std::move(*trace));
    }
    m_traces.erase(gone, m_traces.end());
    if (m_absent.size() > mostAbsent) // of the longest ago
        m_absent.erase(m_absent.begin(), m_absent.end() - mostAbsent);
    for (Trace &trace : m_traces) { // the number of a device may be another
        if (const DeviceView *device = m_workbench.snapshot().device(trace.signal.device);
            device && device->selector != trace.address.device)
            trace.address.device = device->selector;
    }
    return any;
}

bool PlotBoard::takeIn()
{
    const std::size_t before = m_absent.size();
    for (auto trace = m_absent.begin(); trace != m_absent.end();) {
        const auto signal = m_book.find(trace->address);
        if (!signal) {
            ++trace;
            continue;
        }
        trace->signal = *signal;
        const auto there = std::ranges::any_of(m_traces, [&](const Trace &other) { return other.signal == *signal; });
        const auto after = std::upper_bound(m_traces.begin(), m_traces.end(), trace->place,
            [](int place, const Trace &other) { return place < other.place; });
        if (!there)
            m_traces.insert(after, std::move(*trace));
        trace = m_absent.erase(trace);
    }
    return m_absent.size() != before;
}

void PlotBoard::follow()
{
    m_stack.strips().times().setClock(m_workbench.wallClock(link()));
    bool other = m_book.complete();
    other = letGo() || other;
    other = takeIn() || other;
    // A device begins anew where a recording is taken to another place; its units are others once a scale is given,
    // and its name where another one has its number.
    const auto isOutdated = [this](const Trace &trace) {
        return trace.row != m_book.rowOf(trace.signal) || trace.style.name != m_book.nameOf(trace.signal)
            || &trace.source->telemetry() != m_book.telemetryOf(trace.signal).get();
    };
    if (other || std::ranges::any_of(m_traces, isOutdated))
        rebuild();
}

void PlotBoard::followRates()
{
    double rate = 0.0;
    std::uint64_t lost = 0;
    std::uint64_t all = 0;
    for (const Trace &trace : m_traces) {
        const DeviceView *device = m_workbench.snapshot().device(trace.signal.device);
        const std::size_t place = trace.signal.channel.value;
        const Instant now = m_workbench.presentOf(m_book.linkOf(trace.signal));
        if (device)
            trace.source->follow(place < device->rates.size() ? device->rates[place] : 0.0, now);
        else if (const auto *derived = m_book.derivedOf(trace.signal))
            trace.source->follow(derived->signal->telemetry()->rate({0}, now), now);
        rate += trace.source->rate();
        lost += trace.source->lost();
        all += trace.source->lost() + trace.source->telemetry().size(trace.source->channel());
    }
    const QString foot = tr("%1 signals, %2 samples/s, %3 of %4 lost")
                             .arg(formatCount(static_cast<qint64>(m_traces.size())), formatNumber(rate),
                                 formatCount(static_cast<qint64>(lost)), formatCount(static_cast<qint64>(all)));
    for (const Trace &trace : m_traces)
        trace.source->setFootText(foot);
}

std::uint64_t PlotBoard::revision() const
{
    std::uint64_t sum = 0;
    for (const Trace &trace : m_traces)
        sum += trace.source ? trace.source->telemetry().revision() : 0;
    return sum;
}

Result<void> PlotBoard::addDerived(const QString &name, const QString &unit, const QString &formula)
{
    const auto added = m_book.add(name, unit, formula);
    if (!added)
        return tl::unexpected<Error>(added.error());
    choose(*added, true);
    return {};
}

void PlotBoard::removeDerived(int place)
{
    const Signal signal{derivedDevice, {static_cast<std::uint16_t>(place)}};
    if (place < 0 || !m_book.derivedOf(signal))
        return;
    choose(signal, false);
    const SignalAddress address = m_book.addressOf(signal);
    m_absent.erase(std::remove_if(m_absent.begin(), m_absent.end(),
                       [&address](const Trace &trace) { return trace.address == address; }),
        m_absent.end());
    m_book.remove(signal);
    Q_EMIT changed();
}

void PlotBoard::keepReferences()
{
    const auto [from, to] = m_stack.view().range();
    const double origin = m_stack.view().heldKey().value_or(from);
    const double beside = (to - from) * referenceSpan;
    for (const Trace &trace : m_traces) {
        if (trace.style.role == TraceRole::Setpoint)
            continue;
        std::vector<PlotPoint> points;
        trace.source->columns(from - beside, to + beside, 30'000, points);
        joinUnlost(points, *trace.source);
        for (PlotPoint &point : points)
            point.key -= origin;
        Reference reference;
        reference.style = trace.style;
        reference.style.name = tr("ref %1").arg(trace.style.name);
        reference.style.dash = TraceDash::Long;
        reference.style.marker = TraceMarker::HollowSquare;
        reference.style.valueTag = false;
        reference.style.aligned = true;
        reference.pane = trace.pane;
        reference.trace = std::make_shared<FixedTrace>(std::move(points));
        m_kept.references.push_back(std::move(reference));
    }
    rebuild();
}

void PlotBoard::clearReferences()
{
    m_kept.references.clear();
    rebuild();
}

void PlotBoard::addNote(double key, const QString &text)
{
    if (text.trimmed().isEmpty() || m_kept.notes.size() >= mostNotes)
        return;
    const Instant time = instantOf(key);
    m_kept.notes.push_back({time, text.trimmed().toStdString()});
    m_stack.strips().setMarks(marksOf(m_kept.notes));
}

} // namespace mb
