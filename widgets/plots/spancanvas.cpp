// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/spancanvas.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace mb {

SpanCanvas::SpanCanvas(QCPAxisRect &rect)
    : QCPAbstractItem(rect.parentPlot())
    , m_rect(rect)
{
    setSelectable(false);
    setLayer(QStringLiteral("spans"));
    setClipAxisRect(&rect);
    setClipToAxisRect(true);
}

void SpanCanvas::begin(double ratio)
{
    m_begun = true;
    m_ratio = ratio;
    const QSize size(
        static_cast<int>(std::ceil(m_rect.width() * ratio)), static_cast<int>(std::ceil(m_rect.height() * ratio)));
    if (m_image.size() != size) {
        m_image = QImage(size, QImage::Format_ARGB32_Premultiplied);
        m_image.fill(Qt::transparent);
    } else if (m_top <= m_bottom) {
        std::memset(m_image.scanLine(m_top), 0,
            static_cast<std::size_t>(m_image.bytesPerLine()) * static_cast<std::size_t>(m_bottom - m_top + 1));
    }
    m_top = size.height();
    m_bottom = -1;
}

void SpanCanvas::add(const QVector<QLineF> &spans, const QColor &color, double ratio)
{
    if (!m_begun)
        begin(ratio);
    if (m_image.isNull())
        return;
    const int width = m_image.width();
    const int height = m_image.height();
    const auto stride = static_cast<std::ptrdiff_t>(m_image.bytesPerLine()) / 4;
    auto *pixels = reinterpret_cast<QRgb *>(m_image.bits());
    const QRgb rgb = color.rgb() | 0xFF000000U;
    const double left = m_rect.left();
    const double top = m_rect.top();
    for (const QLineF &span : spans) {
        const int x = static_cast<int>(std::floor((span.x1() - left) * ratio));
        const int first = std::max(0, static_cast<int>(std::floor((span.y1() - top) * ratio)));
        const int last = std::min(height - 1, static_cast<int>(std::floor((span.y2() - top) * ratio)));
        if (x < 0 || x >= width || first > last)
            continue;
        m_top = std::min(m_top, first);
        m_bottom = std::max(m_bottom, last);
        QRgb *pixel = pixels + first * stride + x;
        for (int y = first; y <= last; ++y, pixel += stride)
            *pixel = rgb;
    }
}

void SpanCanvas::draw(QCPPainter *painter)
{
    if (!m_begun)
        return;
    m_begun = false;
    if (m_bottom < m_top)
        return;
    const QRect source(0, m_top, m_image.width(), m_bottom - m_top + 1);
    const QRectF target(
        m_rect.left(), m_rect.top() + m_top / m_ratio, source.width() / m_ratio, source.height() / m_ratio);
    painter->setRenderHint(QPainter::SmoothPixmapTransform, false);
    painter->drawImage(target, m_image, source);
}

} // namespace mb
