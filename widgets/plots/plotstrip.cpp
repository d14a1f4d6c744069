// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotstrip.h"

#include "widgets/plots/stripbackdrop.h"
#include "widgets/plots/stripface.h"

#include <algorithm>

namespace mb {

PlotStrip::PlotStrip(
    PlotFrame &plot, QCPMarginGroup &margins, const QSharedPointer<TimeTicker> &time, const ThemeSource &theme)
    : m_theme(theme)
    , m_rect(new QCPAxisRect(&plot))
{
    m_rect->setMarginGroup(QCP::msLeft, &margins);
    const auto axes = m_rect->axes();
    for (QCPAxis *axis : axes) {
        axis->setLayer(QStringLiteral("axes"));
        axis->grid()->setLayer(QStringLiteral("grid"));
    }
    axis(false).setTicker(QSharedPointer<NumberTicker>::create());
    axis(true).setTicker(QSharedPointer<NumberTicker>::create());
    axis(true).grid()->setVisible(false);
    keys().setTicker(time);
    new StripBackdrop(*m_rect, theme, decor); // both belong to the plot
    new StripFace(*m_rect, theme, decor);
}

void PlotStrip::restyle(const QFont &font, bool last)
{
    const Theme &theme = m_theme.theme();
    const QFont caption = theme.font(TextRole::Caption, font);
    for (const auto type : {QCPAxis::atLeft, QCPAxis::atRight, QCPAxis::atBottom}) {
        QCPAxis &axis = *m_rect->axis(type);
        axis.setBasePen(QPen(theme.outline, 1));
        axis.setTickPen(Qt::NoPen);
        axis.setSubTickPen(Qt::NoPen);
        axis.setTickLength(0);
        axis.setTickLabelPadding(theme.u(type == QCPAxis::atBottom ? 6 : 7));
        axis.setTickLabelFont(caption);
        axis.setTickLabelColor(theme.dim);
        axis.grid()->setPen(QPen(theme.grid, 1));
        axis.grid()->setZeroLinePen(QPen(type == QCPAxis::atBottom ? theme.grid : theme.line, 1));
    }
    keys().setTickLabels(last);
    const int below = theme.u(last ? 26 : 6);
    m_rect->setAutoMargins(QCP::msLeft);
    decor.headGap = style.legend || !style.title.isEmpty() ? theme.u(8) : 0;
    const int above = theme.u(headHeight) + decor.headGap + theme.u(decor.headGap > 0 ? 8 : 2);
    m_rect->setMargins(QMargins(0, above, m_rect->margins().right(), below));
    decor.keyUnit = last ? tr("s") : QString();
}

void PlotStrip::setRightMargin(int pixels)
{
    const QMargins margins = m_rect->margins();
    m_rect->setMargins({margins.left(), margins.top(), pixels, margins.bottom()});
}

void PlotStrip::fix(std::optional<Range> range)
{
    m_scales[0].fixed = range;
    m_scales[0].automatic.reset();
}

void PlotStrip::zoom(double factor, double y)
{
    for (const bool second : {false, true}) {
        const double around = axis(second).pixelToCoord(y);
        const QCPRange range = axis(second).range();
        m_scales.at(second ? 1 : 0).fixed
            = {around - (around - range.lower) * factor, around + (range.upper - around) * factor};
    }
}

void PlotStrip::zoomInto(int bottom, int top)
{
    for (const bool second : {false, true})
        m_scales.at(second ? 1 : 0).fixed = {axis(second).pixelToCoord(bottom), axis(second).pixelToCoord(top)};
}

void PlotStrip::release()
{
    for (Scale &scale : m_scales)
        scale.fixed.reset();
}

void PlotStrip::fit()
{
    release();
    for (Scale &scale : m_scales)
        scale.automatic.reset();
}

bool PlotStrip::scale(bool second, std::optional<Range> seen, double now, double least)
{
    QCPAxis &values = axis(second);
    Scale &scale = m_scales.at(second ? 1 : 0);
    values.ticker()->setTickCount(std::clamp(m_rect->height() / m_theme.theme().u(42), 2, 5));
    values.ticker().staticCast<NumberTicker>()->spaceLabels(
        QFontMetrics(values.tickLabelFont()).height(), m_rect->height());
    if (scale.fixed) {
        values.setRange(scale.fixed->first, scale.fixed->second);
        return false;
    }
    if (!seen)
        return false;
    const AutoRange::Range range = scale.automatic.update(seen->first, seen->second, now, least);
    const bool other = values.range() != QCPRange(range.lower, range.upper);
    values.setRange(range.lower, range.upper);
    return other;
}

} // namespace mb
