// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/timelinedelegate.h"

#include <QPainter>

namespace mb {
namespace {

constexpr int padding = 8; // units, as those below
constexpr int symbolSide = 16;
constexpr int textIndent = 36;
constexpr int badgeSide = 18;

bool isHead(const QModelIndex &index)
{
    return index.data(HeadRole).toBool();
}

bool isState(const QModelIndex &index)
{
    return index.data(PlaceRole).isValid();
}

/// The line goes on to this neighbour.
bool isOnLine(const QModelIndex &index)
{
    return index.isValid() && !isHead(index);
}

void drawElided(QPainter &painter, const QRect &room, const QString &text)
{
    painter.drawText(room, Qt::AlignVCenter, painter.fontMetrics().elidedText(text, Qt::ElideRight, room.width()));
}

} // namespace

void paintStateBadge(QPainter &painter, const QRect &box, QChar letter, const Theme &theme, const QFont &body)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.fill);
    painter.drawRoundedRect(box, theme.u(3), theme.u(3));
    QFont font = theme.font(TextRole::Caption, body);
    font.setBold(true);
    painter.setFont(font);
    painter.setPen(theme.onFill);
    painter.drawText(box, Qt::AlignCenter, letter);
    painter.restore();
}

TimelineDelegate::TimelineDelegate(const ThemeSource &theme, QObject *parent)
    : QStyledItemDelegate(parent)
    , m_theme(theme)
{
}

QSize TimelineDelegate::sizeHint(const QStyleOptionViewItem &, const QModelIndex &index) const
{
    const Theme &theme = m_theme.theme();
    return {theme.u(40), theme.u(isHead(index) ? 26 : isState(index) ? 48 : 40)};
}

void TimelineDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    painter->save();
    if (isHead(index))
        paintHead(*painter, option, index);
    else
        paintLine(*painter, option, index);
    painter->restore();
}

void TimelineDelegate::paintHead(QPainter &painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    const Theme &theme = m_theme.theme();
    painter.fillRect(option.rect, theme.window);
    painter.fillRect(option.rect.left(), option.rect.bottom(), option.rect.width(), 1, theme.line);
    QFont font = theme.font(TextRole::Caption, option.font);
    font.setBold(true);
    painter.setFont(font);
    painter.setPen(theme.dim);
    drawElided(painter, option.rect.adjusted(theme.u(padding), 0, -theme.u(padding), 0), index.data().toString());
}

/// Badges and the time at the right of the first line; where they begin.
int TimelineDelegate::paintRight(
    QPainter &painter, const QRect &row, const QString &badges, const QString &clock, const QFont &body) const
{
    const Theme &theme = m_theme.theme();
    painter.setFont(theme.font(TextRole::Caption, body));
    painter.setPen(theme.dim);
    painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter, clock);
    const int side = theme.u(badgeSide);
    int left = row.right() + 1 - painter.fontMetrics().horizontalAdvance(clock) - (clock.isEmpty() ? 0 : theme.u(6));
    for (auto letter = badges.rbegin(); letter != badges.rend(); ++letter) {
        left -= side;
        paintStateBadge(painter, {left, row.center().y() - side / 2, side, side}, *letter, theme, body);
        left -= theme.u(4);
    }
    return left;
}

void TimelineDelegate::paintLine(QPainter &painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    const Theme &theme = m_theme.theme();
    const QRect &all = option.rect;
    const QString badges = index.data(BadgesRole).toString();
    const bool hovered = option.state.testFlag(QStyle::State_MouseOver) && isState(index);
    painter.fillRect(all, !badges.isEmpty() ? theme.sel : hovered ? theme.grid : theme.canvas);
    if (!badges.isEmpty())
        painter.fillRect(all.left(), all.top(), theme.u(3), all.height(), theme.accent);

    QRect first = all.adjusted(theme.u(textIndent), theme.u(5), -theme.u(padding), 0);
    first.setHeight((all.height() - theme.u(10)) / 2);
    QRect second = first.translated(0, first.height());

    const int side = theme.u(symbolSide);
    const QRect symbol(all.left() + theme.u(11), first.center().y() - side / 2, side, side);
    const int middle = symbol.center().x();
    if (isOnLine(index.siblingAtRow(index.row() - 1)))
        painter.fillRect(middle, all.top(), 1, symbol.top() - theme.u(3) - all.top(), theme.outline);
    if (isOnLine(index.siblingAtRow(index.row() + 1)))
        painter.fillRect(middle, symbol.bottom() + theme.u(3), 1, all.bottom() - symbol.bottom(), theme.outline);
    if (isState(index)) {
        paintSymbol(painter, symbol, static_cast<Symbol>(index.data(SymbolRole).toInt()),
            badges.isEmpty() ? theme.dim : theme.accent);
    } else {
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(Qt::NoPen);
        painter.setBrush(theme.outline);
        painter.drawEllipse(QRectF(symbol).center(), theme.u(3), theme.u(3));
    }

    const int until = paintRight(painter, first, badges, index.data(ClockRole).toString(), option.font);
    first.setRight(until - theme.u(4));
    painter.setFont(theme.font(isState(index) ? TextRole::Emphasis : TextRole::Caption, option.font));
    painter.setPen(isState(index) ? theme.text : theme.dim);
    drawElided(painter, first, index.data(TitleRole).toString());
    painter.setFont(theme.font(TextRole::Caption, option.font));
    painter.setPen(theme.text);
    const QString count = index.data(CountRole).toString();
    painter.drawText(second, Qt::AlignRight | Qt::AlignVCenter, count);
    if (!count.isEmpty())
        second.setRight(second.right() - painter.fontMetrics().horizontalAdvance(count) - theme.u(8));
    painter.setPen(theme.dim);
    drawElided(painter, second, index.data(DetailRole).toString());
}

} // namespace mb
