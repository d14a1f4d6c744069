// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/report/entrydelegate.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QPainter>

namespace mb {

EntryDelegate::EntryDelegate(const ThemeSource &theme, QObject *parent)
    : QStyledItemDelegate(parent)
    , m_theme(theme)
{
}

int EntryDelegate::layOut(const QStyleOptionViewItem &option, const QModelIndex &index, QPainter *painter) const
{
    const Theme &theme = m_theme.theme();
    const QString text = index.data().toString();
    const bool marked = !index.data(Qt::DecorationRole).isNull();
    const int left = theme.u(12) + (marked ? option.decorationSize.width() + theme.u(8) : 0);
    QRect room = option.rect.adjusted(left, theme.u(6), -theme.u(12), 0);
    room.setHeight(QWIDGETSIZE_MAX);
    const auto put = [&](const QString &part, TextRole role, const QColor &color) {
        const QFont font = theme.font(role, option.font);
        const QRect needed = QFontMetrics(font).boundingRect(room, Qt::TextWordWrap, part);
        if (painter) {
            painter->setFont(font);
            painter->setPen(color);
            painter->drawText(room, Qt::TextWordWrap, part);
        }
        room.setTop(room.top() + needed.height());
    };
    put(text.section(QLatin1Char('\n'), 0, 0), TextRole::Body, theme.text);
    put(text.section(QLatin1Char('\n'), 1), TextRole::Caption, theme.dim);
    return room.top() + theme.u(6) - option.rect.top();
}

QSize EntryDelegate::sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    QStyleOptionViewItem line(option);
    initStyleOption(&line, index);
    if (const auto *view = qobject_cast<const QAbstractItemView *>(option.widget))
        line.rect.setWidth(view->viewport()->width());
    return {0, layOut(line, index, nullptr)};
}

void EntryDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    QStyleOptionViewItem ground(option);
    initStyleOption(&ground, index);
    const QStyleOptionViewItem line(ground);
    ground.text.clear();
    painter->save();
    QApplication::style()->drawControl(QStyle::CE_ItemViewItem, &ground, painter, option.widget);
    (void)layOut(line, index, painter);
    painter->restore();
}

} // namespace mb
