// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QStyledItemDelegate>

namespace mb {

/// Rows of the device tree: a link is one line with its load, a device two lines with glyph and badge, an axis or a
/// channel one line with its value. What is selected is the view's to draw, under the branches too.
class DeviceDelegate final : public QStyledItemDelegate {
    Q_OBJECT
public:
    explicit DeviceDelegate(const ThemeSource &theme, QObject *parent = nullptr);

    void paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override;
    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override;

private:
    void paintLink(QPainter &painter, const QStyleOptionViewItem &option, const QModelIndex &index) const;
    void paintDevice(QPainter &painter, const QStyleOptionViewItem &option, const QModelIndex &index) const;
    void paintPart(QPainter &painter, const QStyleOptionViewItem &option, const QModelIndex &index) const;
    /// Yields the width of the glyph.
    int paintState(QPainter &painter, const QRect &row, const QModelIndex &index) const;
    [[nodiscard]] QString badgeFor(const QStyleOptionViewItem &option, const QModelIndex &index, int room) const;
    /// Yields the width it took at the right edge.
    int paintBadge(QPainter &painter, const QRect &row, const QString &text, const QFont &font) const;

    const ThemeSource &m_theme;
};

} // namespace mb
