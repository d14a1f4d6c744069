// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/parameters/parametermodel.h"

#include <QStyledItemDelegate>

namespace mb {

/// Paints the cells of a parameter and makes its field. What is typed goes into StagedEdits at once, so that range and
/// faults follow every key; a value that arrives meanwhile never touches the field.
class ParameterDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    ParameterDelegate(const ThemeSource &theme, const ParameterModel &model, QObject *parent);

    /// Of an editable row.
    [[nodiscard]] int rowHeight() const { return m_theme.theme().u(30); }
    [[nodiscard]] QFont cellFont(int column, const QFont &body) const;
    /// Room left and right of the text of a cell.
    [[nodiscard]] int padding() const { return m_theme.theme().u(8); }
    [[nodiscard]] int labelIndent() const { return m_theme.theme().u(34); }

    /// Behind the cells of a row, and around the one that has the cursor.
    void paintBackground(
        QPainter &painter, const QRect &row, const QModelIndex &index, bool selected, bool hovered) const;
    void paintFocus(QPainter &painter, const QRect &row) const;
    void paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override;
    QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override;
    QWidget *createEditor(QWidget *parent, const QStyleOptionViewItem &option, const QModelIndex &index) const override;
    void setEditorData(QWidget *editor, const QModelIndex &index) const override;
    void setModelData(QWidget *editor, QAbstractItemModel *model, const QModelIndex &index) const override;
    void updateEditorGeometry(
        QWidget *editor, const QStyleOptionViewItem &option, const QModelIndex &index) const override;

private:
    void paintGroup(QPainter &painter, const QStyleOptionViewItem &option, const QModelIndex &index) const;
    void paintValue(QPainter &painter, const QStyleOptionViewItem &option, const QModelIndex &index) const;
    void paintSwitch(
        QPainter &painter, const QRect &field, const QStyleOptionViewItem &option, ParameterIndex index) const;
    void paintState(QPainter &painter, const QStyleOptionViewItem &option, const QModelIndex &index) const;
    void paintText(QPainter &painter, const QStyleOptionViewItem &option, const QModelIndex &index) const;
    [[nodiscard]] QRect fieldRect(const QRect &cell) const;

    const ThemeSource &m_theme;
    const ParameterModel &m_model;
};

} // namespace mb
