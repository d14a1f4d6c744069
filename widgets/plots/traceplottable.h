// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"
#include "widgets/plots/columnpath.h"

#include "widgets/plots/qcustomplotkeywords.h"

#include <QImage>

namespace mb {

class TraceRaster;

/// The pattern of a line says its role: measured, pinned, wished for, predicted.
enum class TraceDash { Automatic, Solid, Long, Short, Dots };
enum class TraceMarker { Automatic, None, Triangle, Disc, Diamond, Square, HollowSquare };

/// How a trace looks. Colour follows from the role.
struct TraceLook {
    TraceRole role = TraceRole::Neutral;
    TraceDash dash = TraceDash::Automatic;       ///< Automatic: set-point short dashes, everything else solid
    TraceMarker marker = TraceMarker::Automatic; ///< Automatic: by quantity
    bool emphasis = false;                       ///< heavier, for the one that matters
    /// Where a trace of this role is in the plot already: the colour of another role.
    std::optional<TraceRole> colour{};

    [[nodiscard]] TraceRole colourRole() const { return colour.value_or(role); }
};

/// Pen of a trace, 1 px and cosmetic: for legends and lines beside the data.
QPen tracePen(const TraceLook &look, const Theme &theme);
TraceMarker markerOf(const TraceLook &look);
void paintMarker(QPainter &painter, const QPointF &at, TraceMarker marker, const QColor &color, double size);
/// A piece of the line with its marker, for legends.
void paintSwatch(QPainter &painter, const QRectF &box, const TraceLook &look, const Theme &theme);

/// Draws the columns of a TraceSource: pixel by pixel into the picture of a PlotFrame, with a pen into anything else, and markers every
/// 12 % of the width. A one-sample spike between two pixels stays visible at every zoom.
class TracePlottable : public QCPAbstractPlottable {
    Q_OBJECT
public:
    TracePlottable(QCPAxis *keyAxis, QCPAxis *valueAxis);

    void setLook(const TraceLook &look, const Theme &theme);
    const TraceLook &look() const { return m_look; }
    /// Swaps, so that the buffers are reused.
    void swapPoints(std::vector<PlotPoint> &points) { m_points.swap(points); }
    const std::vector<PlotPoint> &points() const { return m_points; }

    double selectTest(const QPointF &pos, bool onlySelectable, QVariant *details = nullptr) const override;
    QCPRange getKeyRange(bool &foundRange, QCP::SignDomain inSignDomain = QCP::sdBoth) const override;
    QCPRange getValueRange(bool &foundRange, QCP::SignDomain inSignDomain = QCP::sdBoth,
        const QCPRange &inKeyRange = QCPRange()) const override;

protected:
    void draw(QCPPainter *painter) override;
    void drawLegendIcon(QCPPainter *painter, const QRectF &rect) const override;

private:
    PixelMap pixelMap(double columnWidth) const;
    double strokeWidth() const;
    void drawPixels(QImage &image, const PixelMap &map, TraceRaster &raster) const;
    void drawPath(QCPPainter &painter, const ColumnPath &path) const;
    void drawMarkers(QCPPainter &painter, const PixelMap &map);
    const QImage &markerPicture(double ratio);

    TraceLook m_look;
    double m_unit = 1.0; ///< pixels for a length of 1 at 10 pt
    std::vector<PlotPoint> m_points;
    QImage m_marker;
};

} // namespace mb
