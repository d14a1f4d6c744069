// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/differencedelegate.h"

#include "widgets/common/stateglyph.h"

#include <QApplication>
#include <QMouseEvent>
#include <QPainter>

namespace mb {
namespace {

constexpr int padding = 8;     // units, as those below
constexpr int nameIndent = 36; ///< the box stands before it
constexpr int glyphSide = 12;
constexpr int tickSide = 16;

bool isGroup(const QModelIndex &index)
{
    return !index.siblingAtColumn(0).data(IndexRole).isValid();
}

bool isTicked(const QModelIndex &index)
{
    return index.siblingAtColumn(0).data(Qt::CheckStateRole).toInt() == Qt::Checked;
}

} // namespace

DifferenceDelegate::DifferenceDelegate(const ThemeSource &theme, QObject *parent)
    : QStyledItemDelegate(parent)
    , m_theme(theme)
{
}

QFont DifferenceDelegate::cellFont(const QModelIndex &index, const QFont &body) const
{
    const Theme &theme = m_theme.theme();
    switch (index.column()) {
    case Key: return theme.font(TextRole::Raw, body);
    case B:
        return theme.font(
            index.siblingAtColumn(0).data(DiffersRole).toBool() ? TextRole::Emphasis : TextRole::Body, body);
    case Unit:
    case State: return theme.font(TextRole::Caption, body);
    default: return theme.font(isGroup(index) ? TextRole::Emphasis : TextRole::Body, body);
    }
}

int DifferenceDelegate::textIndent(int column) const
{
    return m_theme.theme().u(column == Name ? nameIndent : column == State ? padding + glyphSide + 6 : padding);
}

QSize DifferenceDelegate::sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    const Theme &theme = m_theme.theme();
    const int height = theme.u(30);
    if (isGroup(index))
        return {0, height}; // it has the width of the table
    const QFontMetrics metrics(cellFont(index, option.font));
    return {
        textIndent(index.column()) + metrics.horizontalAdvance(index.data().toString()) + theme.u(padding + 1), height};
}

void DifferenceDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    const Theme &theme = m_theme.theme();
    painter->save();
    const bool ticked = isTicked(index) && !isGroup(index);
    const bool selected = option.state.testFlag(QStyle::State_Selected) && !isGroup(index);
    painter->fillRect(option.rect,
        isGroup(index) ? theme.window
            : selected ? theme.sel
            : ticked   ? theme.editedTint
                       : theme.canvas);
    painter->fillRect(option.rect.left(), option.rect.bottom(), option.rect.width(), 1, theme.grid);
    if (index.column() == Name && (ticked || selected))
        painter->fillRect(option.rect.left(), option.rect.top(), theme.u(3), option.rect.height(), theme.accent);
    if (index.column() == Name)
        paintTick(*painter, option, index);
    if (isGroup(index))
        paintGroup(*painter, option, index);
    else
        paintCell(*painter, option, index);
    painter->restore();
}

void DifferenceDelegate::paintTick(
    QPainter &painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    if (!index.flags().testFlag(Qt::ItemIsUserCheckable))
        return;
    const int side = m_theme.theme().u(tickSide);
    QStyleOptionViewItem box = option;
    box.rect = QRect(option.rect.left() + m_theme.theme().u(12), option.rect.center().y() - side / 2, side, side);
    box.features |= QStyleOptionViewItem::HasCheckIndicator;
    box.checkState = static_cast<Qt::CheckState>(index.data(Qt::CheckStateRole).toInt());
    box.state &= ~(QStyle::State_On | QStyle::State_Off | QStyle::State_NoChange | QStyle::State_MouseOver);
    box.state |= box.checkState == Qt::Checked ? QStyle::State_On
        : box.checkState == Qt::Unchecked      ? QStyle::State_Off
                                               : QStyle::State_NoChange;
    const QStyle *style = option.widget ? option.widget->style() : QApplication::style();
    style->drawPrimitive(QStyle::PE_IndicatorItemViewItemCheck, &box, &painter, option.widget);
}

void DifferenceDelegate::paintGroup(
    QPainter &painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    const Theme &theme = m_theme.theme();
    QRect room = option.rect.adjusted(textIndent(Name), 0, -theme.u(padding), 0);
    painter.setFont(cellFont(index, option.font));
    painter.setPen(theme.text);
    const QString title = painter.fontMetrics().elidedText(index.data().toString(), Qt::ElideRight, room.width());
    painter.drawText(room, Qt::AlignVCenter, title);
    room.setLeft(room.left() + painter.fontMetrics().horizontalAdvance(title) + theme.u(10));
    painter.setFont(theme.font(TextRole::Caption, option.font));
    painter.setPen(theme.dim);
    painter.drawText(room, Qt::AlignVCenter,
        painter.fontMetrics().elidedText(index.data(GroupNoteRole).toString(), Qt::ElideRight, room.width()));
}

void DifferenceDelegate::paintCell(
    QPainter &painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    const Theme &theme = m_theme.theme();
    const int column = index.column();
    const bool number = column == A || column == B;
    const QRect room = option.rect.adjusted(textIndent(column), 0, -theme.u(padding), 0);
    if (column == State && index.data(GlyphRole).isValid()) {
        const auto glyph = static_cast<GlyphState>(index.data(GlyphRole).toInt());
        const int side = theme.u(glyphSide);
        paintGlyph(painter,
            QRectF(option.rect.left() + theme.u(padding), room.center().y() - side / 2.0 + 0.5, side, side), glyph,
            glyphColor(glyph, theme));
    }
    painter.setFont(cellFont(index, option.font));
    painter.setPen(column == Name || number ? theme.text : theme.dim);
    const auto elide = column == Key || column == Name ? Qt::ElideMiddle : Qt::ElideRight;
    painter.drawText(room, number ? int(Qt::AlignVCenter | Qt::AlignRight) : int(Qt::AlignVCenter),
        painter.fontMetrics().elidedText(index.data().toString(), elide, room.width()));
}

/// A click anywhere before the name ticks: the box alone is small.
bool DifferenceDelegate::editorEvent(
    QEvent *event, QAbstractItemModel *model, const QStyleOptionViewItem &option, const QModelIndex &index)
{
    if (!index.flags().testFlag(Qt::ItemIsUserCheckable) || event->type() != QEvent::MouseButtonRelease)
        return false;
    const auto *mouse = static_cast<QMouseEvent *>(event);
    if (mouse->button() != Qt::LeftButton || mouse->pos().x() > option.rect.left() + textIndent(Name))
        return false;
    const bool on = index.data(Qt::CheckStateRole).toInt() == Qt::Checked;
    return model->setData(index, on ? Qt::Unchecked : Qt::Checked, Qt::CheckStateRole);
}

} // namespace mb
