// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/busloadview.h"

#include "widgets/common/clamped.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/spoken.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <array>
#include <limits>

namespace mb {

BusLoadView::BusLoadView(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    setAccessibleName(tr("Bus load of the last minute"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    followTheme(theme, *this);
}

QSize BusLoadView::sizeHint() const
{
    return {m_theme.theme().u(200), m_theme.theme().u(84)};
}

void BusLoadView::setLoads(const std::deque<double> &loads)
{
    m_loads = loads;
    const QString now = m_loads.empty() ? QString(UnknownMark) : formatNumber(m_loads.back() * 100.0, 0);
    setSpokenLive(*this, tr("now %1 %, peak %2 %").arg(now, formatNumber(peak() * 100.0, 0)));
    update();
}

double BusLoadView::peak() const
{
    return m_loads.empty() ? std::numeric_limits<double>::quiet_NaN() : *std::ranges::max_element(m_loads);
}

int BusLoadView::top() const
{
    static constexpr std::array steps{10, 20, 40, 60, 80};
    const auto *const fits
        = std::ranges::find_if(steps, [this](int step) { return m_loads.empty() || peak() * 100.0 <= step; });
    return fits == steps.end() ? 100 : *fits;
}

void BusLoadView::paintEvent(QPaintEvent *)
{
    const Theme &theme = m_theme.theme();
    QPainter painter(this);
    painter.setFont(theme.font(TextRole::Caption, font()));
    const QFontMetrics metrics = painter.fontMetrics();
    const int left = metrics.horizontalAdvance(QStringLiteral("100")) + theme.u(6);
    const QRectF box(left, metrics.height() / 2.0, width() - left - theme.u(6), height() - metrics.height() * 1.7);
    paintScales(painter, box);
    if (!m_loads.empty())
        paintLoad(painter, box);
}

void BusLoadView::paintScales(QPainter &painter, const QRectF &box) const
{
    const Theme &theme = m_theme.theme();
    const QFontMetrics metrics = painter.fontMetrics();
    painter.fillRect(box, theme.canvas);
    for (int i = 0; i <= 2; ++i) {
        const double y = box.bottom() - box.height() * i / 2.0;
        painter.setPen(QPen(theme.grid, 1));
        painter.drawLine(QPointF(box.left(), y), QPointF(box.right(), y));
        painter.setPen(theme.dim);
        painter.drawText(QRectF(0, y - metrics.height() / 2.0, box.left() - theme.u(4), metrics.height()),
            Qt::AlignRight | Qt::AlignVCenter, QString::number(top() * i / 2));
    }
    for (int i = 0; i <= 3; ++i) {
        const double x = box.left() + box.width() * i / 3.0;
        const QString text = i == 3 ? QStringLiteral("0") : formatNumber(i * 20.0 - 60.0, 0);
        const double size = metrics.horizontalAdvance(text) + 2.0;
        painter.drawText(QRectF(clamped(x - size / 2, 0.0, width() - size), box.bottom() + 2, size, metrics.height()),
            Qt::AlignCenter, text);
    }
}

void BusLoadView::paintLoad(QPainter &painter, const QRectF &box) const
{
    const QColor &ink = m_theme.theme().dim;
    QPolygonF line;
    const double step = box.width() / static_cast<double>(points - 1);
    double x = box.right() - step * static_cast<double>(m_loads.size() - 1);
    for (const double load : m_loads) {
        line << QPointF(x, box.bottom() - std::min(load * 100.0 / top(), 1.0) * box.height());
        x += step;
    }
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath area;
    area.addPolygon(line);
    area.lineTo(line.last().x(), box.bottom());
    area.lineTo(line.first().x(), box.bottom());
    QColor fill = ink;
    fill.setAlphaF(0.18);
    painter.fillPath(area, fill);
    painter.setPen(QPen(ink, 1.2));
    painter.drawPolyline(line);
}

} // namespace mb
