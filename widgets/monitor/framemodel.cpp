// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/framemodel.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"
#include "widgets/monitor/frametext.h"
#include "widgets/monitor/trafficdelegate.h"

#include <algorithm>
#include <utility>

namespace mb {
namespace {

constexpr std::size_t batchLimit = 65536;
constexpr std::size_t scanStep = 4000;

/// Of all packets that some bytes complete, in their order.
template <class Text> QString packetsText(const std::vector<FrameMeaning> &packets, const Text &textOf)
{
    QStringList parts;
    for (const FrameMeaning &each : packets) {
        if (const QString text = textOf(each); !text.isEmpty())
            parts << text;
    }
    return parts.join(QStringLiteral(" · "));
}

double secondsOf(Duration time)
{
    return std::chrono::duration<double>(time).count();
}

} // namespace

FrameModel::FrameModel(const ThemeSource &theme, QObject *parent)
    : QAbstractTableModel(parent)
    , m_theme(theme)
{
    m_scan.setInterval(0);
    connect(&m_scan, &QTimer::timeout, this, [this] { scanBack(scanStep); });
}

void FrameModel::setSource(std::shared_ptr<const TrafficLog> log, LinkKind kind)
{
    if (log == m_log)
        return;
    m_log = std::move(log);
    m_succession = FrameSuccession(kind);
    m_origin = {};
    m_joins = true;
    m_begin = 0;
    m_fetched = 0;
    clear();
}

void FrameModel::setDecoder(FrameDecoder decoder)
{
    if (decoder == m_decoder)
        return;
    m_decoder = std::move(decoder);
    m_meanings.fill({});
    if (!m_filter.isEmpty())
        restart();
    else if (rowCount() > 0)
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

void FrameModel::clear()
{
    beginResetModel();
    m_live = {};
    if (m_frozen)
        *m_frozen = {};
    m_shown.clear();
    m_unscanned = 0;
    m_scan.stop();
    m_skipped = 0;
    m_begin = m_fetched;
    m_succession.forgetTimes();
    m_meanings.fill({});
    endResetModel();
}

void FrameModel::setFilter(FrameFilter filter)
{
    m_filter = std::move(filter);
    restart();
}

void FrameModel::restart()
{
    beginResetModel();
    m_shown.clear();
    m_unscanned = m_shownStore->end();
    endResetModel();
    scanBack(m_filter.isEmpty() ? keptRows : scanStep);
}

void FrameModel::scanBack(std::size_t limit)
{
    std::vector<std::uint64_t> found;
    const Store &store = *m_shownStore;
    for (; m_unscanned > store.first && limit > 0; --limit) {
        --m_unscanned;
        if (m_filter.isEmpty() || passes(store.rows[m_unscanned - store.first]))
            found.push_back(m_unscanned);
    }
    if (!found.empty()) {
        beginInsertRows({}, 0, static_cast<int>(found.size()) - 1);
        m_shown.insert(m_shown.begin(), found.rbegin(), found.rend());
        endInsertRows();
        Q_EMIT olderFound();
    }
    if (m_unscanned > store.first)
        m_scan.start();
    else
        m_scan.stop();
}

void FrameModel::setSearch(FrameFilter search)
{
    m_search = std::move(search);
    if (rowCount() > 0)
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1), {Qt::BackgroundRole});
}

int FrameModel::findFrom(int from, bool forward) const
{
    if (m_search.isEmpty())
        return -1;
    for (int i = from; i >= 0 && i < rowCount(); i += forward ? 1 : -1) {
        if (m_search.passes({row(i).record, m_decoder, row(i).asked, row(i).packet()}))
            return i;
    }
    return -1;
}

void FrameModel::setFrozen(bool frozen)
{
    if (frozen == isFrozen())
        return;
    if (frozen) {
        // The numbers in m_shown stay valid: the copy counts as the original does.
        m_frozen = std::make_unique<Store>(m_live);
        m_shownStore = m_frozen.get();
        return;
    }
    m_shownStore = &m_live;
    restart();
    m_frozen.reset();
}

void FrameModel::keep(TrafficRecord record)
{
    m_live.rows.push_back(m_succession.next(std::move(record)));
}

bool FrameModel::fetch()
{
    if (!m_log)
        return false;
    m_batch.clear();
    const std::uint64_t newest = m_log->fetch(m_fetched, batchLimit, m_batch);
    if (m_batch.empty())
        return false;
    if (m_origin == Instant{})
        m_origin = m_log->firstTime();
    if (!m_joins)
        m_skipped += m_batch.front().number - m_fetched - 1;
    m_joins = false;
    m_fetched = newest;
    std::vector<std::uint64_t> passing;
    for (TrafficRecord &record : m_batch) {
        keep(std::move(record));
        if (!isFrozen() && passes(m_live.rows.back()))
            passing.push_back(m_live.end() - 1);
    }
    if (!passing.empty()) {
        const int first = static_cast<int>(m_shown.size());
        beginInsertRows({}, first, first + static_cast<int>(passing.size()) - 1);
        m_shown.insert(m_shown.end(), passing.begin(), passing.end());
        endInsertRows();
    }
    trim();
    return !passing.empty();
}

void FrameModel::trim()
{
    if (m_live.rows.size() <= keptRows)
        return;
    const std::uint64_t first = m_live.end() - keptRows;
    const auto shownEnd = isFrozen() ? m_shown.begin() : std::lower_bound(m_shown.begin(), m_shown.end(), first);
    const auto gone = static_cast<int>(shownEnd - m_shown.begin());
    if (gone > 0)
        beginRemoveRows({}, 0, gone - 1);
    m_shown.erase(m_shown.begin(), shownEnd);
    m_live.rows.erase(m_live.rows.begin(), m_live.rows.begin() + static_cast<std::ptrdiff_t>(first - m_live.first));
    m_live.first = first;
    if (!isFrozen())
        m_unscanned = std::max(m_unscanned, first);
    if (gone > 0)
        endRemoveRows();
}

const FrameRow &FrameModel::row(int index) const
{
    return m_shownStore->rows[m_shown[static_cast<std::size_t>(index)] - m_shownStore->first];
}

const FrameMeaning *FrameModel::meaning(const FrameRow &row) const
{
    if (const FrameMeaning *packet = row.packet())
        return packet;
    Cached &cached = m_meanings.at(row.record.number % m_meanings.size());
    if (cached.number != row.record.number) {
        cached.number = row.record.number;
        cached.meaning = row.record.isFrame() ? m_decoder.decode(row.record.frame) : std::nullopt;
        if (cached.meaning && row.asked)
            cached.meaning->frame.address = *row.asked;
    }
    return cached.meaning ? &*cached.meaning : nullptr;
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
    const TrafficRecord &record = row.record;
    const CanFrame &frame = record.frame;
    const FrameMeaning *known = meaning(row);
    switch (column) {
    case Time: return editText(secondsOf(frame.time - m_origin), 4);
    case Delta: return row.sinceSame > 0.0 ? editText(row.sinceSame * 1000.0, 1) : QString(UnknownMark);
    case Dir: return frame.error ? tr("err") : record.direction == Direction::Sent ? tr("tx") : tr("rx");
    case Id: return record.isFrame() && !frame.error ? hexId(frame) : QString(UnknownMark);
    case Message:
        return row.said ? packetsText(*row.said, [](const FrameMeaning &each) { return qt(each.frame.message); })
            : !record.isFrame() ? tr("%1 bytes").arg(record.length)
            : frame.error       ? tr("error frame")
            : known             ? qt(known->frame.message)
                                : tr("unknown");
    case Address: return known ? addressText(known->frame) : QString(UnknownMark);
    case Decoded:
        return frame.error     ? errorFrameText(frame)
            : row.said         ? packetsText(*row.said, [](const FrameMeaning &each) { return fieldsLine(each.frame); })
            : known            ? fieldsLine(known->frame)
            : frame.remote     ? tr("asks for data")
            : record.isFrame() ? tr("no decoder knows this identifier")
                               : QString();
    case Data: return record.isFrame() ? hexBytes(frame) : hexBytes(record.bytes);
    default: return {};
    }
}

QVariant FrameModel::color(const FrameRow &row, int column) const
{
    const Theme &theme = m_theme.theme();
    const TrafficRecord &record = row.record;
    if (record.frame.error)
        return column == Time || column == Decoded ? theme.text : theme.danger;
    if (column == Dir)
        return record.direction == Direction::Sent ? theme.accent : theme.dim;
    if (column == Time || column == Delta || column == Data)
        return theme.dim;
    if ((column == Message || column == Decoded) && record.isFrame() && !meaning(row))
        return column == Message ? theme.dim : theme.caution;
    return theme.text;
}

QVariant FrameModel::background(const FrameRow &row) const
{
    if (row.record.frame.error)
        return m_theme.theme().bannerDanger;
    if (!m_search.isEmpty() && m_search.passes({row.record, m_decoder, row.asked, row.packet()}))
        return m_theme.theme().bannerCaution;
    return {};
}

QVariant FrameModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const FrameRow &frame = row(index.row());
    const int column = index.column();
    switch (role) {
    case Qt::DisplayRole: return text(frame, column);
    case Qt::ToolTipRole: {
        const FrameMeaning *known = column == Decoded ? meaning(frame) : nullptr;
        return known ? QVariant(wireLine(known->frame)) : QVariant();
    }
    case Qt::ForegroundRole: return color(frame, column);
    case Qt::BackgroundRole: return background(frame);
    case Qt::TextAlignmentRole:
        return static_cast<int>(Qt::AlignVCenter
            | (column == Time || column == Delta || column == Address ? Qt::AlignRight : Qt::AlignLeft));
    case TrafficDelegate::TextRoleRole:
        if (column == Message && meaning(frame))
            return static_cast<int>(TextRole::Emphasis);
        return static_cast<int>(
            column == Time || column == Delta || column == Id || column == Data ? TextRole::Raw : TextRole::Body);
    case TrafficDelegate::DirectionRole:
        if (column == Dir)
            return frame.record.frame.error                 ? TrafficDelegate::ErrorMark
                : frame.record.direction == Direction::Sent ? TrafficDelegate::SentMark
                                                            : TrafficDelegate::ReceivedMark;
        return {};
    default: return {};
    }
}

QVariant FrameModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return static_cast<int>(Qt::AlignVCenter
            | (section == Time || section == Delta || section == Address ? Qt::AlignRight : Qt::AlignLeft));
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
