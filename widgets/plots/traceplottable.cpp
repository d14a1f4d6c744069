// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/traceplottable.h"

#include "widgets/plots/spancanvas.h"

#include <cmath>

namespace mb {
namespace {

constexpr double MarkerEvery = 0.12; ///< of the width
constexpr int MostMarkers = 9;

QPolygonF corners(const QPointF &at, std::initializer_list<QPointF> offsets)
{
    QPolygonF polygon;
    for (const QPointF &offset : offsets)
        polygon << at + offset;
    return polygon;
}

} // namespace

QPen tracePen(const TraceLook &look, const Theme &theme)
{
    QPen pen(theme.trace(look.colourRole()), 1);
    pen.setCosmetic(true);
    const bool automaticDash = look.dash == TraceDash::Automatic && look.role == TraceRole::Setpoint;
    if (look.dash == TraceDash::Long)
        pen.setDashPattern({9, 5});
    else if (look.dash == TraceDash::Short || automaticDash)
        pen.setDashPattern({6, 4});
    else if (look.dash == TraceDash::Dots)
        pen.setDashPattern({2, 3});
    return pen;
}

TraceMarker markerOf(const TraceLook &look)
{
    if (look.marker != TraceMarker::Automatic)
        return look.marker;
    switch (look.role) {
    case TraceRole::Velocity: return TraceMarker::Triangle;
    case TraceRole::Position: return TraceMarker::Disc;
    case TraceRole::Current: return TraceMarker::Diamond;
    case TraceRole::Duty: return TraceMarker::Square;
    case TraceRole::Setpoint:
    case TraceRole::Error:
    case TraceRole::Temperature:
    case TraceRole::Neutral: break;
    }
    return TraceMarker::None;
}

void paintMarker(QPainter &painter, const QPointF &at, TraceMarker marker, const QColor &color, double size)
{
    const double r = size / 2;
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    switch (marker) {
    case TraceMarker::Triangle: painter.drawPolygon(corners(at, {{0, -r * 1.1}, {r, r * 0.8}, {-r, r * 0.8}})); break;
    case TraceMarker::Disc: painter.drawEllipse(at, r * 0.9, r * 0.9); break;
    case TraceMarker::Diamond:
        painter.drawPolygon(corners(at, {{0, -r * 1.15}, {r * 1.15, 0}, {0, r * 1.15}, {-r * 1.15, 0}}));
        break;
    case TraceMarker::Square: painter.drawRect(QRectF(at.x() - r * 0.8, at.y() - r * 0.8, r * 1.6, r * 1.6)); break;
    case TraceMarker::HollowSquare:
        painter.setPen(QPen(color, 1.2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(at.x() - r * 0.9, at.y() - r * 0.9, r * 1.8, r * 1.8));
        break;
    case TraceMarker::None:
    case TraceMarker::Automatic: break;
    }
}

void paintSwatch(QPainter &painter, const QRectF &box, const TraceLook &look, const Theme &theme)
{
    QPen pen = tracePen(look, theme);
    QVector<qreal> pattern = pen.dashPattern();
    for (qreal &length : pattern)
        length /= 2; // counted in pen widths
    pen.setWidthF(2);
    if (!pattern.isEmpty())
        pen.setDashPattern(pattern);
    const double y = std::floor(box.center().y()) + 0.5;
    painter.setPen(pen);
    painter.drawLine(QPointF(box.left(), y), QPointF(box.right(), y));
    paintMarker(painter, QPointF(box.center().x(), y), markerOf(look), pen.color(), theme.u(8));
}

TracePlottable::TracePlottable(QCPAxis *keyAxis, QCPAxis *valueAxis)
    : QCPAbstractPlottable(keyAxis, valueAxis)
{
    setSelectable(QCP::stNone);
    setAntialiased(true);
}

void TracePlottable::setLook(const TraceLook &look, const Theme &theme)
{
    m_look = look;
    m_markerSize = theme.u(8);
    setPen(tracePen(look, theme));
}

double TracePlottable::selectTest(const QPointF &, bool, QVariant *) const
{
    return -1;
}

QCPRange TracePlottable::getKeyRange(bool &foundRange, QCP::SignDomain) const
{
    foundRange = !m_points.empty();
    return foundRange ? QCPRange(m_points.front().key, m_points.back().key) : QCPRange();
}

QCPRange TracePlottable::getValueRange(bool &foundRange, QCP::SignDomain, const QCPRange &inKeyRange) const
{
    constexpr double Everywhere = std::numeric_limits<double>::infinity();
    const bool limited = inKeyRange != QCPRange();
    const auto range
        = valueRange(m_points, limited ? inKeyRange.lower : -Everywhere, limited ? inKeyRange.upper : Everywhere);
    foundRange = range.has_value();
    return range ? QCPRange(range->first, range->second) : QCPRange();
}

PixelMap TracePlottable::pixelMap(double columnWidth) const
{
    const auto line = [](const QCPAxis &axis, double &scale, double &offset) {
        const QCPRange range = axis.range();
        const double lower = axis.coordToPixel(range.lower);
        scale = (axis.coordToPixel(range.upper) - lower) / range.size();
        offset = lower - scale * range.lower;
    };
    PixelMap map;
    line(*keyAxis(), map.keyScale, map.keyOffset);
    line(*valueAxis(), map.valueScale, map.valueOffset);
    map.columnWidth = columnWidth;
    return map;
}

void TracePlottable::draw(QCPPainter *painter)
{
    if (m_points.empty() || !keyAxis() || !valueAxis())
        return;
    const double ratio = std::max(1.0, painter->device()->devicePixelRatioF());
    const PixelMap map = pixelMap(1.0 / ratio);
    const ColumnPath path = columnPath(m_points, map);
    applyDefaultAntialiasingHint(painter);
    painter->setPen(pen());
    painter->setBrush(Qt::NoBrush);
    drawLines(*painter, path);
    // Strokes of 1 px beside each other: a wider pen costs 20 times as much.
    const bool measured = pen().style() == Qt::SolidLine;
    if (m_look.emphasis || measured)
        drawShifted(*painter, path, {0.5, 0.5});
    if (m_look.emphasis)
        drawShifted(*painter, path, {0.5, -0.5});
    drawMarkers(*painter, map);
}

void TracePlottable::drawShifted(QCPPainter &painter, const ColumnPath &path, const QPointF &shift) const
{
    for (const QPolygonF &line : path.lines)
        painter.drawPolyline(line.translated(shift));
}

void TracePlottable::drawLines(QCPPainter &painter, const ColumnPath &path) const
{
    for (const QPolygonF &line : path.lines) {
        if (line.size() == 1)
            painter.drawPoint(line.first());
        else
            painter.drawPolyline(line);
    }
    if (!path.spans.isEmpty())
        drawSpans(painter, path);
}

void TracePlottable::drawSpans(QCPPainter &painter, const ColumnPath &path) const
{
    if (m_canvas && !painter.modes().testFlag(QCPPainter::pmVectorized)) {
        m_canvas->add(path.spans, pen().color(), std::max(1.0, painter.device()->devicePixelRatioF()));
        return;
    }
    // A dash pattern along vertical spans would tear the trace apart.
    QPen solid = pen();
    solid.setStyle(Qt::SolidLine);
    painter.setAntialiasing(false);
    painter.setPen(solid);
    painter.drawLines(path.spans);
    painter.setPen(pen());
    applyDefaultAntialiasingHint(&painter);
}

void TracePlottable::drawMarkers(QCPPainter &painter, const PixelMap &map) const
{
    const TraceMarker marker = markerOf(m_look);
    if (marker == TraceMarker::None)
        return;
    const QCPRange range = keyAxis()->range();
    const double step = range.size() * MarkerEvery;
    painter.setAntialiasing(true);
    // Anchored to absolute time: the markers travel with the data instead of sliding along it.
    double key = std::ceil(range.lower / step) * step;
    for (int i = 0; i < MostMarkers && key <= range.upper; ++i, key += step) {
        const double value = valueAt(m_points, key);
        if (std::isfinite(value))
            paintMarker(painter, QPointF(map.x(key), map.y(value)), marker, pen().color(), m_markerSize);
    }
}

void TracePlottable::drawLegendIcon(QCPPainter *painter, const QRectF &rect) const
{
    painter->setPen(pen());
    painter->drawLine(QLineF(rect.left(), rect.center().y(), rect.right(), rect.center().y()));
}

} // namespace mb
