// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotreadings.h"

#include "widgets/common/clocktext.h"
#include "widgets/common/numberformat.h"
#include "widgets/plots/telemetrysource.h"

#include <QRegularExpression>
#include <QTextStream>
#include <cmath>
#include <map>

namespace mb {
namespace {

constexpr double rounding = 1e-6;     ///< seconds; of a key
constexpr double silence = 0.25;      ///< seconds; shorter than that only a loss is a gap
constexpr int TableColumns = 1 << 20; ///< so many that a source hands out every sample

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

QString csvField(const QString &text)
{
    static const QRegularExpression special(QStringLiteral("[,\"\r\n]"));
    if (!text.contains(special))
        return text;
    return QLatin1Char('"') + QString(text).replace(QLatin1Char('"'), QStringLiteral("\"\"")) + QLatin1Char('"');
}

QString csvNumber(double value)
{
    return std::isfinite(value) ? QString::number(value, 'g', 12) : QString();
}

/// A gap is said, as in the files of recordings: an empty field is of a time at which others have a sample.
QString tableNumber(double value)
{
    return std::isfinite(value) ? csvNumber(value) : QStringLiteral("nan");
}

} // namespace

std::vector<std::pair<double, double>> missingIn(const PlotTrace &trace, double origin, double to)
{
    const double shift = trace.shift(origin);
    auto gaps = gapsOf(trace.plottable->points(), to);
    std::erase_if(gaps, [&trace, shift](const std::pair<double, double> &gap) {
        if (!trace.source || gap.second - gap.first >= silence)
            return false;
        const auto found = trace.source->statistics(gap.first - shift - rounding, gap.second - shift + rounding);
        return found && found->lost == 0;
    });
    return gaps;
}

void joinUnlost(std::vector<PlotPoint> &points, const TraceSource &source)
{
    if (points.empty())
        return;
    std::vector<std::pair<double, double>> gaps = gapsOf(points, points.back().key);
    std::erase_if(gaps, [&source](const std::pair<double, double> &gap) {
        const auto found = source.statistics(gap.first - rounding, gap.second + rounding);
        return gap.second - gap.first >= silence || !found || found->lost > 0;
    });
    std::erase_if(points, [&gaps](const PlotPoint &point) {
        return !std::isfinite(point.value) && std::ranges::any_of(gaps, [&point](const std::pair<double, double> &gap) {
            return point.key >= gap.first && point.key < gap.second;
        });
    });
}

double PlotReadings::valueAt(int trace, double key) const
{
    const PlotTrace *found = m_strips.trace(trace);
    if (!found)
        return std::numeric_limits<double>::quiet_NaN();
    const auto &points = found->plottable->points();
    // Beyond the last point the trace holds its value for a moment: half a percent of the window.
    if (!points.empty() && key > points.back().key && key - points.back().key < m_view.span() * 0.005)
        return points.back().value;
    const auto exact = found->source ? found->source->valueAt(key - found->shift(m_view.origin())) : std::nullopt;
    return exact ? *exact : mb::valueAt(points, key);
}

std::optional<double> PlotReadings::middleOf(int trace) const
{
    const PlotTrace *found = m_strips.trace(trace);
    if (!found)
        return {};
    const auto [from, to] = m_view.range();
    const auto values = valueRange(found->plottable->points(), from, to);
    return values ? std::optional((values->first + values->second) / 2) : std::nullopt;
}

std::pair<double, double> PlotReadings::cursorKeys() const
{
    return {m_strips.cursors().key(false), m_strips.cursors().key(true)};
}

std::optional<TraceSource::Statistics> PlotReadings::selection(int trace) const
{
    const PlotTrace *found = m_strips.trace(trace);
    if (!found || !found->source || !m_strips.cursors().visible())
        return {};
    const double shift = found->shift(m_view.origin());
    const auto [a, b] = cursorKeys();
    return found->source->statistics(a - shift, b - shift);
}

QString PlotReadings::valueText(const TraceStyle &style, double value) const
{
    const QCPAxis &axis = m_strips.at(style.strip).axis(style.secondAxis);
    return formatValue(value,
        style.decimals >= 0 ? style.decimals : std::min(decimalsFor(axis.range().size()), style.mostDecimals),
        style.unit);
}

std::vector<PlotCursorRow> PlotReadings::cursorRows() const
{
    const auto [a, b] = cursorKeys();
    std::vector<PlotCursorRow> rows;
    if (m_bothValues)
        rows.push_back({tr("t", "time of both cursors"), tr("%1 → %2").arg(preciseDuration(a), preciseDuration(b))});
    rows.push_back({tr("Δt"), preciseDuration(b - a), true});
    if (std::abs(b - a) > 1e-9 && !m_bothValues)
        rows.push_back({tr("1/Δt"), formatSignificant(1 / std::abs(b - a), 4) + QChar(QChar::Nbsp) + tr("Hz")});
    int measured = 0;
    int last = 0;
    for (const auto &[id, trace] : m_strips.traces()) {
        const double difference = valueAt(id, b) - valueAt(id, a);
        if (!trace.visible || !std::isfinite(difference))
            continue;
        const int strip = trace.style.strip;
        const bool alone = std::ranges::count_if(m_strips.traces(), [strip](const auto &other) {
            return other.second.visible && other.second.style.strip == strip;
        }) == 1;
        if (m_bothValues)
            rows.push_back({trace.style.name,
                tr("%1 → %2").arg(valueText(trace.style, valueAt(id, a)), valueText(trace.style, valueAt(id, b))),
                false, strip});
        else
            rows.push_back({tr("Δ %1").arg(trace.style.name), valueText(trace.style, difference), false, strip,
                alone ? tr("Δ %1").arg(QString()).trimmed() : QString()});
        measured += trace.style.role != TraceRole::Setpoint ? 1 : 0;
        last = trace.style.role != TraceRole::Setpoint ? id : last;
    }
    if (measured == 1 && !m_bothValues) // there is room for more about it
        addStatistics(rows, last);
    return rows;
}

void PlotReadings::addStatistics(std::vector<PlotCursorRow> &rows, int id) const
{
    const auto found = selection(id);
    const TraceStyle &of = m_strips.trace(id)->style;
    if (!found)
        return;
    const auto [a, b] = cursorKeys();
    const double slope = std::abs(b - a) > 1e-9 ? (valueAt(id, b) - valueAt(id, a)) / (b - a) : 0.0;
    const auto add = [&](const QString &name, const QString &value) { rows.push_back({name, value, false, of.strip}); };
    add(tr("mean A…B"), valueText(of, found->mean));
    add(tr("min … max"), tr("%1 … %2").arg(valueText(of, found->low), valueText(of, found->high)));
    add(tr("σ, %1 samples").arg(formatCount(static_cast<qint64>(found->count))),
        formatSignificant(found->deviation, 4) + QChar(QChar::Nbsp) + of.unit);
    add(tr("slope"), formatSignificant(slope, 4) + QChar(QChar::Nbsp) + of.unit + tr("/s"));
}

QStringList PlotReadings::cursorWords() const
{
    QStringList lines;
    for (const PlotCursorRow &row : m_strips.cursors().rows())
        lines << row.name + QLatin1Char(' ') + row.value;
    return lines;
}

QString PlotReadings::summaryOf(const PlotTrace &trace) const
{
    const auto [from, to] = m_view.range();
    const auto values = valueRange(trace.plottable->points(), from, to);
    const bool idles = trace.style.role == TraceRole::Setpoint;
    const std::size_t gaps = idles ? 0 : missingIn(trace, m_view.origin(), to).size();
    QString part = values
        ? tr("%1 %2 to %3")
              .arg(trace.style.name, valueText(trace.style, values->first), valueText(trace.style, values->second))
        : tr("%1 no data").arg(trace.style.name);
    const auto latest = m_view.isLive() && trace.source ? trace.source->latest() : std::nullopt;
    if (latest)
        part += tr(", now %1").arg(valueText(trace.style, *latest));
    if (gaps > 0)
        part += gaps == 1 ? tr(", 1 gap") : tr(", %n gaps", nullptr, static_cast<int>(gaps));
    return part;
}

QString PlotReadings::summary() const
{
    QStringList parts;
    for (const auto &[id, trace] : m_strips.traces()) {
        if (trace.visible)
            parts << summaryOf(trace);
    }
    const QString length = formatDuration(m_view.span());
    return parts.isEmpty() ? tr("No traces") : tr("Last %1: %2").arg(length, parts.join(QStringLiteral("; ")));
}

QString PlotReadings::numbers() const
{
    const QChar tab = QLatin1Char('\t');
    const auto [a, b] = m_strips.cursors().visible() ? cursorKeys() : m_view.range();
    QString table = QStringLiteral("trace\tunit\tA\tB\tB-A\tmean\tdeviation\tmin\tmax\tsamples\tlost\n");
    table += QStringLiteral("time\ts\t%1\t%2\t%3\t\t\t\t\t\t\n")
                 .arg(QString::number(a, 'f', 6), QString::number(b, 'f', 6), csvNumber(b - a));
    for (const auto &[id, trace] : m_strips.traces()) {
        if (!trace.visible || !trace.source)
            continue;
        const double shift = trace.shift(m_view.origin());
        const auto found = trace.source->statistics(a - shift, b - shift);
        QStringList fields{trace.style.name, trace.style.unit, csvNumber(valueAt(id, a)), csvNumber(valueAt(id, b)),
            csvNumber(valueAt(id, b) - valueAt(id, a))};
        if (found)
            fields << csvNumber(found->mean) << csvNumber(found->deviation) << csvNumber(found->low)
                   << csvNumber(found->high) << QString::number(found->count) << QString::number(found->lost);
        table += fields.join(tab) + QLatin1Char('\n');
    }
    return table;
}

QString PlotReadings::tableHead(double from, double to) const
{
    QString head;
    if (const auto &clock = m_strips.clock()) {
        const double unixTime = from + clockShift(*clock, from);
        head = QStringLiteral("# time_s 0 is %1 (Unix %2)\n")
                   .arg(momentOf(unixTime).toUTC().toString(Qt::ISODateWithMs), QString::number(unixTime, 'f', 6));
    }
    for (const auto &[id, trace] : m_strips.traces()) {
        const auto found = trace.visible && trace.source ? trace.source->statistics(from, to) : std::nullopt;
        if (found && found->lost > 0)
            head += QStringLiteral("# loss: %1 = %2 of %3 lost\n")
                        .arg(QString(trace.style.name).replace(QLatin1Char('\n'), QLatin1Char(' ')))
                        .arg(found->lost)
                        .arg(found->count + found->lost);
    }
    return head;
}

QByteArray PlotReadings::table() const
{
    struct Column {
        std::vector<PlotPoint> points;
        std::size_t next = 0;
    };
    const auto [from, to] = m_view.range();
    const auto &clock = m_strips.clock();
    const auto time = [&clock, from = from](double key) {
        return clock ? key - from + clockShift(*clock, key) - clockShift(*clock, from) : key;
    };
    QStringList head{QStringLiteral("time_s")};
    std::vector<Column> columns;
    std::map<double, int>
        rows; // of a key as many as the trace with most points there has: a gap stands at its sample's
    for (const auto &[id, trace] : m_strips.traces()) {
        if (!trace.visible || !trace.source)
            continue;
        head << csvField(trace.style.unit.isEmpty()
                ? trace.style.name
                : QStringLiteral("%1 (%2)").arg(trace.style.name, trace.style.unit));
        Column &column = columns.emplace_back();
        trace.source->columns(from, to, TableColumns, column.points);
        int here = 0;
        for (std::size_t i = 0; i < column.points.size(); ++i) {
            const double key = column.points[i].key;
            here = i > 0 && column.points[i - 1].key == key ? here + 1 : 1;
            if (key >= from && key <= to)
                rows[key] = std::max(rows[key], here);
        }
    }
    QByteArray content;
    QTextStream out(&content);
    out.setCodec("UTF-8");
    out << tableHead(from, to) << head.join(QLatin1Char(',')) << '\n';
    const auto writeRow = [&](double key) {
        out << QString::number(time(key), 'f', 6);
        for (Column &column : columns) {
            while (column.next < column.points.size() && column.points[column.next].key < key)
                ++column.next;
            const bool here = column.next < column.points.size() && column.points[column.next].key == key;
            out << ',' << (here ? tableNumber(column.points[column.next++].value) : QString());
        }
        out << '\n';
    };
    for (const auto &[key, count] : rows) {
        for (int i = 0; i < count; ++i)
            writeRow(key);
    }
    out.flush();
    return content;
}

} // namespace mb
