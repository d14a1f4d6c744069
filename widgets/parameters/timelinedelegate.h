// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/icons.h"

#include <QStyledItemDelegate>

namespace mb {

/// What the delegate asks of an item of the time line, beside its text.
enum TimelineRole {
    PlaceRole = Qt::UserRole, ///< of a state; of nothing else
    HeadRole,                 ///< of a day
    TitleRole,
    DetailRole, ///< second line, at the left
    ClockRole,  ///< at the right
    CountRole,  ///< second line, at the right
    SymbolRole,
    BadgesRole, ///< "A", "B" or both
};

/// The letter of a state that is compared.
void paintStateBadge(QPainter &painter, const QRect &box, QChar letter, const Theme &theme, const QFont &body);

/// Paints days, states and writes on one line that runs from the newest to the oldest.
class TimelineDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    TimelineDelegate(const ThemeSource &theme, QObject *parent);
    void paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override;
    QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override;

private:
    void paintHead(QPainter &painter, const QStyleOptionViewItem &option, const QModelIndex &index) const;
    void paintLine(QPainter &painter, const QStyleOptionViewItem &option, const QModelIndex &index) const;
    int paintRight(
        QPainter &painter, const QRect &row, const QString &badges, const QString &clock, const QFont &body) const;

    const ThemeSource &m_theme;
};

} // namespace mb
