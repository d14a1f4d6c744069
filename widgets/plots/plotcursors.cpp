// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotcursors.h"

#include <cmath>

namespace mb {

PlotCursors::PlotCursors(QCustomPlot &plot, const ThemeSource &theme)
    : QCPAbstractItem(&plot)
    , m_theme(theme)
{
    setSelectable(false);
    setLayer(QStringLiteral("overlay"));
    setClipToAxisRect(false);
    setVisible(false);
}

double PlotCursors::pixel(double key) const
{
    return m_rects.front()->axis(QCPAxis::atBottom)->coordToPixel(key);
}

std::optional<bool> PlotCursors::hit(double x) const
{
    if (!visible() || m_rects.empty())
        return {};
    const double reach = m_theme.theme().u(6);
    const double a = std::abs(pixel(m_a) - x);
    const double b = std::abs(pixel(m_b) - x);
    if (std::min(a, b) > reach)
        return {};
    return b <= a;
}

void PlotCursors::draw(QCPPainter *painter)
{
    if (m_rects.empty())
        return;
    drawLine(*painter, m_a, QStringLiteral("A"));
    drawLine(*painter, m_b, QStringLiteral("B"));
    drawBox(*painter);
}

void PlotCursors::drawLine(QCPPainter &painter, double key, const QString &flag) const
{
    const Theme &theme = m_theme.theme();
    const QRect top = m_rects.front()->rect();
    const double x = std::floor(pixel(key)) + 0.5;
    if (x < top.left() || x > top.right())
        return;
    QPen pen(theme.accent, 1);
    pen.setCosmetic(true);
    painter.setAntialiasing(false);
    painter.setPen(pen);
    for (const QCPAxisRect *rect : m_rects)
        painter.drawLine(QLineF(x, rect->top(), x, rect->bottom()));
    painter.setAntialiasing(true);
    const QRectF box(x - theme.u(9), top.top() + 1, theme.u(18), theme.u(16));
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.fill);
    painter.drawRoundedRect(box, theme.u(3), theme.u(3));
    const QFont caption = theme.font(TextRole::Caption, parentPlot()->font());
    QFont bold = caption;
    bold.setBold(true);
    painter.setFont(bold);
    painter.setPen(theme.onFill);
    painter.drawText(box, Qt::AlignCenter, flag);
}

void PlotCursors::drawBox(QCPPainter &painter) const
{
    if (m_rows.empty())
        return;
    const Theme &theme = m_theme.theme();
    const QFont caption = theme.font(TextRole::Caption, parentPlot()->font());
    const QFont body = theme.font(TextRole::Body, parentPlot()->font());
    int names = 0;
    int values = 0;
    for (const Row &row : m_rows) {
        names = std::max(names, QFontMetrics(caption).horizontalAdvance(row.name));
        values = std::max(values, QFontMetrics(theme.font(TextRole::Emphasis, body)).horizontalAdvance(row.value));
    }
    const double line = theme.u(18);
    const QRect area = m_rects.front()->rect();
    QRectF box(0, 0, names + values + theme.u(36), line * static_cast<double>(m_rows.size()) + theme.u(12));
    const double right = std::max(pixel(m_a), pixel(m_b));
    const bool fits = right + theme.u(10) + box.width() < area.right();
    box.moveLeft(fits ? right + theme.u(10) : std::min(pixel(m_a), pixel(m_b)) - theme.u(10) - box.width());
    box.moveLeft(std::max(box.left(), area.left() + 4.0));
    box.moveTop(
        std::min<double>(area.center().y(), std::max<double>(area.top(), area.bottom() - box.height() - theme.u(8))));
    painter.setAntialiasing(true);
    painter.setPen(QPen(theme.outline, 1));
    painter.setBrush(theme.panel);
    painter.drawRoundedRect(box, theme.u(4), theme.u(4));
    QRectF row(box.left() + theme.u(10), box.top() + theme.u(6), box.width() - theme.u(20), line);
    for (const Row &entry : m_rows) {
        painter.setFont(caption);
        painter.setPen(theme.dim);
        painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter, entry.name);
        painter.setFont(entry.strong ? theme.font(TextRole::Emphasis, body) : body);
        painter.setPen(theme.text);
        painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter, entry.value);
        row.translate(0, line);
    }
}

} // namespace mb
