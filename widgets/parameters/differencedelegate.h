// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QStyledItemDelegate>

namespace mb {

/// What the delegate asks of a row of the table of differences, in its first cell.
enum DifferenceRole {
    IndexRole = Qt::UserRole, ///< of the parameter; a group has none
    RawRole,                  ///< of B
    GroupNoteRole,            ///< behind the name of a group
    GroupTicksRole,           ///< it ticks its rows
    DiffersRole,
    GlyphRole, ///< GlyphState, of the cell of the state
};

/// Paints groups and rows: what is ticked is tinted, keys are in the font of keys, and boxes are drawn as everywhere.
class DifferenceDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    enum Column { Name, Key, A, B, Unit, State, Columns };
    DifferenceDelegate(const ThemeSource &theme, QObject *parent);

    void paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override;
    QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override;

protected:
    bool editorEvent(QEvent *event, QAbstractItemModel *model, const QStyleOptionViewItem &option,
        const QModelIndex &index) override;

private:
    [[nodiscard]] QFont cellFont(const QModelIndex &index, const QFont &body) const;
    [[nodiscard]] int textIndent(int column) const;
    void paintTick(QPainter &painter, const QStyleOptionViewItem &option, const QModelIndex &index) const;
    void paintGroup(QPainter &painter, const QStyleOptionViewItem &option, const QModelIndex &index) const;
    void paintCell(QPainter &painter, const QStyleOptionViewItem &option, const QModelIndex &index) const;

    const ThemeSource &m_theme;
};

} // namespace mb
