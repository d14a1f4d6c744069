// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/connection/devicedelegate.h"

#include "widgets/common/stateglyph.h"
#include "widgets/connection/devicemodel.h"

#include <QPainter>

namespace mb {

DeviceDelegate::DeviceDelegate(const ThemeSource &theme, QObject *parent)
    : QStyledItemDelegate(parent)
    , m_theme(theme)
{
}

QSize DeviceDelegate::sizeHint(const QStyleOptionViewItem &, const QModelIndex &index) const
{
    const Theme &theme = m_theme.theme();
    switch (DeviceModel::kindOf(index)) {
    case DeviceModel::Kind::Link: return {theme.u(160), theme.u(28)};
    case DeviceModel::Kind::Device: return {theme.u(160), theme.u(42)};
    case DeviceModel::Kind::Axis: return {theme.u(120), theme.u(26)};
    case DeviceModel::Kind::Channel: break;
    }
    return {theme.u(120), theme.u(24)};
}

void DeviceDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    painter->save();
    switch (DeviceModel::kindOf(index)) {
    case DeviceModel::Kind::Link: paintLink(*painter, option, index); break;
    case DeviceModel::Kind::Device: paintDevice(*painter, option, index); break;
    case DeviceModel::Kind::Axis:
    case DeviceModel::Kind::Channel: paintPart(*painter, option, index); break;
    }
    painter->restore();
}

int DeviceDelegate::paintState(QPainter &painter, const QRect &row, const QModelIndex &index) const
{
    const Theme &theme = m_theme.theme();
    const auto state = static_cast<GlyphState>(index.data(DeviceModel::GlyphRole).toInt());
    const int glyph = theme.u(12);
    paintGlyph(
        painter, QRectF(row.left(), row.center().y() - glyph / 2.0, glyph, glyph), state, glyphColor(state, theme));
    return glyph;
}

/// One line: an axis with its state, what it is told and its value; or a channel with its value.
void DeviceDelegate::paintPart(QPainter &painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    const Theme &theme = m_theme.theme();
    QRect row = option.rect.adjusted(theme.u(4), 0, -theme.u(10), 0);
    const bool axis = DeviceModel::kindOf(index) == DeviceModel::Kind::Axis;
    if (axis)
        row.setLeft(row.left() + paintState(painter, row, index) + theme.u(8));
    const QFont caption = theme.font(TextRole::Caption, option.font);
    painter.setFont(axis ? theme.font(TextRole::Body, option.font) : caption);
    painter.setPen(axis ? theme.text : theme.dim);
    const QString name = painter.fontMetrics().elidedText(index.data().toString(), Qt::ElideRight, row.width());
    painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter, name);
    row.setLeft(row.left() + painter.fontMetrics().horizontalAdvance(name) + theme.u(8));
    painter.setFont(caption);
    painter.setPen(theme.text);
    const QFontMetrics metrics = painter.fontMetrics();
    const QString value
        = metrics.elidedText(index.data(DeviceModel::DetailRole).toString(), Qt::ElideRight, row.width());
    painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter, value);
    row.setRight(row.right() - metrics.horizontalAdvance(value) - theme.u(8));
    if (!axis || row.width() < metrics.averageCharWidth() * 3)
        return;
    painter.setPen(theme.dim);
    painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter,
        metrics.elidedText(index.data(DeviceModel::LineRole).toString(), Qt::ElideRight, row.width()));
}

void DeviceDelegate::paintLink(QPainter &painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    const Theme &theme = m_theme.theme();
    QRect row = option.rect.adjusted(theme.u(4), 0, -theme.u(10), 0);
    painter.setFont(theme.font(TextRole::Emphasis, option.font));
    painter.setPen(theme.text);
    const QString name = index.data().toString();
    painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter, name);
    row.setLeft(row.left() + painter.fontMetrics().horizontalAdvance(name) + theme.u(8));
    painter.setFont(theme.font(TextRole::Caption, option.font));
    painter.setPen(theme.dim);
    const QString detail = index.data(DeviceModel::DetailRole).toString();
    painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter, detail);
    row.setRight(row.right() - painter.fontMetrics().horizontalAdvance(detail) - theme.u(6));
    const QString line = index.data(DeviceModel::LineRole).toString();
    painter.drawText(
        row, Qt::AlignLeft | Qt::AlignVCenter, painter.fontMetrics().elidedText(line, Qt::ElideRight, row.width()));
}

/// A dialect gives way to the name, which tells more; what is unusual does not.
QString DeviceDelegate::badgeFor(const QStyleOptionViewItem &option, const QModelIndex &index, int room) const
{
    const Theme &theme = m_theme.theme();
    const QString text = index.data(DeviceModel::BadgeRole).toString();
    const QFontMetrics caption(theme.font(TextRole::Caption, option.font));
    const QFontMetrics body(theme.font(TextRole::Body, option.font));
    const int wanted = body.horizontalAdvance(index.data().toString()) + caption.horizontalAdvance(text) + theme.u(18);
    return index.data(DeviceModel::UsualRole).toBool() && wanted > room ? QString() : text;
}

int DeviceDelegate::paintBadge(QPainter &painter, const QRect &row, const QString &text, const QFont &font) const
{
    if (text.isEmpty())
        return 0;
    const Theme &theme = m_theme.theme();
    painter.setFont(theme.font(TextRole::Caption, font));
    const QFontMetrics metrics = painter.fontMetrics();
    const int width = metrics.horizontalAdvance(text) + theme.u(12);
    const int height = metrics.height() + theme.u(2);
    const QRectF box(row.right() - width + 0.5, row.center().y() - height / 2.0 + 0.5, width - 1, height - 1);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(theme.caution, 1));
    painter.drawRoundedRect(box, theme.u(3), theme.u(3));
    painter.drawText(box, Qt::AlignCenter, text);
    return width + theme.u(6);
}

void DeviceDelegate::paintDevice(QPainter &painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    const Theme &theme = m_theme.theme();
    QRect row = option.rect.adjusted(theme.u(4), 0, -theme.u(10), 0);
    row.setLeft(row.left() + paintState(painter, row, index) + theme.u(10));
    row.setRight(row.right() - paintBadge(painter, row, badgeFor(option, index, row.width()), option.font));
    const auto draw = [&](TextRole role, const QColor &color, const QString &text, const QRect &box, int vertical) {
        painter.setFont(theme.font(role, option.font));
        painter.setPen(color);
        painter.drawText(
            box, Qt::AlignLeft | vertical, painter.fontMetrics().elidedText(text, Qt::ElideRight, box.width()));
    };
    const int middle = row.center().y() + 1;
    draw(TextRole::Body, theme.text, index.data().toString(),
        QRect(row.left(), row.top(), row.width(), middle - row.top() + theme.u(1)), Qt::AlignBottom);
    draw(TextRole::Caption, theme.dim, index.data(DeviceModel::LineRole).toString(),
        QRect(row.left(), middle + theme.u(1), row.width(), row.bottom() - middle), Qt::AlignTop);
}

} // namespace mb
