// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotfeed.h"

#include "widgets/common/numberformat.h"

#include <cmath>

namespace mb {

bool PlotFeed::fetch(double pixelRatio)
{
    const auto [from, to] = m_view.range();
    const int ticks = std::clamp(m_strips.width() / m_theme.theme().u(96), 2, 8); // labels never touch
    for (const auto &strip : m_strips.all()) {
        strip->keys().ticker()->setTickCount(ticks);
        strip->keys().setRange(from, to);
    }
    for (const auto &[id, trace] : m_strips.traces()) {
        if (trace.visible && trace.source)
            fetchTrace(trace, pixelRatio);
    }
    bool scaled = false;
    for (std::size_t i = 0; i < m_strips.all().size(); ++i) {
        PlotStrip &strip = *m_strips.all()[i];
        strip.decor.gaps.clear();
        scaled = updateAxis(strip, static_cast<int>(i), false) || scaled;
        if (!strip.decor.secondUnit.isEmpty())
            scaled = updateAxis(strip, static_cast<int>(i), true) || scaled;
    }
    return scaled;
}

void PlotFeed::fetchTrace(const PlotTrace &trace, double pixelRatio)
{
    m_scratch.clear();
    const auto [from, to] = m_view.range();
    const double shift = trace.shift(m_view.origin());
    const int columns = trace.plottable->keyAxis()->axisRect()->width();
    const int pixels = std::max(1, static_cast<int>(std::lround(columns * pixelRatio)));
    trace.source->columns(from - shift, to - shift, pixels, m_scratch);
    if (trace.style.aligned) {
        for (PlotPoint &point : m_scratch)
            point.key += shift;
    }
    trace.plottable->swapPoints(m_scratch);
}

bool PlotFeed::updateAxis(PlotStrip &strip, int index, bool second) const
{
    const auto [from, to] = m_view.range();
    std::optional<std::pair<double, double>> seen;
    double least = 0.0;
    for (const auto &[id, trace] : m_strips.traces()) {
        if (!trace.isSeenIn(index, second))
            continue;
        if (const auto values = valueRange(trace.plottable->points(), from, to)) {
            seen = seen ? std::pair(std::min(seen->first, values->first), std::max(seen->second, values->second))
                        : *values;
            least = std::max(
                least, leastSpan(trace.style.role, std::max(std::abs(values->first), std::abs(values->second))));
        }
        if (trace.style.role != TraceRole::Setpoint) // it idles between commands: nothing is missing
            addGaps(strip, trace);
    }
    return strip.scale(second, seen, m_view.now(), least);
}

void PlotFeed::addGaps(PlotStrip &strip, const PlotTrace &trace) const
{
    const double to = m_view.range().second;
    auto &gaps = strip.decor.gaps;
    for (const auto &gap : missingIn(trace, m_view.origin(), std::min(to, m_view.isLive() ? m_view.now() : to))) {
        if (std::ranges::find(gaps, gap) == gaps.end())
            gaps.push_back(gap);
    }
}

void PlotFeed::updateWords(const PlotReadings &readings)
{
    for (std::size_t i = 0; i < m_strips.all().size(); ++i)
        updateTags(*m_strips.all()[i], static_cast<int>(i), readings);
    updateFoot();
    if (m_strips.cursors().visible())
        m_strips.cursors().setRows(readings.cursorRows());
}

void PlotFeed::updateTags(PlotStrip &strip, int index, const PlotReadings &readings) const
{
    strip.decor.tags.clear();
    for (const auto &[id, trace] : m_strips.traces()) {
        const TraceLook &look = trace.plottable->look();
        const bool wished = look.role == TraceRole::Setpoint || look.dash == TraceDash::Dots || trace.style.aligned;
        if (trace.style.strip != index || !trace.visible || !trace.style.valueTag || wished || !trace.source)
            continue;
        const auto value = m_view.isLive() && !m_view.heldKey()
            ? trace.source->latest()
            : std::optional(readings.valueAt(id, m_view.range().second));
        if (value && std::isfinite(*value))
            strip.decor.tags.push_back({readings.valueText(trace.style, *value), *value, look, trace.style.secondAxis});
    }
}

bool PlotFeed::setStateText(const QString &text)
{
    const bool other = text != m_stateText;
    m_stateText = text;
    return other;
}

void PlotFeed::updateFoot() const
{
    QStringList feet;
    QStringList named;
    bool loss = false;
    for (const auto &[id, trace] : m_strips.traces()) {
        const QString foot = trace.visible && trace.source ? trace.source->foot() : QString();
        if (foot.isEmpty())
            continue;
        loss = loss || trace.source->lossy();
        named << tr("%1: %2").arg(trace.style.name, foot);
        if (!feet.contains(foot))
            feet << foot;
    }
    const QString right = feet.size() == 1 ? feet.first() : named.join(QStringLiteral("  ·  "));
    const QString length = formatDuration(m_view.span());
    const QString state = m_strips.traces().empty() ? QString()
        : m_view.isLive()                           ? tr("live, %1").arg(length)
                                                    : tr("paused, %1").arg(length);
    const QString shown = m_view.isLive() && !m_stateText.isEmpty() ? m_stateText : state;
    m_strips.foot()->setTexts(m_footNote.isEmpty() ? shown : m_footNote, right, loss);
}

QRegion PlotFeed::movingPart() const
{
    const Theme &theme = m_theme.theme();
    QRegion moving;
    for (const auto &strip : m_strips.all()) {
        const QRect box = strip->rect().rect();
        const int top = box.top() - theme.u(8); // half of a label of the axis
        moving += QRect(QPoint(0, top), QPoint(box.right() + 3, box.bottom() + theme.u(8)));
    }
    if (!m_strips.all().empty()) { // the labels of the time
        const QCPAxisRect &last = m_strips.all().back()->rect();
        moving += QRect(QPoint(0, last.rect().bottom() + 1), last.outerRect().bottomRight());
    }
    return moving;
}

} // namespace mb
