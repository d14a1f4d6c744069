// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotdecor.h"

#include <cmath>

namespace mb {

void StripFace::drawMarks(QCPPainter &painter, const QRectF &box) const
{
    const Theme &theme = m_theme.theme();
    const QCPAxis &keys = *m_rect.axis(QCPAxis::atBottom);
    for (const PlotMark &mark : m_decor.marks) {
        const double x = std::floor(keys.coordToPixel(mark.key)) + 0.5;
        if (x < box.left() || x > box.right())
            continue;
        QPen pen(theme.dim, 1, Qt::DotLine);
        pen.setCosmetic(true);
        painter.setAntialiasing(false);
        painter.setPen(pen);
        painter.drawLine(QLineF(x, box.top(), x, box.bottom()));
    }
    painter.setAntialiasing(true);
}

void StripFace::drawFlag(QCPPainter &painter, const PlotMark &mark, const QRectF &place) const
{
    const Theme &theme = m_theme.theme();
    painter.setPen(QPen(theme.outline, 1));
    painter.setBrush(theme.panel);
    painter.drawRoundedRect(place, theme.u(3), theme.u(3));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(theme.text);
    painter.drawText(place, Qt::AlignCenter, mark.text);
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
}

} // namespace mb
