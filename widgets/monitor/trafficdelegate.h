// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QStyledItemDelegate>
#include <QVector>

#include <array>

namespace mb {

/// Paints the cells of both tables of the Bus page by hand: the style sheet costs ten times as much, and these tables change
/// twenty times a second.
class TrafficDelegate final : public QStyledItemDelegate {
    Q_OBJECT
public:
    enum Role {
        TextRoleRole = Qt::UserRole + 1, ///< int of TextRole
        DirectionRole,                   ///< int of Mark: a triangle beside the text
        BytesRole,                       ///< int: bit mask of the bytes that changed lately; the text is "00 11 …"
        SparkRole,                       ///< QVector<double>, oldest first; the cell shows a line instead of text
    };
    enum Mark { ReceivedMark, SentMark, ErrorMark };

    explicit TrafficDelegate(const ThemeSource &theme, QObject *parent = nullptr);

    void paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override;
    QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override;
    /// Room left and right of the text.
    [[nodiscard]] int padding() const { return m_theme.theme().u(8); }

private:
    void paintGround(QPainter &painter, const QStyleOptionViewItem &option, const QModelIndex &index) const;
    void paintMark(QPainter &painter, QRect &room, Mark mark) const;
    void paintBytes(QPainter &painter, const QRect &room, const QString &text, int changed) const;
    void paintSpark(QPainter &painter, const QRect &room, const QVector<double> &values) const;
    [[nodiscard]] const QFont &font(TextRole role, const QFont &body) const;

    const ThemeSource &m_theme;
    mutable QFont m_body;
    mutable std::array<QFont, 3> m_fonts; ///< body, emphasis, raw of m_body
};

} // namespace mb
