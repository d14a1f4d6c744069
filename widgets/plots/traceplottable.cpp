// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/traceplottable.h"

#include "widgets/plots/plotframe.h"

#include <array>
#include <cmath>

namespace mb {
namespace {

constexpr double MarkerEvery = 0.12; ///< of the width
constexpr int MostMarkers = 9;
constexpr double MarkerSize = 8.0;
constexpr double MeasuredWidth = 1.5;
constexpr double EmphasisWidth = 2.2;

/// Lengths of a dash and of the pause after it; nothing for a solid line.
std::array<int, 2> dashesOf(const TraceLook &look)
{
    switch (look.dash) {
    case TraceDash::Long: return {9, 5};
    case TraceDash::Short: return {6, 4};
    case TraceDash::Dots: return {2, 3};
    case TraceDash::Automatic: return look.role == TraceRole::Setpoint ? std::array{6, 4} : std::array{0, 0};
    case TraceDash::Solid: break;
    }
    return {0, 0};
}

/// The picture that is painted on, where traces may write into it: not a file of lines, and nothing is scaled. (Half a
/// pixel is what QCPPainter moves for antialiasing.)
QImage *pictureOf(QCPPainter &painter)
{
    if (painter.modes().testFlag(QCPPainter::pmVectorized) || painter.device()->devType() != QInternal::Image
        || painter.worldTransform().type() > QTransform::TxTranslate)
        return nullptr;
    auto *image = static_cast<QImage *>(painter.device());
    return image->format() == QImage::Format_RGB32 ? image : nullptr;
}

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
    if (const auto [dash, pause] = dashesOf(look); dash > 0)
        pen.setDashPattern({dash + 0.0, pause + 0.0});
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
    m_unit = theme.u(100) / 100.0;
    m_marker = {};
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
    const PixelMap map = pixelMap(1.0 / std::max(1.0, painter->device()->devicePixelRatioF()));
    auto *frame = qobject_cast<PlotFrame *>(parentPlot());
    QImage *image = frame ? pictureOf(*painter) : nullptr;
    if (image)
        drawPixels(*image, map, frame->raster());
    else
        drawPath(*painter, columnPath(m_points, map));
    drawMarkers(*painter, map);
}

double TracePlottable::strokeWidth() const
{
    const bool measured = dashesOf(m_look)[0] == 0;
    return m_unit * (m_look.emphasis ? EmphasisWidth : (measured ? MeasuredWidth : 1.0));
}

void TracePlottable::drawPixels(QImage &image, const PixelMap &map, TraceRaster &raster) const
{
    const double ratio = image.devicePixelRatio();
    const QRect box = keyAxis()->axisRect()->rect();
    const QPoint corner(qCeil(box.left() * ratio), qCeil(box.top() * ratio));
    const QRect clip(corner, QSize(qFloor(box.width() * ratio), qFloor(box.height() * ratio)));
    PixelMap pixels;
    pixels.keyScale = map.keyScale * ratio;
    pixels.keyOffset = map.keyOffset * ratio - corner.x();
    pixels.valueScale = map.valueScale * ratio;
    pixels.valueOffset = (map.valueOffset + 0.5) * ratio - corner.y(); // a row counts from its middle, as the grid's
    const auto [dash, pause] = dashesOf(m_look);
    const double unit = m_unit * ratio;
    const TraceStroke stroke{pen().color().rgb(), strokeWidth() * ratio, qRound(dash * unit), qRound(pause * unit)};
    raster.draw(image, clip & image.rect(), m_points, pixels, stroke);
}

void TracePlottable::drawPath(QCPPainter &painter, const ColumnPath &path) const
{
    QPen line = pen();
    line.setWidthF(strokeWidth());
    QVector<qreal> pattern = line.dashPattern();
    for (qreal &length : pattern)
        length *= m_unit / strokeWidth(); // counted in pen widths
    if (!pattern.isEmpty())
        line.setDashPattern(pattern);
    painter.setAntialiasing(true);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(line);
    for (const QPolygonF &points : path.lines) {
        if (points.size() == 1)
            painter.drawPoint(points.first());
        else
            painter.drawPolyline(points);
    }
    // A dash pattern along vertical spans would tear the trace apart.
    line.setStyle(Qt::SolidLine);
    painter.setAntialiasing(false);
    painter.setPen(line);
    painter.drawLines(path.spans);
}

const QImage &TracePlottable::markerPicture(double ratio)
{
    if (!m_marker.isNull() && m_marker.devicePixelRatio() == ratio)
        return m_marker;
    const int side = qCeil(MarkerSize * m_unit * 1.5 * ratio) | 1; // a pixel in the middle
    m_marker = QImage(side, side, QImage::Format_ARGB32_Premultiplied);
    m_marker.setDevicePixelRatio(ratio);
    m_marker.fill(Qt::transparent);
    QPainter painter(&m_marker);
    painter.setRenderHint(QPainter::Antialiasing);
    const double middle = side / ratio / 2;
    paintMarker(painter, {middle, middle}, markerOf(m_look), pen().color(), MarkerSize * m_unit);
    return m_marker;
}

void TracePlottable::drawMarkers(QCPPainter &painter, const PixelMap &map)
{
    const TraceMarker marker = markerOf(m_look);
    if (marker == TraceMarker::None)
        return;
    const bool onPicture = pictureOf(painter) != nullptr;
    painter.setAntialiasing(!onPicture);
    const double ratio = painter.device()->devicePixelRatioF();
    const QCPRange range = keyAxis()->range();
    const double step = range.size() * MarkerEvery;
    // Anchored to absolute time: the markers travel with the data instead of sliding along it.
    double key = std::ceil(range.lower / step) * step;
    for (int i = 0; i < MostMarkers && key <= range.upper; ++i, key += step) {
        const double value = valueAt(m_points, key);
        if (!std::isfinite(value))
            continue;
        const QPointF at(map.x(key), map.y(value));
        if (!onPicture) {
            paintMarker(painter, at, marker, pen().color(), MarkerSize * m_unit);
            continue;
        }
        const QImage &picture = markerPicture(ratio);
        const double half = (picture.width() - 1) / 2;
        painter.drawImage(
            QPointF(std::floor(at.x() * ratio) - half, std::floor((at.y() + 0.5) * ratio) - half) / ratio, picture);
    }
}

void TracePlottable::drawLegendIcon(QCPPainter *painter, const QRectF &rect) const
{
    painter->setPen(pen());
    painter->drawLine(QLineF(rect.left(), rect.center().y(), rect.right(), rect.center().y()));
}

} // namespace mb
