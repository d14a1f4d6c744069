// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/trafficdelegate.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace mb {

TrafficDelegate::TrafficDelegate(const ThemeSource &theme, QObject *parent)
    : QStyledItemDelegate(parent)
    , m_theme(theme)
{
    connect(&theme, &ThemeSource::changed, this, [this] { m_body = QFont(QStringLiteral("-")); });
    m_body = QFont(QStringLiteral("-"));
}

QSize TrafficDelegate::sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    const auto role = static_cast<TextRole>(index.data(TextRoleRole).toInt());
    const QFontMetrics metrics(font(role, option.font));
    return {metrics.horizontalAdvance(index.data().toString()) + 2 * padding(), m_theme.theme().u(25)};
}

const QFont &TrafficDelegate::font(TextRole role, const QFont &body) const
{
    if (m_body != body) {
        m_body = body;
        m_fonts = {m_theme.theme().font(TextRole::Body, body), m_theme.theme().font(TextRole::Emphasis, body),
            m_theme.theme().font(TextRole::Raw, body)};
    }
    return m_fonts[role == TextRole::Emphasis ? 1 : role == TextRole::Raw ? 2 : 0];
}

void TrafficDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    paintGround(*painter, option, index);
    QRect room = option.rect.adjusted(padding(), 0, -padding(), -1);
    const QVariant spark = index.data(SparkRole);
    if (spark.isValid())
        return paintSpark(*painter, room, spark.value<QVector<double>>());
    const QVariant mark = index.data(DirectionRole);
    const QColor color = index.data(Qt::ForegroundRole).value<QColor>();
    painter->setPen(color.isValid() ? color : m_theme.theme().text);
    painter->setFont(font(static_cast<TextRole>(index.data(TextRoleRole).toInt()), option.font));
    const QString text = index.data().toString();
    const QVariant changed = index.data(BytesRole);
    if (changed.isValid())
        return paintBytes(*painter, room, text, changed.toInt());
    if (mark.isValid())
        paintMark(*painter, room, static_cast<Mark>(mark.toInt()));
    const QFontMetrics metrics = painter->fontMetrics();
    const bool fits = metrics.horizontalAdvance(text) <= room.width();
    painter->drawText(room, index.data(Qt::TextAlignmentRole).toInt() | Qt::TextSingleLine,
        fits ? text : metrics.elidedText(text, Qt::ElideRight, room.width()));
}

void TrafficDelegate::paintGround(QPainter &painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    const Theme &theme = m_theme.theme();
    const bool selected = option.state.testFlag(QStyle::State_Selected);
    const QVariant tint = index.data(Qt::BackgroundRole);
    if (selected)
        painter.fillRect(option.rect, theme.sel);
    else if (tint.isValid())
        painter.fillRect(option.rect, tint.value<QColor>());
    else if (option.state.testFlag(QStyle::State_MouseOver))
        painter.fillRect(option.rect, theme.window);
    painter.fillRect(QRect(option.rect.left(), option.rect.bottom(), option.rect.width(), 1), theme.grid);
    if (selected && index.column() == 0)
        painter.fillRect(QRect(option.rect.left(), option.rect.top(), theme.u(3), option.rect.height()), theme.accent);
}

void TrafficDelegate::paintMark(QPainter &painter, QRect &room, Mark mark) const
{
    const double side = m_theme.theme().u(7);
    const QFontMetrics metrics = painter.fontMetrics();
    QRectF box(room.left(), room.center().y() - side / 2 + 1, side, side);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    if (mark == ErrorMark) {
        painter.setPen(QPen(painter.pen().color(), 1.6));
        painter.drawLine(box.topLeft(), box.bottomRight());
        painter.drawLine(box.topRight(), box.bottomLeft());
    } else {
        if (mark == SentMark)
            box.moveLeft(room.left() + metrics.horizontalAdvance(QStringLiteral("tx")) + m_theme.theme().u(4));
        painter.setBrush(painter.pen().color());
        painter.setPen(Qt::NoPen);
        const QPointF tip(mark == SentMark ? box.right() : box.left(), box.center().y());
        const double back = mark == SentMark ? box.left() : box.right();
        painter.drawPolygon(QPolygonF({tip, {back, box.top()}, {back, box.bottom()}}));
    }
    painter.restore();
    if (mark != SentMark)
        room.setLeft(static_cast<int>(box.right()) + m_theme.theme().u(4));
}

void TrafficDelegate::paintBytes(QPainter &painter, const QRect &room, const QString &text, int changed) const
{
    const Theme &theme = m_theme.theme();
    const QColor still = painter.pen().color();
    const int width = painter.fontMetrics().horizontalAdvance(QStringLiteral("00"));
    const int step = painter.fontMetrics().horizontalAdvance(QStringLiteral("00 "));
    if (changed == 0 || text.size() % 3 != 2) {
        painter.drawText(room, Qt::AlignVCenter | Qt::TextSingleLine, text);
        return;
    }
    for (int i = 0; i * 3 < text.size() && i * step < room.width(); ++i) {
        const QRect cell(room.left() + i * step, room.top(), width + 1, room.height());
        const bool lately = ((changed >> i) & 1) != 0;
        if (lately)
            painter.fillRect(cell.adjusted(-2, theme.u(3), 1, -theme.u(3)), theme.sel);
        painter.setPen(lately ? theme.text : still);
        painter.drawText(cell, Qt::AlignVCenter | Qt::TextSingleLine, text.mid(i * 3, 2));
    }
}

void TrafficDelegate::paintSpark(QPainter &painter, const QRect &room, const QVector<double> &values) const
{
    constexpr int capacity = 100;
    double low = HUGE_VAL;
    double high = -HUGE_VAL;
    for (const double value : values) {
        if (std::isfinite(value)) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
    if (!(low <= high))
        return;
    const QRectF box = QRectF(room).adjusted(0, m_theme.theme().u(4), 0, -m_theme.theme().u(4));
    const double step = box.width() / (capacity - 1);
    double x = box.right() - step * (values.size() - 1);
    QPolygonF line;
    for (const double value : values) {
        if (std::isfinite(value))
            line << QPointF(
                x, high > low ? box.bottom() - (value - low) / (high - low) * box.height() : box.center().y());
        x += step;
    }
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(m_theme.theme().trace(TraceRole::Position), 1.0));
    line.size() > 1 ? painter.drawPolyline(line) : painter.drawPoint(line.first());
    painter.restore();
}

} // namespace mb
