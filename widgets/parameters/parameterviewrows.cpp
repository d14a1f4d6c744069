// SPDX-License-Identifier: GPL-3.0-or-later
// Painting of rows, and what keys and the mouse do to them.
#include "widgets/parameters/parameterdelegate.h"
#include "widgets/parameters/parameterview.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QPainter>

namespace mb {

void ParameterView::paintBackground(QPainter &painter, const QRect &row, const QModelIndex &index, bool selected) const
{
    const Theme &theme = m_theme.theme();
    const auto kind = ParameterModel::kindOf(index);
    if (kind == ParameterModel::Kind::Group) {
        painter.fillRect(row, theme.window);
        painter.fillRect(row.left(), row.bottom(), row.width(), 1, theme.line);
        return;
    }
    const ParameterStanding standing = m_model.standing(m_model.parameterAt(index));
    const bool hovered = row.contains(viewport()->mapFromGlobal(QCursor::pos())) && viewport()->underMouse();
    const QColor plain = hovered ? theme.window : theme.canvas;
    painter.fillRect(row,
        standing.illegal      ? theme.errorTint
            : selected        ? theme.sel
            : standing.edited ? theme.editedTint
                              : plain);
    painter.fillRect(row.left(), row.bottom(), row.width(), 1, standing.illegal ? theme.errorTint : theme.grid);
    if (standing.illegal)
        painter.fillRect(row.left(), row.top(), theme.u(3), row.height(), theme.danger);
    else if (standing.edited || selected)
        painter.fillRect(row.left(), row.top(), theme.u(3), row.height(), theme.accent);
}

void ParameterView::drawRow(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    const Theme &theme = m_theme.theme();
    const QRect row(0, option.rect.top(), viewport()->width(), option.rect.height());
    const QModelIndex first = index.siblingAtColumn(0);
    paintBackground(*painter, row, first, selectionModel()->isSelected(first));
    const bool focused = hasFocus() && currentIndex().isValid() && currentIndex().siblingAtColumn(0) == first;
    QStyleOptionViewItem cell = option;
    cell.font = font();
    cell.widget = this;
    cell.state.setFlag(QStyle::State_HasFocus, focused);
    cell.state.setFlag(QStyle::State_Open, isExpanded(first));
    const bool spanned = ParameterModel::kindOf(first) != ParameterModel::Kind::Parameter;
    for (int column = 0; column < ParameterModel::ColumnCount; ++column) {
        if (isColumnHidden(column))
            continue;
        cell.rect = spanned ? row : QRect(columnViewportPosition(column), row.top(), columnWidth(column), row.height());
        m_delegate->paint(painter, cell, index.siblingAtColumn(column));
        if (spanned)
            break;
    }
    if (!focused)
        return;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(QPen(theme.accent, 1));
    painter->setBrush(Qt::NoBrush);
    painter->drawRoundedRect(QRectF(row).adjusted(theme.u(3) + 1.5, 0.5, -1.5, -1.5), theme.u(3), theme.u(3));
    painter->restore();
}

void ParameterView::activateRow(const QModelIndex &index)
{
    if (!index.isValid())
        return;
    if (ParameterModel::kindOf(index) == ParameterModel::Kind::Group) {
        setExpanded(index.siblingAtColumn(0), !isExpanded(index.siblingAtColumn(0)));
        return;
    }
    const ParameterIndex which = m_model.parameterAt(index);
    if (m_model.parameter(which).type == WireType::Boolean)
        m_model.toggle(which);
    else
        edit(m_model.indexOf(which), AllEditTriggers, nullptr);
}

void ParameterView::keyPressEvent(QKeyEvent *event)
{
    const auto which = currentParameter();
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter || event->key() == Qt::Key_F2) {
        activateRow(currentIndex());
        return;
    }
    if (event->matches(QKeySequence::Copy)) {
        copySelection();
        return;
    }
    const QString text = event->text();
    const bool number = !text.isEmpty() && (text[0].isDigit() || QStringLiteral("+-.,").contains(text[0]));
    if (number && which && m_model.parameter(*which).type != WireType::Boolean
        && m_model.parameter(*which).choices.empty()) {
        setEditTriggers(AnyKeyPressed); // only this trigger hands the key on to the field
        edit(m_model.indexOf(*which), AnyKeyPressed, event);
        setEditTriggers(NoEditTriggers);
        return;
    }
    if (event->key() == Qt::Key_Delete && which && m_model.edits() && m_model.isWritable()) {
        m_model.edits()->revert(*which);
        return;
    }
    QTreeView::keyPressEvent(event);
}

void ParameterView::mouseReleaseEvent(QMouseEvent *event)
{
    QTreeView::mouseReleaseEvent(event);
    const QModelIndex index = indexAt(event->pos());
    if (event->button() != Qt::LeftButton || event->modifiers() != Qt::NoModifier || !index.isValid())
        return;
    if (ParameterModel::kindOf(index) == ParameterModel::Kind::Group || index.column() == ParameterModel::ValueColumn)
        activateRow(index);
    else if (index.column() == ParameterModel::State && m_model.standing(m_model.parameterAt(index)).unread)
        Q_EMIT retryRequested();
}

} // namespace mb
