// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/noticemodel.h"

#include "widgets/common/clocktext.h"
#include "widgets/common/devicetext.h"

#include "widgets/common/stateglyph.h"

#include <utility>

namespace mb {
NoticeModel::NoticeModel(Workbench &workbench, const ThemeSource &theme, QObject *parent)
    : QAbstractTableModel(parent)
    , m_workbench(workbench)
    , m_theme(theme)
    , m_notices(workbench.notices())
{
    connect(&workbench, &Workbench::noticed, this, [this](const Notice &notice) {
        const int row = static_cast<int>(m_notices.size());
        beginInsertRows({}, row, row);
        m_notices.push_back(notice);
        endInsertRows();
    });
}

int NoticeModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_notices.size());
}

int NoticeModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

void NoticeModel::setNamed(bool named)
{
    if (std::exchange(m_named, named) != named && rowCount() > 0)
        Q_EMIT dataChanged(index(0, Text), index(rowCount() - 1, Text));
}

QString NoticeModel::timeText(const Notice &notice) const
{
    return clockText(momentOf(m_workbench, notice.time), ClockPart::Milliseconds);
}

QVariant NoticeModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    const Notice &notice = m_notices[static_cast<std::size_t>(index.row())];
    if (role == SeverityRole)
        return static_cast<int>(notice.severity);
    if (role == Qt::DecorationRole && index.column() == Glyph)
        return glyphIcon(glyphOf(notice.severity), m_theme.theme());
    if (role == Qt::AccessibleTextRole && index.column() == Glyph)
        return glyphWord(glyphOf(notice.severity));
    if (role == Qt::ForegroundRole && index.column() == Time)
        return m_theme.theme().dim;
    if (role == Qt::FontRole && index.column() == Time)
        return m_theme.theme().font(TextRole::Raw, {});
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole)
        return {};
    switch (index.column()) {
    case Time: return timeText(notice);
    case Device: return notice.device;
    case Text: return m_named && !notice.device.isEmpty() ? tr("%1: %2").arg(notice.device, notice.text) : notice.text;
    default: return {};
    }
}

QVariant NoticeModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Time: return tr("time");
    case Device: return tr("device");
    case Text: return tr("what");
    default: return {};
    }
}

} // namespace mb
