// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/stripbackdrop.h"

#include "widgets/plots/plotlabels.h"

namespace mb {
namespace {

constexpr double BandOpacity = 0.16;

QColor faded(QColor color, double opacity)
{
    color.setAlphaF(opacity);
    return color;
}

} // namespace

StripBackdrop::StripBackdrop(QCPAxisRect &rect, const ThemeSource &theme, const StripDecor &decor)
    : QCPAbstractItem(rect.parentPlot())
    , m_rect(rect)
    , m_theme(theme)
    , m_decor(decor)
{
    setSelectable(false);
    setLayer(QStringLiteral("grid"));
    setClipAxisRect(&rect);
    setClipToAxisRect(true);
}

void StripBackdrop::draw(QCPPainter *painter)
{
    const QRectF box = m_rect.rect();
    drawWatermark(*painter, box);
    painter->setAntialiasing(false);
    drawSpans(*painter, box);
    drawBands(*painter, box);
    drawGaps(*painter, box);
}

void StripBackdrop::drawWatermark(QCPPainter &painter, const QRectF &box) const
{
    if (m_decor.watermark.isEmpty() || box.height() < 24 || box.width() < 24)
        return;
    const Theme &theme = m_theme.theme();
    QFont font = theme.font(TextRole::Emphasis, parentPlot()->font());
    font.setPixelSize(static_cast<int>(std::min({box.height() * 0.5, box.width() * 0.16, theme.u(72) * 1.0})));
    font.setLetterSpacing(QFont::PercentageSpacing, 115);
    painter.setFont(font);
    painter.setPen(faded(theme.accent, theme.dark ? 0.12 : 0.13));
    painter.drawText(box, Qt::AlignCenter, m_decor.watermark);
}

void StripBackdrop::drawSpans(QCPPainter &painter, const QRectF &box) const
{
    const QCPAxis &keys = *m_rect.axis(QCPAxis::atBottom);
    const Theme &theme = m_theme.theme();
    for (const PlotSpan &span : m_decor.spans) {
        const double left = keys.coordToPixel(span.from);
        const QRectF area(left, box.top(), keys.coordToPixel(span.to) - left, box.height());
        painter.fillRect(area, faded(theme.trace(span.role), BandOpacity));
    }
}

void StripBackdrop::drawBands(QCPPainter &painter, const QRectF &box) const
{
    const QCPAxis &values = *m_rect.axis(QCPAxis::atLeft);
    const Theme &theme = m_theme.theme();
    for (const PlotBand &band : m_decor.bands) {
        const double top = values.coordToPixel(band.upper);
        const double bottom = std::max(values.coordToPixel(band.lower), top + 1);
        painter.fillRect(QRectF(box.left(), top, box.width(), bottom - top), faded(theme.tone(band.tone), BandOpacity));
    }
}

void StripBackdrop::drawGaps(QCPPainter &painter, const QRectF &box) const
{
    const QCPAxis &keys = *m_rect.axis(QCPAxis::atBottom);
    const Theme &theme = m_theme.theme();
    const QFont caption = theme.font(TextRole::Caption, parentPlot()->font());
    const QFontMetrics metrics(caption);
    painter.setFont(caption);
    for (const auto &[from, to] : m_decor.gaps) {
        const double left = std::max(keys.coordToPixel(from), box.left());
        const double right = std::min(keys.coordToPixel(to), box.right());
        if (right <= left)
            continue;
        const QRectF area(left, box.top(), std::max(right - left, 1.0), box.height());
        painter.fillRect(area, faded(theme.caution, 0.06));
        painter.fillRect(area, QBrush(faded(theme.caution, 0.45), Qt::BDiagPattern));
    }
    for (const GapLabel &label : gapLabels(m_decor, keys, box, metrics, theme)) {
        painter.fillRect(label.place, theme.bannerCaution);
        painter.setPen(theme.caution);
        painter.drawText(label.place, Qt::AlignCenter, label.text);
    }
}

} // namespace mb
