// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/numberformat.h"
#include "widgets/plots/plotcursors.h"
#include "widgets/plots/plotstack.h"

#include <cmath>

namespace mb {
namespace {

constexpr qint64 WordsEvery = 100; ///< milliseconds between two changes of numbers that somebody reads

constexpr double rounding = 1e-6; ///< seconds; of a key
constexpr double silence = 0.25;  ///< seconds; shorter than that only a loss is a gap

/// Where something is missing. A line that a device began anew, such as with another period, is broken there and nothing more.
std::vector<std::pair<double, double>> gapsIn(
    const std::vector<PlotPoint> &points, const TraceSource *source, double shift, double to)
{
    auto gaps = gapsOf(points, to);
    std::erase_if(gaps, [source, shift](const std::pair<double, double> &gap) {
        if (!source || gap.second - gap.first >= silence)
            return false;
        const auto found = source->statistics(gap.first - shift - rounding, gap.second - shift + rounding);
        return found && found->lost == 0;
    });
    return gaps;
}

/// Decimals that tell a five-hundredth of the axis apart.
int decimalsFor(double span)
{
    return span > 0 ? std::clamp(static_cast<int>(std::ceil(-std::log10(span / 500))), 0, 6) : 0;
}

/// To the tenth of a millisecond where that can be read off, for cursors.
QString preciseDuration(double seconds)
{
    const bool small = std::abs(seconds) < 1;
    return formatValue(small ? seconds * 1000 : seconds, small ? (std::abs(seconds) < 0.1 ? 1 : 0) : 3,
        small ? QStringLiteral("ms") : QStringLiteral("s"));
}

} // namespace

void PlotStack::refresh(double now)
{
    m_now = now;
    if (!isVisible() || m_plot->visibleRegion().isEmpty())
        return;
    const bool moved = m_live && followPresent(now);
    if (!moved && !m_dirty)
        return;
    const Painting painting(m_budget);
    m_scaled = false;
    fetch();
    const bool words = m_dirty || !m_wordsSince.isValid() || m_wordsSince.elapsed() >= WordsEvery;
    if (words) {
        m_wordsSince.start();
        for (std::size_t i = 0; i < m_strips.size(); ++i)
            updateTags(*m_strips[i], static_cast<int>(i));
        updateFoot();
        updateCursorRows();
    }
    m_dirty = false;
    const int width = plotWidth();
    // What stands beside the axes reaches over all of the picture with cursors, and changes with a second axis.
    const bool second = std::any_of(
        m_strips.begin(), m_strips.end(), [](const auto &strip) { return !strip->decor.secondUnit.isEmpty(); });
    if (words || m_scaled || second || m_cursors->visible())
        m_plot->render();
    else
        m_plot->renderPart(movingPart());
    // Drawing lays out first: after a resize, or with wider tick labels, the columns were made for another width.
    if (plotWidth() != width) {
        fetch();
        m_plot->render();
    }
}

QRegion PlotStack::movingPart() const
{
    const Theme &theme = m_theme.theme();
    QRegion moving;
    for (const auto &strip : m_strips) {
        const QRect box = strip->rect->rect();
        const int top = box.top() - theme.u(8); // half of a label of the axis
        moving += QRect(QPoint(0, top), QPoint(box.right() + 3, box.bottom() + theme.u(8)));
    }
    if (!m_strips.empty()) { // the labels of the time
        const QCPAxisRect &last = *m_strips.back()->rect;
        moving += QRect(QPoint(0, last.rect().bottom() + 1), last.outerRect().bottomRight());
    }
    return moving;
}

int PlotStack::plotWidth() const
{
    return m_strips.empty() ? 0 : m_strips.front()->rect->width();
}

bool PlotStack::followPresent(double now)
{
    // Whole pixel columns on absolute time: the trace scrolls without shimmering, and a long window is drawn only
    // as often as it moves by a pixel.
    const double column = m_window / std::max(plotWidth(), 1);
    const double end = m_held ? *m_held + m_window * (1.0 - m_heldBefore) : now;
    const double to = std::ceil(end / column) * column;
    if (to == m_to && m_to - m_from == m_window)
        return false;
    m_to = to;
    m_from = to - m_window;
    return true;
}

void PlotStack::fetch()
{
    const int width = m_strips.empty() ? 0 : m_strips.front()->rect->width();
    m_timeTicker->setTickCount(std::clamp(width / m_theme.theme().u(96), 2, 8)); // labels never touch
    for (const auto &strip : m_strips)
        strip->rect->axis(QCPAxis::atBottom)->setRange(m_from, m_to);
    for (auto &[id, trace] : m_traces) {
        if (!trace.visible || !trace.source)
            continue;
        const int columns = trace.plottable->keyAxis()->axisRect()->width();
        const double ratio = m_plot->devicePixelRatioF();
        fetchTrace(trace, m_from, m_to, std::max(1, static_cast<int>(std::lround(columns * ratio))));
    }
    for (std::size_t i = 0; i < m_strips.size(); ++i)
        updateStrip(static_cast<int>(i), m_to);
}

void PlotStack::fetchTrace(Trace &trace, double from, double to, int pixels)
{
    m_scratch.clear();
    const double shift = trace.style.aligned ? origin() : 0.0;
    trace.source->columns(from - shift, to - shift, pixels, m_scratch);
    if (trace.style.aligned) {
        for (PlotPoint &point : m_scratch)
            point.key += shift;
    }
    trace.plottable->swapPoints(m_scratch);
}

void PlotStack::updateStrip(int index, double to)
{
    Strip &strip = *m_strips.at(static_cast<std::size_t>(index));
    strip.decor.gaps.clear();
    updateAxis(strip, index, false, to);
    if (!strip.decor.secondUnit.isEmpty())
        updateAxis(strip, index, true, to);
}

void PlotStack::updateAxis(Strip &strip, int index, bool second, double to)
{
    std::optional<std::pair<double, double>> seen;
    double least = 0.0;
    for (const auto &[id, trace] : m_traces) {
        if (trace.style.strip != index || !trace.visible || trace.style.secondAxis != second)
            continue;
        const auto &points = trace.plottable->points();
        const auto values = valueRange(points, m_from, m_to);
        if (values)
            seen = seen ? std::pair(std::min(seen->first, values->first), std::max(seen->second, values->second))
                        : values;
        if (values)
            least = std::max(
                least, leastSpan(trace.style.role, std::max(std::abs(values->first), std::abs(values->second))));
        if (trace.style.role == TraceRole::Setpoint)
            continue; // it idles between commands: nothing is missing
        const double shift = trace.style.aligned ? origin() : 0.0;
        for (const auto &gap : gapsIn(points, trace.source.get(), shift, std::min(to, m_live ? m_now : to))) {
            const auto same = std::find(strip.decor.gaps.begin(), strip.decor.gaps.end(), gap);
            if (same == strip.decor.gaps.end())
                strip.decor.gaps.push_back(gap);
        }
    }
    QCPAxis &values = strip.axis(second);
    AutoRange &automatic = second ? strip.secondRange : strip.range;
    const auto &fixed = second ? strip.secondFixed : strip.fixed;
    values.ticker()->setTickCount(std::clamp(strip.rect->height() / m_theme.theme().u(42), 2, 5));
    if (fixed) {
        values.setRange(fixed->first, fixed->second);
    } else if (seen) {
        const AutoRange::Range range = automatic.update(seen->first, seen->second, m_now, least);
        m_scaled = m_scaled || values.range() != QCPRange(range.lower, range.upper);
        values.setRange(range.lower, range.upper);
    }
}

QString PlotStack::valueText(const TraceStyle &style, double value) const
{
    const Strip &strip = *m_strips.at(static_cast<std::size_t>(style.strip));
    const int decimals
        = style.decimals >= 0 ? style.decimals : decimalsFor(strip.axis(style.secondAxis).range().size());
    return formatValue(value, decimals, style.unit);
}

QString PlotStack::tagText(const TraceStyle &style, double value) const
{
    TraceStyle bare = style;
    if (!style.tagUnit)
        bare.unit.clear();
    return valueText(bare, value);
}

void PlotStack::updateTags(Strip &strip, int index)
{
    strip.decor.tags.clear();
    for (const auto &[id, trace] : m_traces) {
        const TraceLook &look = trace.plottable->look();
        const bool wished = look.role == TraceRole::Setpoint || look.dash == TraceDash::Dots || trace.style.aligned;
        if (trace.style.strip != index || !trace.visible || !trace.style.valueTag || wished || !trace.source)
            continue;
        const auto value = m_live && !m_held ? trace.source->latest() : std::optional(valueAt(id, m_to));
        if (value && std::isfinite(*value))
            strip.decor.tags.push_back({tagText(trace.style, *value), *value, look, trace.style.secondAxis});
    }
}

int PlotStack::tagMargin() const
{
    int width = m_theme.theme().u(14);
    for (const auto &[id, trace] : m_traces) {
        if (trace.visible && trace.style.valueTag && trace.style.role != TraceRole::Setpoint) {
            const QString widest = formatValue(-8888.8, 1, trace.style.tagUnit ? trace.style.unit : QString());
            width = std::max(width, StripFace::tagWidth(m_theme.theme(), font(), widest));
        }
    }
    const bool second = !m_strips.empty() && m_strips.front()->decor.secondRoom > 0;
    return width + (second ? m_strips.front()->decor.secondRoom : 0);
}

void PlotStack::updateFoot()
{
    QStringList feet;
    QStringList named;
    bool loss = false;
    for (const auto &[id, trace] : m_traces) {
        const QString foot = trace.visible && trace.source ? trace.source->foot() : QString();
        if (foot.isEmpty())
            continue;
        loss = loss || trace.source->lossy();
        named << tr("%1: %2").arg(trace.style.name, foot);
        if (!feet.contains(foot))
            feet << foot;
    }
    const QString right = feet.size() == 1 ? feet.first() : named.join(QStringLiteral("  ·  "));
    const QString length = formatDuration(m_to - m_from);
    const QString state = m_live ? tr("live, %1").arg(length) : tr("paused, %1").arg(length);
    const QString shown = m_live && !m_stateText.isEmpty() ? m_stateText : state;
    m_foot->setTexts(m_footNote.isEmpty() ? shown : m_footNote, right, loss);
}

void PlotStack::updateCursorRows()
{
    if (!m_cursors->visible())
        return;
    const double a = m_cursors->key(false);
    const double b = m_cursors->key(true);
    std::vector<PlotCursors::Row> rows;
    if (m_bothValues)
        rows.push_back({tr("t", "time of both cursors"), tr("%1 → %2").arg(preciseDuration(a), preciseDuration(b))});
    rows.push_back({tr("Δt"), preciseDuration(b - a), true});
    if (std::abs(b - a) > 1e-9 && !m_bothValues)
        rows.push_back({tr("1/Δt"), formatSignificant(1 / std::abs(b - a), 4) + QChar(QChar::Nbsp) + tr("Hz")});
    int measured = 0;
    int last = 0;
    for (const auto &[id, trace] : m_traces) {
        const double difference = valueAt(id, b) - valueAt(id, a);
        if (!trace.visible || !std::isfinite(difference) || rows.size() >= 9)
            continue;
        if (m_bothValues)
            rows.push_back({trace.style.name,
                tr("%1 → %2").arg(valueText(trace.style, valueAt(id, a)), valueText(trace.style, valueAt(id, b)))});
        else
            rows.push_back({tr("Δ %1").arg(trace.style.name), valueText(trace.style, difference)});
        measured += trace.style.role != TraceRole::Setpoint ? 1 : 0;
        last = trace.style.role != TraceRole::Setpoint ? id : last;
    }
    if (measured == 1 && !m_bothValues) // there is room for more about it
        addStatistics(rows, last);
    m_cursors->setRows(std::move(rows));
}

QStringList PlotStack::cursorWords() const
{
    QStringList lines;
    for (const PlotCursors::Row &row : m_cursors->rows())
        lines << row.name + QLatin1Char(' ') + row.value;
    return lines;
}

void PlotStack::addStatistics(std::vector<PlotCursorRow> &rows, int id) const
{
    const auto found = selection(id);
    const TraceStyle &of = m_traces.at(id).style;
    if (!found)
        return;
    const auto [a, b] = cursorKeys();
    const double slope = std::abs(b - a) > 1e-9 ? (valueAt(id, b) - valueAt(id, a)) / (b - a) : 0.0;
    rows.push_back({tr("mean A…B"), valueText(of, found->mean)});
    rows.push_back({tr("min … max"), tr("%1 … %2").arg(valueText(of, found->low), valueText(of, found->high))});
    rows.push_back({tr("σ, %1 samples").arg(formatCount(static_cast<qint64>(found->count))),
        formatSignificant(found->deviation, 4) + QChar(QChar::Nbsp) + of.unit});
    rows.push_back({tr("slope"), formatSignificant(slope, 4) + QChar(QChar::Nbsp) + of.unit + tr("/s")});
}

std::optional<TraceSource::Statistics> PlotStack::selection(int trace) const
{
    const auto found = m_traces.find(trace);
    if (found == m_traces.end() || !found->second.source || !cursorsShown())
        return {};
    const double shift = found->second.style.aligned ? origin() : 0.0;
    return found->second.source->statistics(m_cursors->key(false) - shift, m_cursors->key(true) - shift);
}

double PlotStack::valueAt(int trace, double key) const
{
    const auto found = m_traces.find(trace);
    if (found == m_traces.end())
        return std::numeric_limits<double>::quiet_NaN();
    const auto &points = found->second.plottable->points();
    // Beyond the last point the trace holds its value for a moment: half a percent of the window.
    if (!points.empty() && key > points.back().key && key - points.back().key < (m_to - m_from) * 0.005)
        return points.back().value;
    return mb::valueAt(points, key);
}

QString PlotStack::summary() const
{
    QStringList parts;
    for (const auto &[id, trace] : m_traces) {
        if (!trace.visible)
            continue;
        const auto values = valueRange(trace.plottable->points(), m_from, m_to);
        const bool idles = trace.style.role == TraceRole::Setpoint;
        const double shift = trace.style.aligned ? origin() : 0.0;
        const std::size_t gaps = idles ? 0 : gapsIn(trace.plottable->points(), trace.source.get(), shift, m_to).size();
        QString part = values
            ? tr("%1 %2 to %3")
                  .arg(trace.style.name, valueText(trace.style, values->first), valueText(trace.style, values->second))
            : tr("%1 no data").arg(trace.style.name);
        const auto latest = m_live && trace.source ? trace.source->latest() : std::nullopt;
        if (latest)
            part += tr(", now %1").arg(valueText(trace.style, *latest));
        if (gaps > 0)
            part += gaps == 1 ? tr(", 1 gap") : tr(", %n gaps", nullptr, static_cast<int>(gaps));
        parts << part;
    }
    const QString length = formatDuration(m_to - m_from);
    return parts.isEmpty() ? tr("No traces") : tr("Last %1: %2").arg(length, parts.join(QStringLiteral("; ")));
}

} // namespace mb
