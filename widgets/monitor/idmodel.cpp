// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/idmodel.h"

#include <algorithm>

namespace mb {

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
        const auto at = std::find_if(
            m_shown.begin(), m_shown.end(), [this, place](std::size_t other) { return before(place, other); });
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
    case Jitter: return by([this](std::size_t i) { return m_rows[i].traffic.jitter.value_or(-1.0); });
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
    std::sort(m_shown.begin(), m_shown.end(), [this](std::size_t a, std::size_t b) { return before(a, b); });
    const QModelIndexList kept = persistentIndexList();
    for (const QModelIndex &from : kept) {
        const auto to = std::find(m_shown.begin(), m_shown.end(), old[static_cast<std::size_t>(from.row())]);
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
    const auto found = std::max_element(
        m_rows.begin(), m_rows.end(), [](const Row &a, const Row &b) { return a.traffic.rate < b.traffic.rate; });
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

} // namespace mb
