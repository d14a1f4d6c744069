// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/design/sliderscale.h"

#include <QPainter>

#include <algorithm>

namespace mb {
namespace {

constexpr int sliderEdge = 8; ///< units, from an end of the slider to where its handle can be
constexpr int markSize = 8;   ///< units
constexpr int markGap = 5;

} // namespace

SliderScale::SliderScale(const ThemeSource &theme, const QString &low, const QString &high, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
    , m_low(low)
    , m_high(high)
{
    connect(&theme, &ThemeSource::changed, this, [this] { update(); });
}

QFont SliderScale::captionFont() const
{
    return m_theme.theme().font(TextRole::Caption, font());
}

void SliderScale::setMark(double share, const QString &words)
{
    if (share == m_share && words == m_words)
        return;
    m_share = share;
    m_words = words;
    updateGeometry();
    update();
}

/// The left end of markSize and words, which stay inside.
double SliderScale::markAt(int width) const
{
    const Theme &look = m_theme.theme();
    const double at = look.u(sliderEdge) + m_share * (width - 2.0 * look.u(sliderEdge)) - look.u(markSize) / 2.0;
    return std::clamp(at, 0.0, std::max(0.0, width - 1.0 * look.u(markSize)));
}

bool SliderScale::needsLine(int width) const
{
    const Theme &look = m_theme.theme();
    const QFontMetrics metrics(captionFont());
    const double from = markAt(width);
    const double to = from + look.u(markSize + markGap) + metrics.horizontalAdvance(m_words);
    return from < metrics.horizontalAdvance(m_low) + look.u(markGap)
        || to > width - metrics.horizontalAdvance(m_high) - look.u(markGap);
}

int SliderScale::heightForWidth(int width) const
{
    return QFontMetrics(captionFont()).height() * (needsLine(width) ? 2 : 1);
}

QSize SliderScale::sizeHint() const
{
    const QFontMetrics metrics(captionFont());
    const int ends
        = metrics.horizontalAdvance(m_low) + metrics.horizontalAdvance(m_high) + m_theme.theme().u(2 * markGap);
    return {std::max(ends, metrics.horizontalAdvance(m_words) + m_theme.theme().u(markSize + markGap)),
        heightForWidth(std::max(width(), ends))};
}

void SliderScale::paintEvent(QPaintEvent *)
{
    const Theme &look = m_theme.theme();
    const QFontMetrics metrics(captionFont());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(captionFont());
    painter.setPen(look.dim);
    painter.drawText(QPointF(0.0, metrics.ascent()), m_low);
    painter.drawText(QPointF(width() - metrics.horizontalAdvance(m_high), metrics.ascent()), m_high);
    const double from = markAt(width());
    const double top = needsLine(width()) ? metrics.height() : 0.0;
    const double size = look.u(markSize);
    const double foot = top + metrics.ascent();
    const double spoken = metrics.horizontalAdvance(m_words);
    const double words = from + size + look.u(markGap) + spoken > width() ? from - look.u(markGap) - spoken
                                                                          : from + size + look.u(markGap);
    painter.drawText(QPointF(std::max(0.0, words), foot), m_words);
    painter.setPen(Qt::NoPen);
    painter.setBrush(look.dim);
    painter.drawPolygon(
        QPolygonF({QPointF(from, foot), QPointF(from + size, foot), QPointF(from + size / 2.0, foot - size)}));
}

} // namespace mb
