// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/firmware/queuemodel.h"

#include <QApplication>
#include <QPainter>

namespace mb {
namespace {

constexpr double barHeight = 8;
constexpr double percentWidth = 48;

} // namespace

QueueModel::QueueModel(const ThemeSource &theme, QObject *parent)
    : QAbstractTableModel(parent)
    , m_theme(theme)
{
    connect(&theme, &ThemeSource::changed, this, [this] {
        if (!m_lines.empty())
            Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, Columns - 1));
    });
}

/// The same units in the same order keep the place of the view.
void QueueModel::setLines(std::vector<QueueLine> lines)
{
    const bool same = std::ranges::equal(
        lines, m_lines, [](const QueueLine &a, const QueueLine &b) { return a.row == b.row && a.device == b.device; });
    if (!same) {
        beginResetModel();
        m_lines = std::move(lines);
        endResetModel();
        Q_EMIT tickedChanged();
        return;
    }
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (m_lines[i] == lines[i])
            continue;
        m_lines[i] = std::move(lines[i]);
        Q_EMIT dataChanged(index(static_cast<int>(i), 0), index(static_cast<int>(i), Columns - 1));
    }
}

void QueueModel::setChoosing(bool on)
{
    if (std::exchange(m_choosing, on) != on && !m_lines.empty())
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, 0));
}

void QueueModel::tick(DeviceId device, bool on)
{
    const bool changed = on ? m_ticked.insert(device).second : m_ticked.erase(device) > 0;
    if (!changed)
        return;
    Q_EMIT dataChanged(index(0, 0), index(std::max(0, rowCount() - 1), 0), {Qt::CheckStateRole});
    Q_EMIT tickedChanged();
}

void QueueModel::tickAll(bool on)
{
    for (const QueueLine &line : m_lines) {
        if (line.device != DeviceId{})
            tick(line.device, on);
    }
}

std::vector<DeviceId> QueueModel::ticked() const
{
    std::vector<DeviceId> ticked;
    for (const QueueLine &line : m_lines) {
        if (line.device != DeviceId{} && m_ticked.count(line.device) > 0)
            ticked.push_back(line.device);
    }
    return ticked;
}

int QueueModel::rowOf(std::uint32_t queueRow) const
{
    const auto found = std::ranges::find(m_lines, queueRow, &QueueLine::row);
    return found == m_lines.end() ? -1 : static_cast<int>(found - m_lines.begin());
}

int QueueModel::placeOf(const QueueLine &line) const
{
    const auto found = std::ranges::find_if(m_lines, [&line](const QueueLine &one) {
        const bool untold = one.row == 0 || line.row == 0;
        const bool gone = one.device == DeviceId{} || line.device == DeviceId{};
        return (one.row == line.row || untold) && (one.device == line.device || gone) && !(untold && gone);
    });
    return found == m_lines.end() ? -1 : static_cast<int>(found - m_lines.begin());
}

int QueueModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_lines.size());
}

int QueueModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(Columns);
}

QString QueueModel::text(const QueueLine &line, int column) const
{
    switch (column) {
    case Serial: return line.serial.isEmpty() ? line.link : line.serial;
    case Unit: return line.name;
    case Versions: return line.firmware;
    case StepNow: return line.step;
    case Time: return line.time;
    case Outcome: return line.result;
    default: return line.done ? tr("%1 %").arg(*line.done) : QString();
    }
}

QVariant QueueModel::look(const QueueLine &line, int column, int role) const
{
    const Theme &theme = m_theme.theme();
    if (role == Qt::DecorationRole && column == Serial)
        return glyphIcon(line.glyph, theme);
    if (role == Qt::ForegroundRole && column == Outcome)
        return theme.tone(line.tone);
    if (role == Qt::FontRole && column == Serial)
        return theme.font(TextRole::Raw, QApplication::font());
    if (role == Qt::TextAlignmentRole && column == Time)
        return static_cast<int>(Qt::AlignRight | Qt::AlignVCenter);
    return {};
}

QVariant QueueModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const QueueLine &line = m_lines[static_cast<std::size_t>(index.row())];
    switch (role) {
    case Qt::DisplayRole:
    case Qt::ToolTipRole: return text(line, index.column());
    case Qt::AccessibleTextRole: // the shape has a word
        return index.column() == Serial ? glyphWord(line.glyph) + QStringLiteral(", ") + text(line, Serial)
                                        : text(line, index.column());
    case Qt::CheckStateRole:
        if (index.column() == Serial && line.device != DeviceId{})
            return m_ticked.count(line.device) > 0 ? Qt::Checked : Qt::Unchecked;
        return {};
    case ShareRole: return line.done ? QVariant(*line.done) : QVariant();
    default: return look(line, index.column(), role);
    }
}

bool QueueModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (role != Qt::CheckStateRole || index.column() != Serial || !m_choosing)
        return false;
    const DeviceId device = m_lines[static_cast<std::size_t>(index.row())].device;
    if (device == DeviceId{})
        return false;
    tick(device, value.toInt() == Qt::Checked);
    return true;
}

QVariant QueueModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Serial: return tr("serial number");
    case Unit: return tr("unit");
    case Versions: return tr("firmware");
    case StepNow: return tr("step");
    case Share: return tr("progress");
    case Time: return tr("time");
    case Outcome: return tr("result");
    default: return {};
    }
}

Qt::ItemFlags QueueModel::flags(const QModelIndex &index) const
{
    if (!index.isValid())
        return Qt::NoItemFlags;
    Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    if (index.column() == Serial && m_choosing)
        flags |= Qt::ItemIsUserCheckable;
    return flags;
}

ShareDelegate::ShareDelegate(const ThemeSource &theme, QObject *parent)
    : QStyledItemDelegate(parent)
    , m_theme(theme)
{
}

void ShareDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    QStyleOptionViewItem ground(option);
    initStyleOption(&ground, index);
    const QString percent = ground.text;
    ground.text.clear();
    QApplication::style()->drawControl(QStyle::CE_ItemViewItem, &ground, painter, option.widget);
    const QVariant share = index.data(QueueModel::ShareRole);
    if (!share.isValid())
        return;
    const Theme &theme = m_theme.theme();
    const int edge = theme.u(6);
    const QRect room = option.rect.adjusted(edge, 0, -edge, 0);
    QRect bar(room.left(), room.center().y() - theme.u(barHeight) / 2, room.width() - theme.u(percentWidth),
        theme.u(barHeight));
    painter->fillRect(bar, theme.line);
    const bool whole = share.toInt() >= 100;
    bar.setWidth(bar.width() * std::clamp(share.toInt(), 0, 100) / 100);
    painter->fillRect(bar, whole ? theme.ok : theme.accent);
    painter->setPen(theme.dim);
    painter->setFont(option.font);
    painter->drawText(room, Qt::AlignRight | Qt::AlignVCenter, percent);
}

} // namespace mb
