// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotstrips.h"

#include "widgets/common/numberformat.h"
#include "widgets/plots/plotcursors.h"
#include "widgets/plots/stripface.h"

#include <algorithm>

namespace mb {
namespace {

/// Room at the right of all strips for the newest values.
int tagMargin(const std::map<int, PlotTrace> &traces, const Theme &theme, const QFont &font)
{
    int width = theme.u(32); // the unit of time
    for (const auto &[id, trace] : traces) {
        if (trace.visible && trace.style.valueTag && trace.style.role != TraceRole::Setpoint) {
            const QString widest = formatValue(-8888.8, 1, trace.style.unit);
            width = std::max(width, StripFace::tagWidth(theme, font, widest));
        }
    }
    return width;
}

/// What its traces make of the head of a strip.
void fillHead(PlotStrip &strip, int index, const std::map<int, PlotTrace> &traces)
{
    StripDecor &decor = strip.decor;
    decor.title = strip.style.title;
    decor.first = index == 0;
    decor.entries.clear();
    decor.curves.clear();
    QStringList units;
    QStringList secondUnits;
    for (const auto &[id, trace] : traces) {
        if (trace.style.strip != index || !trace.visible)
            continue;
        QStringList &ofAxis = trace.style.secondAxis ? secondUnits : units;
        if (!ofAxis.contains(trace.style.unit))
            ofAxis << trace.style.unit;
        if (!decor.notes.empty() && !trace.style.secondAxis)
            decor.curves.push_back(trace.plottable);
        if (strip.style.legend)
            decor.entries.push_back({trace.style.name, trace.plottable->look()});
    }
    std::ranges::stable_partition(
        decor.entries, // where there is no room for all, set-points of several axes look alike
        [](const auto &entry) { return entry.look.role != TraceRole::Setpoint; });
    decor.unit = units.join(QStringLiteral(", "));
    decor.secondUnit = secondUnits.join(QStringLiteral(", "));
    strip.axis(true).setVisible(!secondUnits.isEmpty());
}

} // namespace

PlotStrips::PlotStrips(PlotFrame &plot, const ThemeSource &theme)
    : QObject(&plot)
    , m_plot(plot)
    , m_theme(theme)
    , m_margins(new QCPMarginGroup(&plot))
    , m_timeTicker(QSharedPointer<TimeTicker>::create())
    , m_foot(new PlotFoot(plot, theme))
    , m_cursors(new PlotCursors(plot, theme))
{
    plot.addLayer(QStringLiteral("wished"), plot.layer(QStringLiteral("main")), QCustomPlot::limBelow);
    plot.plotLayout()->clear();
    plot.plotLayout()->setRowSpacing(0);
    connect(&theme, &ThemeSource::changed, this, &PlotStrips::restyle);
    rebuildLayout();
}

void PlotStrips::ensure(int strip)
{
    const auto wanted = static_cast<std::size_t>(std::max(strip, 0)) + 1;
    if (m_strips.size() >= wanted)
        return;
    while (m_strips.size() < wanted)
        m_strips.push_back(std::make_unique<PlotStrip>(m_plot, *m_margins, m_timeTicker, m_theme));
    rebuildLayout();
}

void PlotStrips::rebuildLayout()
{
    QCPLayoutGrid &layout = *m_plot.plotLayout();
    const auto takeOut = [&layout](QCPLayoutElement *element) {
        if (element->layout() == &layout)
            layout.take(element);
    };
    for (const auto &strip : m_strips)
        takeOut(&strip->rect());
    takeOut(m_foot);
    layout.simplify();
    int row = 0;
    std::vector<QCPAxisRect *> rects;
    for (const auto &strip : m_strips) {
        layout.addElement(row, 0, &strip->rect());
        layout.setRowStretchFactor(row++, strip->style.stretch);
        rects.push_back(&strip->rect());
    }
    layout.addElement(row, 0, m_foot);
    layout.setRowStretchFactor(row, 0.001);
    m_cursors->setRects(std::move(rects));
    restyle();
}

void PlotStrips::restyle()
{
    m_plot.setCanvas(m_theme.theme().canvas);
    for (const auto &strip : m_strips)
        strip->restyle(m_plot.font(), strip == m_strips.back());
    for (auto &[id, trace] : m_traces)
        trace.plottable->setLook(trace.plottable->look(), m_theme.theme());
    updateHeads();
}

void PlotStrips::updateHeads()
{
    const Theme &theme = m_theme.theme();
    const QFontMetrics caption(theme.font(TextRole::Caption, m_plot.font()));
    const bool anySecond = std::ranges::any_of(
        m_traces, [](const auto &entry) { return entry.second.visible && entry.second.style.secondAxis; });
    const int secondAxisWidth
        = anySecond ? std::max(theme.u(56), caption.horizontalAdvance(QStringLiteral("−888 888")) + theme.u(12)) : 0;
    const int right = tagMargin(m_traces, theme, m_plot.font()) + (m_strips.empty() ? 0 : secondAxisWidth);
    for (std::size_t i = 0; i < m_strips.size(); ++i) {
        PlotStrip &strip = *m_strips[i];
        fillHead(strip, static_cast<int>(i), m_traces);
        strip.decor.watermark = m_watermark;
        strip.decor.marks = m_marks;
        strip.decor.secondAxisWidth = secondAxisWidth;
        const int unit = caption.horizontalAdvance(strip.decor.unit) + theme.u(10);
        strip.rect().setMinimumMargins(QMargins(std::max(theme.u(52), unit), 0, 0, 0));
        strip.setRightMargin(right);
    }
    Q_EMIT changed();
}

void PlotStrips::setStrip(int strip, const StripStyle &style)
{
    ensure(strip);
    at(strip).style = style;
    rebuildLayout();
}

int PlotStrips::addTrace(const TraceStyle &style, std::shared_ptr<const TraceSource> source)
{
    ensure(style.strip);
    const PlotStrip &strip = at(style.strip);
    PlotTrace trace{style, std::move(source), new TracePlottable(&strip.keys(), &strip.axis(style.secondAxis))};
    trace.plottable->setLook(style.look(), m_theme.theme());
    trace.plottable->setName(style.name);
    if (style.role == TraceRole::Setpoint || style.dash == TraceDash::Dots)
        trace.plottable->setLayer(QStringLiteral("wished")); // behind what was measured
    const int id = m_nextTrace++;
    m_traces.emplace(id, std::move(trace));
    updateHeads();
    return id;
}

const PlotTrace *PlotStrips::trace(int trace) const
{
    const auto found = m_traces.find(trace);
    return found == m_traces.end() ? nullptr : &found->second;
}

void PlotStrips::setSource(int trace, std::shared_ptr<const TraceSource> source)
{
    const auto found = m_traces.find(trace);
    if (found == m_traces.end())
        return;
    found->second.source = std::move(source);
    Q_EMIT changed();
}

void PlotStrips::setTraceVisible(int trace, bool visible)
{
    const auto found = m_traces.find(trace);
    if (found == m_traces.end())
        return;
    found->second.visible = visible;
    found->second.plottable->setVisible(visible);
    updateHeads();
}

void PlotStrips::removeTrace(int trace)
{
    const auto found = m_traces.find(trace);
    if (found == m_traces.end())
        return;
    m_plot.removePlottable(found->second.plottable);
    m_traces.erase(found);
    updateHeads();
}

void PlotStrips::clear()
{
    m_plot.clearPlottables();
    m_traces.clear();
    for (int i = m_plot.itemCount() - 1; i >= 0; --i) {
        if (m_plot.item(i) != m_cursors)
            m_plot.removeItem(i);
    }
    for (const auto &strip : m_strips)
        m_plot.plotLayout()->remove(&strip->rect());
    m_strips.clear();
    m_trigger.reset();
    rebuildLayout();
}

void PlotStrips::setValueRange(int strip, std::optional<std::pair<double, double>> range)
{
    ensure(strip);
    at(strip).fix(range);
    Q_EMIT changed();
}

void PlotStrips::setWatermark(const QString &text)
{
    m_watermark = text;
    updateHeads();
}

void PlotStrips::setMarks(std::vector<PlotMark> marks)
{
    m_marks = std::move(marks);
    updateHeads();
}

void PlotStrips::setTrigger(const std::optional<PlotTrigger> &trigger)
{
    m_trigger = trigger;
    for (const auto &strip : m_strips)
        strip->decor.trigger.reset();
    if (const PlotTrace *of = trigger ? trace(trigger->trace) : nullptr)
        at(of->style.strip).decor.trigger = TriggerLine{trigger->level, trigger->text, of->style.secondAxis};
    Q_EMIT changed();
}

int PlotStrips::stripAt(const QPoint &position) const
{
    for (std::size_t i = 0; i < m_strips.size(); ++i) {
        if (m_strips[i]->rect().outerRect().contains(position))
            return static_cast<int>(i);
    }
    return -1;
}

} // namespace mb
