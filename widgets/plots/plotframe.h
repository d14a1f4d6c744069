// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plots/qcustomplotkeywords.h"
#include "widgets/plots/traceraster.h"

#include <vector>

namespace mb {

/// A QCustomPlot that draws all its layers into one opaque picture instead of a translucent buffer for each: a third of
/// the memory traffic, and traces can write their pixels themselves (TraceRaster). Call render() where one would call
/// replot().
class PlotFrame : public QCustomPlot {
    Q_OBJECT
public:
    explicit PlotFrame(QWidget *parent = nullptr);

    void setCanvas(const QColor &color);
    /// Draws everything and shows it at once.
    void render();
    /// Draws anew and shows what lies in `moving`. Who draws outside of it leaves that out when stands() says so.
    void renderPart(const QRegion &moving);
    /// What lies outside of the moving part is on the picture already, and would be drawn twice.
    bool stands() const { return m_stands; }
    TraceRaster &raster() { return m_raster; }
    /// The same picture at another size and scale, for files and the clipboard; null without the memory for it.
    QImage picture(const QSize &size, double ratio);

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    /// Whether there is a picture of the right size already.
    bool makeFrame();
    void drawFrame();
    void drawInto(QImage &image, const QRegion &area);

    std::vector<QRgb> m_pixels;
    QImage m_frame; ///< of m_pixels
    QColor m_canvas = Qt::black;
    TraceRaster m_raster; ///< of all traces, one after the other
    bool m_stands = false;
};

} // namespace mb
