// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotdecor.h"

#include <cmath>

namespace mb {

void StripFace::drawMarks(QCPPainter &painter, const QRectF &box) const
{
    const Theme &theme = m_theme.theme();
    const QCPAxis &keys = *m_rect.axis(QCPAxis::atBottom);
    const QFontMetrics metrics(caption());
    painter.setFont(caption());
    for (const PlotMark &mark : m_decor.marks) {
        const double x = std::floor(keys.coordToPixel(mark.key)) + 0.5;
        if (x < box.left() || x > box.right())
            continue;
        QPen pen(theme.dim, 1, Qt::DotLine);
        pen.setCosmetic(true);
        painter.setAntialiasing(false);
        painter.setPen(pen);
        painter.drawLine(QLineF(x, box.top(), x, box.bottom()));
        if (!m_decor.first)
            continue;
        const int width = metrics.horizontalAdvance(mark.text) + theme.u(10);
        QRectF flag(x, box.top() + theme.u(20), width, metrics.height() + theme.u(4));
        if (flag.right() > box.right())
            flag.moveRight(x);
        painter.setAntialiasing(true);
        painter.setPen(QPen(theme.outline, 1));
        painter.setBrush(theme.panel);
        painter.drawRoundedRect(flag, theme.u(3), theme.u(3));
        painter.setPen(theme.text);
        painter.drawText(flag, Qt::AlignCenter, mark.text);
    }
}

void StripFace::drawTrigger(QCPPainter &painter, const QRectF &box) const
{
    if (!m_decor.trigger)
        return;
    const Theme &theme = m_theme.theme();
    const QCPAxis &values = *m_rect.axis(m_decor.trigger->second ? QCPAxis::atRight : QCPAxis::atLeft);
    const double wanted = values.coordToPixel(m_decor.trigger->level);
    const double y = std::floor(std::clamp(wanted, box.top(), box.bottom())) + 0.5;
    const bool inside = wanted >= box.top() && wanted <= box.bottom();
    QPen pen(theme.accent, 1);
    pen.setCosmetic(true);
    pen.setDashPattern({1, 3});
    painter.setAntialiasing(false);
    painter.setPen(pen);
    if (inside)
        painter.drawLine(QLineF(box.left(), y, box.right(), y));
    painter.setAntialiasing(true);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.accent);
    const double size = theme.u(6);
    painter.drawPolygon(QPolygonF({{box.left(), y - size}, {box.left() + size, y}, {box.left(), y + size}}));
    painter.setFont(caption());
    painter.setPen(theme.accent);
    const double height = QFontMetricsF(caption()).height();
    const double top = y - height - 1 > box.top() ? y - height - 1 : y + 1;
    painter.drawText(QRectF(box.left() + theme.u(14), top, box.width() * 0.6, height), Qt::AlignLeft | Qt::AlignVCenter,
        m_decor.trigger->text);
}

} // namespace mb
