// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/glyphshapes.h"

#include <QPainter>
#include <QPainterPath>

namespace mb {
namespace {

/// What to draw in a 12-unit box: areas to fill, lines to stroke with a 1.5 pen, dashed or not.
struct Shape {
    QPainterPath fill;
    QPainterPath stroke;
    bool dashed = false;
    double width = 1.5;
};

QPainterPath polygon(std::initializer_list<QPointF> points, bool closed)
{
    QPainterPath path;
    for (const QPointF &point : points)
        path.elementCount() == 0 ? path.moveTo(point) : path.lineTo(point);
    if (closed)
        path.closeSubpath();
    return path;
}

Shape disc()
{
    Shape s;
    s.fill.addEllipse(QPointF(6, 6), 3.7, 3.7);
    return s;
}

Shape ring(double radius)
{
    Shape s;
    s.stroke.addEllipse(QPointF(6, 6), radius, radius);
    return s;
}

Shape chevrons()
{
    Shape s;
    s.fill = polygon({{1, 2.2}, {6, 6}, {1, 9.8}}, true);
    s.stroke = polygon({{6.6, 2.8}, {10.6, 6}, {6.6, 9.2}}, false);
    return s;
}

Shape triangle()
{
    Shape s;
    s.fill = polygon({{6, 1.4}, {11.2, 10.4}, {0.8, 10.4}}, true);
    return s;
}

Shape halfDisc()
{
    Shape s = ring(4.2);
    s.fill.moveTo(6, 1.8);
    s.fill.arcTo(QRectF(1.8, 1.8, 8.4, 8.4), 90, 180);
    s.fill.closeSubpath();
    return s;
}

Shape question()
{
    Shape s = ring(5);
    s.width = 1.2;
    s.stroke.moveTo(4.5, 4.9);
    s.stroke.cubicTo(4.4, 2.6, 7.7, 2.7, 7.5, 4.8);
    s.stroke.cubicTo(7.4, 5.9, 6, 5.8, 6, 7.1);
    s.fill.addEllipse(QPointF(6, 8.8), 0.8, 0.8);
    return s;
}

Shape cross()
{
    Shape s;
    s.width = 2.2;
    s.stroke = polygon({{2.4, 2.4}, {9.6, 9.6}}, false);
    s.stroke.addPath(polygon({{9.6, 2.4}, {2.4, 9.6}}, false));
    return s;
}

Shape tick()
{
    Shape s;
    s.width = 1.9;
    s.stroke = polygon({{1.8, 6.4}, {4.8, 9.4}, {10.3, 2.8}}, false);
    return s;
}

Shape dashedRing()
{
    Shape s = ring(4.4);
    s.width = 1.7;
    s.dashed = true;
    return s;
}

Shape square()
{
    Shape s;
    s.stroke.addRect(2.2, 2.2, 7.6, 7.6);
    return s;
}

Shape dash()
{
    Shape s;
    s.stroke = polygon({{2.6, 6}, {9.4, 6}}, false);
    return s;
}

Shape play()
{
    Shape s;
    s.fill = polygon({{2.4, 1.8}, {10.4, 6}, {2.4, 10.2}}, true);
    return s;
}

Shape clock()
{
    Shape s = ring(4.6);
    s.width = 1.3;
    s.stroke.addPath(polygon({{6, 3.4}, {6, 6.2}, {8, 7.2}}, false));
    return s;
}

Shape warning()
{
    Shape s;
    s.width = 1.3;
    s.stroke = polygon({{6, 1.3}, {11.3, 10.5}, {0.7, 10.5}}, true);
    s.stroke.addPath(polygon({{6, 4.8}, {6, 7.2}}, false));
    s.fill.addEllipse(QPointF(6, 8.8), 0.75, 0.75);
    return s;
}

Shape shapeOf(GlyphState state)
{
    switch (state) {
    case GlyphState::Online:
    case GlyphState::InRam:
    case GlyphState::Recording: return disc();
    case GlyphState::Moving: return chevrons();
    case GlyphState::Bootloader: return triangle();
    case GlyphState::Duplicate: return halfDisc();
    case GlyphState::Unassigned: return question();
    case GlyphState::Fault:
    case GlyphState::OutOfRange: return cross();
    case GlyphState::Gone: return ring(3.9);
    case GlyphState::Stored:
    case GlyphState::Done: return tick();
    case GlyphState::Edited: return dashedRing();
    case GlyphState::Assumed: return square();
    case GlyphState::Volatile: return dash();
    case GlyphState::Busy: return play();
    case GlyphState::Waiting: return clock();
    case GlyphState::Warning: return warning();
    }
    return {};
}

} // namespace

void paintGlyph(QPainter &painter, const QRectF &box, GlyphState state, const QColor &color)
{
    const Shape shape = shapeOf(state);
    const double unit = std::min(box.width(), box.height()) / 12.0;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(box.center().x() - 6 * unit, box.center().y() - 6 * unit);
    painter.scale(unit, unit);
    painter.fillPath(shape.fill, color);
    QPen pen(color, shape.width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    if (shape.dashed) {
        pen.setCapStyle(Qt::FlatCap);
        pen.setDashPattern({1.3, 0.733});
    }
    painter.strokePath(shape.stroke, pen);
    painter.restore();
}

} // namespace mb
