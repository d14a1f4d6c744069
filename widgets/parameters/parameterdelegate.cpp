// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parameterdelegate.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/icons.h"
#include "widgets/common/numberformat.h"
#include "widgets/parameters/valuefield.h"

#include <QPainter>
#include <QTreeView>

#include <array>

namespace mb {

ParameterDelegate::ParameterDelegate(const ThemeSource &theme, const ParameterModel &model, QObject *parent)
    : QStyledItemDelegate(parent)
    , m_theme(theme)
    , m_model(model)
{
}

QFont ParameterDelegate::cellFont(int column, const QFont &body) const
{
    const Theme &theme = m_theme.theme();
    if (column == ParameterModel::Key || column == ParameterModel::Raw)
        return theme.font(TextRole::Raw, body);
    return theme.font(column == ParameterModel::State ? TextRole::Caption : TextRole::Body, body);
}

QSize ParameterDelegate::sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    const auto *view = qobject_cast<const QTreeView *>(option.widget);
    const QWidget *line
        = view && ParameterModel::kindOf(index) == ParameterModel::Kind::Fault ? view->indexWidget(index) : nullptr;
    const int height = line ? line->heightForWidth(view->viewport()->width()) : rowHeight();
    return {m_theme.theme().u(40), std::max(height, rowHeight())};
}

QRect ParameterDelegate::fieldRect(const QRect &cell) const
{
    const Theme &theme = m_theme.theme();
    return cell.adjusted(theme.u(2), theme.u(1), 0, -theme.u(2));
}

void ParameterDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    if (ParameterModel::kindOf(index) == ParameterModel::Kind::Fault)
        return; // its widget paints
    painter->save();
    if (ParameterModel::kindOf(index) == ParameterModel::Kind::Group)
        paintGroup(*painter, option, index);
    else if (index.column() == ParameterModel::ValueColumn)
        paintValue(*painter, option, index);
    else if (index.column() == ParameterModel::State)
        paintState(*painter, option, index);
    else
        paintText(*painter, option, index);
    painter->restore();
}

void ParameterDelegate::paintBackground(
    QPainter &painter, const QRect &row, const QModelIndex &index, bool selected, bool hovered) const
{
    const Theme &theme = m_theme.theme();
    if (ParameterModel::kindOf(index) == ParameterModel::Kind::Group) {
        painter.fillRect(row, theme.window);
        painter.fillRect(row.left(), row.bottom(), row.width(), 1, theme.line);
        return;
    }
    const ParameterStanding standing = m_model.standing(m_model.parameterAt(index));
    painter.fillRect(row,
        standing.illegal      ? theme.errorTint
            : selected        ? theme.sel
            : standing.edited ? theme.editedTint
            : hovered         ? theme.window
                              : theme.canvas);
    painter.fillRect(row.left(), row.bottom(), row.width(), 1, standing.illegal ? theme.errorTint : theme.grid);
    if (standing.illegal)
        painter.fillRect(row.left(), row.top(), theme.u(3), row.height(), theme.danger);
    else if (standing.edited || selected)
        painter.fillRect(row.left(), row.top(), theme.u(3), row.height(), theme.accent);
}

void ParameterDelegate::paintFocus(QPainter &painter, const QRect &row) const
{
    const Theme &theme = m_theme.theme();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(theme.accent, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(row).adjusted(theme.u(3) + 1.5, 0.5, -1.5, -1.5), theme.u(3), theme.u(3));
    painter.restore();
}

void ParameterDelegate::paintGroup(
    QPainter &painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    const Theme &theme = m_theme.theme();
    const bool open = (option.state & QStyle::State_Open) != 0;
    QRect row = option.rect.adjusted(labelIndent(), 0, -padding(), 0);
    const double side = theme.u(14);
    const QRectF box(theme.u(12), option.rect.center().y() - side / 2.0 + 0.5, side, side);
    paintSymbol(painter, box, open ? Symbol::ChevronDown : Symbol::ChevronRight, theme.dim);
    painter.setFont(theme.font(TextRole::Emphasis, option.font));
    painter.setPen(theme.text);
    const QString title
        = painter.fontMetrics().elidedText(m_model.groups().title(index.row()), Qt::ElideRight, row.width());
    painter.drawText(row, Qt::AlignVCenter, title);
    row.setLeft(row.left() + painter.fontMetrics().horizontalAdvance(title) + theme.u(10));
    painter.setFont(theme.font(TextRole::Caption, option.font));
    painter.setPen(theme.dim);
    painter.drawText(row, Qt::AlignVCenter,
        painter.fontMetrics().elidedText(m_model.groups().note(index.row()), Qt::ElideRight, row.width()));
}

void ParameterDelegate::paintText(QPainter &painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    const Theme &theme = m_theme.theme();
    const int column = index.column();
    const bool first = column == ParameterModel::Label;
    const bool changed = column == ParameterModel::Reference && m_model.standing(m_model.parameterAt(index)).changed;
    const QRect cell = option.rect.adjusted(first ? labelIndent() : padding(), 0, -padding(), 0);
    painter.setFont(cellFont(column, option.font));
    painter.setPen(first || changed ? theme.text : theme.dim);
    const bool named = first || column == ParameterModel::Key; // many begin alike: both ends say something
    const auto elide = named ? Qt::ElideMiddle : Qt::ElideRight;
    const QString text = painter.fontMetrics().elidedText(index.data().toString(), elide, cell.width());
    painter.drawText(cell, index.data(Qt::TextAlignmentRole).toInt(), text);
}

void ParameterDelegate::paintState(
    QPainter &painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    const Theme &theme = m_theme.theme();
    const ParameterStanding standing = m_model.standing(m_model.parameterAt(index));
    const int side = theme.u(12);
    QRect cell = option.rect.adjusted(padding(), 0, -theme.u(2), 0);
    const bool isUnknown = standing.glyph == GlyphState::Gone;
    paintGlyph(painter, QRectF(cell.left(), cell.center().y() - side / 2.0 + 0.5, side, side), standing.glyph,
        glyphColor(standing.glyph, theme));
    cell.setLeft(cell.left() + side + theme.u(6));
    painter.setFont(cellFont(ParameterModel::State, option.font));
    painter.setPen(standing.unread && !standing.edited ? theme.danger : isUnknown ? theme.faint : theme.text);
    painter.drawText(
        cell, Qt::AlignVCenter, painter.fontMetrics().elidedText(standing.text, Qt::ElideRight, cell.width()));
}

void ParameterDelegate::paintValue(
    QPainter &painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    const Theme &theme = m_theme.theme();
    const ParameterIndex which = m_model.parameterAt(index);
    const Parameter &row = m_model.parameter(which);
    const ParameterStanding standing = m_model.standing(which);
    const QRect field = fieldRect(option.rect);
    if (row.type == WireType::Boolean) {
        paintSwitch(painter, field, option, which);
        return;
    }
    const bool focused = (option.state & QStyle::State_HasFocus) != 0 && (index.flags() & Qt::ItemIsEditable) != 0;
    painter.setRenderHint(QPainter::Antialiasing);
    if (standing.edited || focused) {
        painter.setPen(QPen(standing.illegal ? theme.danger : theme.outline, standing.illegal ? 2 : 1));
        painter.setBrush(theme.canvas);
        painter.drawRoundedRect(QRectF(field).adjusted(0.5, 0.5, -0.5, -0.5), theme.u(4), theme.u(4));
    }
    painter.setFont(cellFont(ParameterModel::ValueColumn, option.font));
    painter.setPen(standing.illegal ? theme.danger : standing.raw ? theme.text : theme.faint);
    const QRect text(
        field.left() + theme.u(2), option.rect.top(), field.width() - theme.u(2) - padding(), option.rect.height());
    painter.drawText(text, Qt::AlignVCenter | Qt::AlignRight,
        painter.fontMetrics().elidedText(index.data().toString(), Qt::ElideRight, text.width()));
}

void ParameterDelegate::paintSwitch(
    QPainter &painter, const QRect &field, const QStyleOptionViewItem &option, ParameterIndex index) const
{
    const Theme &theme = m_theme.theme();
    const ParameterStanding standing = m_model.standing(index);
    const bool editable = m_model.isWritable() && isEditable(m_model.parameter(index));
    const bool on = standing.raw.value_or(0) != 0;
    painter.setFont(cellFont(ParameterModel::ValueColumn, option.font));
    const QFontMetrics metrics = painter.fontMetrics();
    const QRect text(field.left(), option.rect.top(), field.width() - padding(), option.rect.height());
    painter.setPen(standing.raw ? theme.text : theme.faint);
    painter.drawText(text, Qt::AlignVCenter | Qt::AlignRight,
        standing.raw ? valueText(m_model.parameter(index), *standing.raw) : QString(UnknownMark));
    const int widest = std::max(metrics.horizontalAdvance(valueText(m_model.parameter(index), 0)),
        metrics.horizontalAdvance(valueText(m_model.parameter(index), 1)));
    const double side = theme.u(16);
    const QRectF box(
        text.right() - widest - theme.u(8) - side + 0.5, field.center().y() - side / 2.0 + 0.5, side, side);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(on ? (editable ? theme.fill : theme.faint) : theme.outline, 1));
    painter.setBrush(on ? (editable ? theme.fill : theme.faint) : theme.canvas);
    painter.drawRoundedRect(box, theme.u(3), theme.u(3));
    if (!on)
        return;
    painter.setPen(QPen(theme.onFill, theme.u(2), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    const std::array<QPointF, 3> tick{QPointF(box.left() + side * 0.24, box.center().y()),
        QPointF(box.left() + side * 0.43, box.bottom() - side * 0.28),
        QPointF(box.right() - side * 0.22, box.top() + side * 0.28)};
    painter.drawPolyline(tick.data(), static_cast<int>(tick.size()));
}

QWidget *ParameterDelegate::createEditor(QWidget *parent, const QStyleOptionViewItem &, const QModelIndex &index) const
{
    const ParameterIndex which = m_model.parameterAt(index);
    const Parameter &row = m_model.parameter(which);
    auto *self = const_cast<ParameterDelegate *>(this); // the signals of a delegate are not const
    const QString name = tr("%1, %2").arg(tableText(row.label), rangeText(row));
    if (!row.choices.empty()) {
        auto *list = new ChoiceField(row, parent);
        list->setAccessibleName(name);
        connect(list, qOverload<int>(&QComboBox::activated), self, [self, list] {
            Q_EMIT self->commitData(list);
            Q_EMIT self->closeEditor(list);
        });
        return list;
    }
    auto *field = new ValueField(row, parent);
    field->setAccessibleName(name);
    field->setFont(cellFont(ParameterModel::ValueColumn, parent->font()));
    connect(field, &QLineEdit::textEdited, m_model.edits(),
        [edits = m_model.edits(), which](const QString &text) { edits->type(which, text); });
    return field;
}

void ParameterDelegate::setEditorData(QWidget *editor, const QModelIndex &index) const
{
    if (auto *field = qobject_cast<ValueField *>(editor))
        field->fillOnce(index.data(Qt::EditRole).toString());
    else if (auto *list = qobject_cast<ChoiceField *>(editor))
        list->fillOnce(index.data(Qt::EditRole).toString());
}

void ParameterDelegate::setModelData(QWidget *editor, QAbstractItemModel *model, const QModelIndex &index) const
{
    if (const auto *field = qobject_cast<ValueField *>(editor)) {
        if (field->isModified()) // looking at a value is not editing it
            m_model.edits()->endTyping(true);
    } else if (const auto *list = qobject_cast<ChoiceField *>(editor)) {
        model->setData(index, list->currentData());
    }
}

void ParameterDelegate::updateEditorGeometry(
    QWidget *editor, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    const bool line = ParameterModel::kindOf(index) == ParameterModel::Kind::Fault;
    editor->setGeometry(line ? option.rect : fieldRect(option.rect));
}

} // namespace mb
