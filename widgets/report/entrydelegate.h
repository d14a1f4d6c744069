// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QStyledItemDelegate>

namespace mb {

/// An entry of a list in two parts: what it is, as long as it takes, and in a line of its own below it, dim, what else is known. Both are
/// in its text, parted by the end of the first line.
class EntryDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    EntryDelegate(const ThemeSource &theme, QObject *parent);

    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override;
    void paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override;

private:
    /// Of both parts in this width; `painter`: nullptr to measure only.
    int layOut(const QStyleOptionViewItem &option, const QModelIndex &index, QPainter *painter) const;

    const ThemeSource &m_theme;
};

} // namespace mb
