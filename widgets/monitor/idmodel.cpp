// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/idmodel.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"
#include "widgets/monitor/frametext.h"
#include "widgets/monitor/trafficdelegate.h"

#include <algorithm>

namespace mb {
namespace {

constexpr Duration trailTime = std::chrono::seconds(5);
constexpr Duration highlightTime = std::chrono::milliseconds(700);
constexpr double wholeJitterFrom = 0.1; ///< s of jitter, which has no decimals then

bool isNumber(int column)
{
    return column == IdModel::Address || column == IdModel::Rate || column == IdModel::Jitter
        || column == IdModel::Count;
}

/// Of what comes no more it says nothing.
std::optional<double> jitterOf(const TrafficRow &traffic, Instant now)
{
    constexpr double latePeriods = 2.0;
    const double silent = std::chrono::duration<double>(now - traffic.last.time).count();
    const bool comes = traffic.rate > 0.0 || silent < latePeriods * traffic.period.value_or(0.0);
    return comes ? traffic.jitter : std::nullopt;
}

QString millisecondsText(const std::optional<double> &seconds, int decimals)
{
    return seconds ? formatNumber(*seconds * 1000.0, decimals) : QString(UnknownMark);
}

} // namespace

IdModel::IdModel(const ThemeSource &theme, QObject *parent)
    : QAbstractTableModel(parent)
    , m_theme(theme)
{
}

void IdModel::setSource(std::shared_ptr<const TrafficLog> log)
{
    if (log == m_log)
        return;
    beginResetModel();
    m_log = std::move(log);
    m_rows.clear();
    m_shown.clear();
    m_unlisted = 0;
    endResetModel();
}

void IdModel::setDecoder(FrameDecoder decoder)
{
    if (decoder == m_decoder)
        return;
    m_decoder = std::move(decoder);
    for (Row &row : m_rows) {
        row.decodedAt = 0;
        row.trailField = -1;
    }
    setFilter(m_filter);
}

void IdModel::setFilter(FrameFilter filter)
{
    m_filter = std::move(filter);
    for (Row &row : m_rows) {
        row.passed = false;
        look(row);
    }
    showPassed();
}

void IdModel::look(Row &row)
{
    if (row.passed)
        return;
    const TrafficRecord record{0, row.traffic.key.direction, row.traffic.last};
    row.passed = m_filter.passes({record, m_decoder});
}

void IdModel::refresh(Instant now)
{
    if (!m_log)
        return;
    m_now = now;
    m_batch.clear();
    m_unlisted = m_log->statistics(now, m_batch);
    m_rows.resize(std::max(m_rows.size(), m_batch.size()));
    for (std::size_t i = 0; i < m_batch.size(); ++i) {
        m_rows[i].traffic = m_batch[i];
        look(m_rows[i]);
    }
    showPassed();
    if (rowCount() > 0)
        Q_EMIT dataChanged(index(0, Rate), index(rowCount() - 1, Spark));
}

void IdModel::showPassed()
{
    // Rows leave and come one by one, so that selection and place of the others stay.
    for (std::size_t i = m_shown.size(); i-- > 0;) {
        if (m_rows[m_shown[i]].passed)
            continue;
        beginRemoveRows({}, static_cast<int>(i), static_cast<int>(i));
        m_shown.erase(m_shown.begin() + static_cast<std::ptrdiff_t>(i));
        endRemoveRows();
    }
    std::vector<bool> isShown(m_rows.size(), false);
    for (const std::size_t place : m_shown)
        isShown[place] = true;
    for (std::size_t place = 0; place < m_rows.size(); ++place) {
        if (isShown[place] || !m_rows[place].passed)
            continue;
        const auto at
            = std::ranges::find_if(m_shown, [this, place](std::size_t other) { return before(place, other); });
        const int number = static_cast<int>(at - m_shown.begin());
        beginInsertRows({}, number, number);
        m_shown.insert(at, place);
        endInsertRows();
    }
}

bool IdModel::before(std::size_t a, std::size_t b) const
{
    if (m_sortOrder == Qt::DescendingOrder)
        std::swap(a, b);
    const TrafficRow &left = m_rows[a].traffic;
    const TrafficRow &right = m_rows[b].traffic;
    const auto by = [&](auto value) {
        const auto x = value(a);
        const auto y = value(b);
        return x == y ? left.key < right.key : x < y;
    };
    switch (m_sortColumn) {
    case Dir: return by([this](std::size_t i) { return m_rows[i].traffic.key.direction; });
    case Message: return by([this](std::size_t i) { return text(m_rows[i], Message); });
    case Address:
        return by([this](std::size_t i) {
            const FrameMeaning *known = meaningOf(m_rows[i]);
            return known ? known->frame.address : -1;
        });
    case Rate: return by([this](std::size_t i) { return m_rows[i].traffic.rate; });
    case Jitter: return by([this](std::size_t i) { return jitterOf(m_rows[i].traffic, m_now).value_or(-1.0); });
    case Count: return by([this](std::size_t i) { return m_rows[i].traffic.count; });
    default: return left.key < right.key;
    }
}

void IdModel::sort(int column, Qt::SortOrder order)
{
    Q_EMIT layoutAboutToBeChanged({}, QAbstractItemModel::VerticalSortHint);
    m_sortColumn = column;
    m_sortOrder = order;
    const std::vector<std::size_t> old = m_shown;
    std::ranges::sort(m_shown, [this](std::size_t a, std::size_t b) { return before(a, b); });
    const QModelIndexList kept = persistentIndexList();
    for (const QModelIndex &from : kept) {
        const auto to = std::ranges::find(m_shown, old[static_cast<std::size_t>(from.row())]);
        changePersistentIndex(from, index(static_cast<int>(to - m_shown.begin()), from.column()));
    }
    Q_EMIT layoutChanged({}, QAbstractItemModel::VerticalSortHint);
}

const FrameMeaning *IdModel::meaningOf(const Row &row) const
{
    if (row.decodedAt != row.traffic.count) {
        row.meaning = m_decoder.decode(row.traffic.last);
        row.decodedAt = row.traffic.count;
    }
    return row.meaning ? &*row.meaning : nullptr;
}

const TrafficRow *IdModel::busiest() const
{
    const auto found
        = std::ranges::max_element(m_rows, [](const Row &a, const Row &b) { return a.traffic.rate < b.traffic.rate; });
    return found == m_rows.end() || found->traffic.rate <= 0.0 ? nullptr : &found->traffic;
}

int IdModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_shown.size());
}

int IdModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

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
    return fieldName(shown) + QLatin1Char(' ') + fieldValue(shown);
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
    case Jitter:
        return millisecondsText(jitterOf(traffic, m_now), traffic.jitter.value_or(0.0) < wholeJitterFrom ? 2 : 0);
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
        return wireLine(known->frame) + QLatin1Char('\n') + tr("Right click: choose the field");
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
