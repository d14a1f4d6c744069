// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotframe.h"

#include <QtMath>

namespace mb {
namespace {

constexpr int CacheLine = 16; ///< pixels

} // namespace

PlotFrame::PlotFrame(QWidget *parent)
    : QCustomPlot(parent)
{
}

void PlotFrame::setCanvas(const QColor &color)
{
    m_canvas = color;
    setBackground(color);
}

void PlotFrame::render()
{
    Q_EMIT beforeReplot();
    drawFrame();
    repaint();
    Q_EMIT afterReplot();
}

void PlotFrame::renderPart(const QRegion &moving)
{
    if (!makeFrame()) {
        render();
        return;
    }
    Q_EMIT beforeReplot();
    m_stands = true;
    drawInto(m_frame, moving);
    m_stands = false;
    repaint(moving);
    Q_EMIT afterReplot();
}

bool PlotFrame::makeFrame()
{
    const double ratio = devicePixelRatioF();
    const QSize size(qCeil(width() * ratio), qCeil(height() * ratio));
    if (m_frame.size() == size && m_frame.devicePixelRatio() == ratio)
        return !m_frame.isNull();
    // An odd number of cache lines: pixels below each other do not fight for the same place in the cache.
    const int stride = ((size.width() + CacheLine - 1) / CacheLine | 1) * CacheLine;
    m_pixels.assign(static_cast<std::size_t>(stride) * static_cast<std::size_t>(size.height()), 0);
    m_frame = QImage(reinterpret_cast<uchar *>(m_pixels.data()), size.width(), size.height(),
        stride * static_cast<int>(sizeof(QRgb)), QImage::Format_RGB32);
    m_frame.setDevicePixelRatio(ratio);
    setBufferDevicePixelRatio(ratio); // of the labels that the axes keep
    return false;
}

void PlotFrame::drawFrame()
{
    makeFrame();
    if (!m_frame.isNull())
        drawInto(m_frame, rect());
}

void PlotFrame::drawInto(QImage &image, const QRegion &area)
{
    QCPPainter painter(&image);
    for (const QRect &part : area)
        painter.fillRect(part, m_canvas);
    draw(&painter);
}

QImage PlotFrame::picture(const QSize &size, double ratio)
{
    QImage image(size * ratio, QImage::Format_RGB32);
    if (image.isNull())
        return image;
    image.setDevicePixelRatio(ratio);
    const QRect before = viewport();
    const double ratioBefore = bufferDevicePixelRatio();
    setViewport(QRect(QPoint(), size));
    setBufferDevicePixelRatio(ratio); // of the labels that the axes keep
    drawInto(image, viewport());
    setBufferDevicePixelRatio(ratioBefore);
    setViewport(before);
    return image;
}

void PlotFrame::paintEvent(QPaintEvent *)
{
    if (m_frame.isNull() || m_frame.devicePixelRatio() != devicePixelRatioF())
        drawFrame();
    QPainter painter(this);
    painter.drawImage(QPoint(), m_frame);
}

void PlotFrame::resizeEvent(QResizeEvent *)
{
    setViewport(rect());
    drawFrame();
}

} // namespace mb
