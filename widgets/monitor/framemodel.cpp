// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/framemodel.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"

#include <QFont>

namespace mb {
namespace {

constexpr std::size_t keptRows = 20000;
constexpr std::size_t batchLimit = 20000;

double seconds(Duration time)
{
    return std::chrono::duration<double>(time).count();
}

} // namespace

FrameModel::FrameModel(const ThemeSource &theme, QObject *parent)
    : QAbstractTableModel(parent)
    , m_theme(theme)
{
}

void FrameModel::setSource(std::shared_ptr<const TrafficLog> log, std::vector<const Family *> families, Instant origin)
{
    if (log == m_log)
        return;
    m_log = std::move(log);
    m_families = std::move(families);
    m_origin = origin;
    m_fetched = 0;
    clear();
}

void FrameModel::clear()
{
    beginResetModel();
    m_rows.clear();
    m_shown.clear();
    m_firstRow = 0;
    m_seen = 0;
    m_skipped = 0;
    m_last.clear();
    endResetModel();
}

void FrameModel::setFilter(const FrameFilter &filter)
{
    beginResetModel();
    m_filter = filter;
    m_shown.clear();
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        if (m_filter.passes(m_rows[i]))
            m_shown.push_back(m_firstRow + i);
    }
    endResetModel();
}

FrameRow FrameModel::decode(const TrafficRecord &record)
{
    FrameRow row{record, 0.0, nullptr, std::nullopt};
    const auto [last, isNew] = m_last.try_emplace(record.frame.id, record.frame.time);
    if (!isNew)
        row.sinceSame = seconds(record.frame.time - last->second);
    last->second = record.frame.time;
    for (const Family *family : m_families) {
        if (!family->decodeCan || record.frame.error)
            continue;
        row.decoded = family->decodeCan(record.frame, {});
        if (row.decoded) {
            row.family = family;
            break;
        }
    }
    return row;
}

bool FrameModel::fetch()
{
    if (!m_log)
        return false;
    m_batch.clear();
    const std::uint64_t newest = m_log->fetch(m_fetched, batchLimit, m_batch);
    if (m_batch.empty())
        return false;
    m_seen += newest - m_fetched;
    m_skipped += m_batch.front().number - m_fetched - 1;
    m_fetched = newest;
    std::vector<std::uint64_t> passing;
    for (const TrafficRecord &record : m_batch) {
        m_rows.push_back(decode(record));
        if (m_filter.passes(m_rows.back()))
            passing.push_back(m_firstRow + m_rows.size() - 1);
    }
    if (!passing.empty()) {
        const int first = static_cast<int>(m_shown.size());
        beginInsertRows({}, first, first + static_cast<int>(passing.size()) - 1);
        m_shown.insert(m_shown.end(), passing.begin(), passing.end());
        endInsertRows();
    }
    trim();
    return true;
}

void FrameModel::trim()
{
    if (m_rows.size() <= keptRows)
        return;
    const std::uint64_t first = m_firstRow + m_rows.size() - keptRows;
    int gone = 0;
    while (gone < static_cast<int>(m_shown.size()) && m_shown[static_cast<std::size_t>(gone)] < first)
        ++gone;
    if (gone > 0) {
        beginRemoveRows({}, 0, gone - 1);
        m_shown.erase(m_shown.begin(), m_shown.begin() + gone);
    }
    m_rows.erase(m_rows.begin(), m_rows.begin() + static_cast<std::ptrdiff_t>(first - m_firstRow));
    m_firstRow = first;
    if (gone > 0)
        endRemoveRows();
}

int FrameModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_shown.size());
}

int FrameModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QString FrameModel::text(const FrameRow &row, int column) const
{
    const CanFrame &frame = row.record.frame;
    switch (column) {
    case Time: return QString::number(seconds(frame.time - m_origin), 'f', 4);
    case Delta: return row.sinceSame > 0.0 ? QString::number(row.sinceSame * 1000.0, 'f', 1) : QString(UnknownMark);
    case Dir: return frame.error ? tr("err") : row.record.direction == Direction::Sent ? tr("tx") : tr("rx");
    case Id: return hexId(frame);
    case Message: return frame.error ? tr("error frame") : row.decoded ? qt(row.decoded->message) : tr("unknown");
    case Address: return row.decoded ? QString::number(row.decoded->address) : QString(UnknownMark);
    case Decoded:
        return row.decoded ? fieldsLine(*row.decoded)
            : frame.error  ? tr("class %1").arg(hexId(frame))
                           : tr("no decoder knows this identifier");
    case Data: return hexBytes(frame);
    default: return {};
    }
}

QVariant FrameModel::color(const FrameRow &row, int column) const
{
    const Theme &theme = m_theme.theme();
    if (row.record.frame.error)
        return theme.danger;
    if (column == Dir && row.record.direction == Direction::Sent)
        return theme.accent;
    if (!row.decoded && (column == Message || column == Decoded))
        return theme.caution;
    if (column == Time || column == Delta || column == Id || column == Data)
        return theme.dim;
    return {};
}

QVariant FrameModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    const FrameRow &frame = row(index.row());
    const int column = index.column();
    switch (role) {
    case Qt::DisplayRole: return text(frame, column);
    case Qt::ForegroundRole: return color(frame, column);
    case Qt::TextAlignmentRole:
        return static_cast<int>(column == Time || column == Delta || column == Address
                ? Qt::AlignRight | Qt::AlignVCenter
                : Qt::AlignLeft | Qt::AlignVCenter);
    case Qt::FontRole:
        if (column == Message && frame.decoded)
            return m_theme.theme().font(TextRole::Emphasis, {});
        return column == Id || column == Data ? m_theme.theme().font(TextRole::Raw, {}) : QVariant();
    default: return {};
    }
}

QVariant FrameModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return static_cast<int>(section == Time || section == Delta || section == Address
                ? Qt::AlignRight | Qt::AlignVCenter
                : Qt::AlignLeft | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Time: return tr("t, s");
    case Delta: return tr("Δ ms");
    case Dir: return tr("dir");
    case Id: return tr("id");
    case Message: return tr("message");
    case Address: return tr("dev");
    case Decoded: return tr("decoded");
    case Data: return tr("data");
    default: return {};
    }
}

} // namespace mb
