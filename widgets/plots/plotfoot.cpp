// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotfoot.h"

#include "widgets/plots/plotframe.h"

namespace mb {

PlotFoot::PlotFoot(QCustomPlot &plot, const ThemeSource &theme)
    : QCPLayoutElement(&plot)
    , m_theme(theme)
{
    setLayer(QStringLiteral("axes"));
    setMinimumMargins({});
    setMargins({});
}

void PlotFoot::setTexts(const QString &left, const QString &right, bool loss)
{
    m_left = left;
    m_right = right;
    m_loss = loss;
}

QSize PlotFoot::minimumOuterSizeHint() const
{
    return {10, m_theme.theme().u(24)};
}

QSize PlotFoot::maximumOuterSizeHint() const
{
    return {QWIDGETSIZE_MAX, m_theme.theme().u(24)};
}

void PlotFoot::draw(QCPPainter *painter)
{
    const auto *frame = qobject_cast<const PlotFrame *>(parentPlot());
    if (frame && frame->stands())
        return;
    const Theme &theme = m_theme.theme();
    const QRectF box = rect();
    painter->setAntialiasing(false);
    painter->fillRect(QRectF(box.left(), box.top(), box.width(), 1), theme.line);
    const QFont font = theme.font(TextRole::Caption, parentPlot()->font());
    const QFontMetrics metrics(font);
    const QRectF line = box.adjusted(theme.u(12), 0, -theme.u(12), 0);
    const int leftWidth = metrics.horizontalAdvance(m_left) + theme.u(16);
    const int room = static_cast<int>(line.width()) - leftWidth;
    painter->setFont(font);
    painter->setPen(theme.dim);
    painter->drawText(line, Qt::AlignLeft | Qt::AlignVCenter, m_left);
    painter->setPen(m_loss ? theme.caution : theme.dim);
    painter->drawText(
        line, Qt::AlignRight | Qt::AlignVCenter, metrics.elidedText(m_right, Qt::ElideLeft, std::max(room, 0)));
}

} // namespace mb
