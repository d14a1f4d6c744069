// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"
#include "widgets/monitor/frametext.h"
#include "widgets/monitor/idmodel.h"
#include "widgets/monitor/trafficdelegate.h"

#include <algorithm>

namespace mb {
namespace {

constexpr Duration trailTime = std::chrono::seconds(5);
constexpr Duration highlightTime = std::chrono::milliseconds(700);

bool isNumber(int column)
{
    return column == IdModel::Address || column == IdModel::Rate || column == IdModel::Jitter
        || column == IdModel::Count;
}

QString millisecondsText(const std::optional<double> &seconds, int decimals)
{
    return seconds ? formatNumber(*seconds * 1000.0, decimals) : QString(UnknownMark);
}

} // namespace

int IdModel::fieldOf(const Row &row) const
{
    const FrameMeaning *known = meaningOf(row);
    if (!known || known->frame.fields.empty())
        return -1;
    const auto &fields = known->frame.fields;
    const auto chosen = m_fields.constFind(qt(known->frame.message));
    if (chosen != m_fields.constEnd()) {
        for (std::size_t i = 0; i < fields.size(); ++i) {
            if (qt(fields[i].name) == *chosen)
                return static_cast<int>(i);
        }
    }
    return static_cast<int>(tellingField(known->frame).value_or(0));
}

void IdModel::chooseField(int index, const QString &name)
{
    const FrameMeaning *known = meaning(index);
    if (!known)
        return;
    m_fields[qt(known->frame.message)] = name;
    Q_EMIT dataChanged(this->index(0, Value), this->index(rowCount() - 1, Spark));
}

QString IdModel::valueText(const Row &row) const
{
    if (row.traffic.key.error)
        return errorFrameText(row.traffic.last);
    const int field = fieldOf(row);
    if (field < 0)
        return UnknownMark;
    const DecodedField &shown = row.meaning->frame.fields[static_cast<std::size_t>(field)];
    return fieldValue(shown) + QStringLiteral("  ") + qt(shown.name);
}

QString IdModel::text(const Row &row, int column) const
{
    const TrafficRow &traffic = row.traffic;
    switch (column) {
    case Id: return traffic.key.error ? QString(UnknownMark) : hexId(traffic.last);
    case Dir: return traffic.key.error ? tr("err") : traffic.key.direction == Direction::Sent ? tr("tx") : tr("rx");
    case Message: {
        const FrameMeaning *known = meaningOf(row);
        return traffic.key.error ? tr("error frame") : known ? qt(known->frame.message) : tr("unknown");
    }
    case Address: {
        const FrameMeaning *known = meaningOf(row);
        return known ? addressText(known->frame) : QString(UnknownMark);
    }
    case Rate: return formatNumber(traffic.rate, 0);
    case Jitter: return millisecondsText(traffic.jitter, 2);
    case Count: return formatCount(static_cast<qint64>(traffic.count));
    case Data: return hexBytes(traffic.last);
    case Value: return valueText(row);
    default: return {};
    }
}

QString IdModel::tip(const Row &row, int column) const
{
    const TrafficRow &traffic = row.traffic;
    if (column == Rate || column == Jitter)
        return tr("every %1 ms, standard deviation %2 ms, largest deviation %3 ms, over the last 32 periods")
            .arg(millisecondsText(traffic.period, 2), millisecondsText(traffic.jitter, 3),
                millisecondsText(traffic.worst, 3));
    const FrameMeaning *known = meaningOf(row);
    if ((column == Value || column == Spark) && known)
        return fieldsLine(known->frame) + QLatin1Char('\n') + tr("Right click: choose the field");
    return {};
}

int IdModel::changedLately(const TrafficRow &row) const
{
    int mask = 0;
    for (std::size_t i = 0; i < row.changed.size(); ++i) {
        if (row.changed[i] != Instant{} && m_now - row.changed[i] < highlightTime)
            mask |= 1 << i;
    }
    return mask;
}

QVariant IdModel::spark(const Row &row) const
{
    const int field = fieldOf(row);
    if (field < 0)
        return {};
    if (field != row.trailField) {
        row.trail.clear();
        row.trailEnd = {};
        row.trailField = field;
    }
    std::vector<CanFrame> frames;
    m_log->trail(row.traffic.key, row.trailEnd, frames);
    for (const CanFrame &frame : frames) {
        row.trailEnd = frame.time;
        const auto known = m_decoder.decode(frame);
        if (known && static_cast<std::size_t>(field) < known->frame.fields.size())
            row.trail.emplace_back(frame.time, known->frame.fields[static_cast<std::size_t>(field)].value);
    }
    while (!row.trail.empty() && m_now - row.trail.front().first > trailTime)
        row.trail.pop_front();
    // One point each 50 ms; between its frames an identifier holds its value.
    constexpr int points = 100;
    QVector<double> values;
    values.reserve(points);
    double last = qQNaN();
    auto next = row.trail.begin();
    for (int i = 1; i <= points; ++i) {
        const Instant end = m_now - trailTime + i * (trailTime / points);
        for (; next != row.trail.end() && next->first <= end; ++next)
            last = next->second;
        values.append(last);
    }
    return QVariant::fromValue(values);
}

QVariant IdModel::color(const Row &row, int column) const
{
    const Theme &theme = m_theme.theme();
    if (row.traffic.key.error)
        return theme.danger;
    if (column == Dir)
        return row.traffic.key.direction == Direction::Sent ? theme.accent : theme.dim;
    if (column == Message && !meaningOf(row))
        return theme.dim;
    if (row.traffic.rate == 0.0 && (column == Rate || column == Value))
        return theme.faint;
    return column == Data || column == Jitter || column == Count ? theme.dim : theme.text;
}

QVariant IdModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const Row &row = shown(index.row());
    const int column = index.column();
    switch (role) {
    case Qt::DisplayRole: return text(row, column);
    case Qt::ForegroundRole: return color(row, column);
    case Qt::ToolTipRole: return tip(row, column);
    case Qt::TextAlignmentRole:
        return static_cast<int>(Qt::AlignVCenter | (isNumber(column) ? Qt::AlignRight : Qt::AlignLeft));
    case TrafficDelegate::TextRoleRole:
        if (column == Message && meaningOf(row))
            return static_cast<int>(TextRole::Emphasis);
        return static_cast<int>(column == Id || column == Data ? TextRole::Raw : TextRole::Body);
    case TrafficDelegate::DirectionRole:
        if (column != Dir)
            return {};
        return row.traffic.key.error                       ? TrafficDelegate::ErrorMark
            : row.traffic.key.direction == Direction::Sent ? TrafficDelegate::SentMark
                                                           : TrafficDelegate::ReceivedMark;
    case TrafficDelegate::BytesRole: return column == Data ? QVariant(changedLately(row.traffic)) : QVariant();
    case TrafficDelegate::SparkRole: return column == Spark ? spark(row) : QVariant();
    default: return {};
    }
}

QVariant IdModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return static_cast<int>(Qt::AlignVCenter | (isNumber(section) ? Qt::AlignRight : Qt::AlignLeft));
    if (role == Qt::ToolTipRole && section == Jitter)
        return tr("Standard deviation of the last 32 periods");
    if (role == Qt::ToolTipRole && section == Data)
        return tr("The last frame; bytes that changed within 0.7 s are marked");
    if (role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Id: return tr("id");
    case Dir: return tr("dir");
    case Message: return tr("message");
    case Address: return tr("dev");
    case Rate: return tr("rate Hz");
    case Jitter: return tr("jitter ms");
    case Count: return tr("frames");
    case Data: return tr("data");
    case Value: return tr("last value");
    case Spark: return tr("last 5 s");
    default: return {};
    }
}

} // namespace mb
