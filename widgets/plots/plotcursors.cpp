// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotcursors.h"

#include "widgets/plots/traceplottable.h"

#include <algorithm>
#include <cmath>

namespace mb {
namespace {

constexpr int worthMoving = 6; ///< pieces of a curve

/// Pieces of the curves of a strip behind a box.
int hiddenBy(const QRectF &box, const QCPAxisRect &strip)
{
    int hidden = 0;
    for (const QCPAbstractPlottable *plottable : strip.plottables()) {
        const auto *curve = qobject_cast<const TracePlottable *>(plottable);
        if (!curve || !curve->realVisibility())
            continue;
        const auto pixelOf = [&](const PlotPoint &point) {
            return QPointF(curve->keyAxis()->coordToPixel(point.key), curve->valueAxis()->coordToPixel(point.value));
        };
        const std::vector<PlotPoint> &points = curve->points();
        for (std::size_t i = 1; i < points.size(); ++i) {
            const QRectF piece = QRectF(pixelOf(points[i - 1]), pixelOf(points[i])).normalized();
            if (std::isfinite(piece.top()) && std::isfinite(piece.bottom()))
                hidden += piece.adjusted(-1, -1, 1, 1).intersects(box) ? 1 : 0;
        }
    }
    return hidden;
}

} // namespace

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
    m_boxes.clear();
    m_places.resize(m_rects.size());
    for (std::size_t strip = 0; strip < m_rects.size(); ++strip)
        drawBox(*painter, strip);
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

QRectF PlotCursors::boxFor(const QSizeF &size, std::size_t strip)
{
    const Theme &theme = m_theme.theme();
    const QCPAxisRect &of = *m_rects[strip];
    const QRectF area = QRectF(of.rect()).adjusted(theme.u(4), theme.u(2), -theme.u(4), -theme.u(2));
    const double aside = theme.u(12);
    const double left = std::min(pixel(m_a), pixel(m_b));
    const double right = std::max(pixel(m_a), pixel(m_b));
    std::vector<QRectF> places;
    for (const double x : {right + aside, left - aside - size.width(), (left + right - size.width()) / 2})
        for (const double y : {area.center().y() - size.height() / 2, area.top(), area.bottom() - size.height()})
            places.emplace_back(QPointF(x, y), size);
    const auto clash = [&](const QRectF &place) {
        const bool crossed = (place.left() < left + aside && place.right() > left - aside)
            || (place.left() < right + aside && place.right() > right - aside);
        return !area.contains(place) || crossed;
    };
    std::optional<std::size_t> best;
    int least = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (clash(places[i]))
            continue;
        const int hidden = hiddenBy(places[i], of) - (i == m_places[strip] ? worthMoving : 0);
        if (!best || hidden < least) {
            best = i;
            least = hidden;
        }
    }
    if (best) {
        m_places[strip] = *best;
        return places[*best];
    }
    QRectF place = places.front();
    place.moveRight(std::min(place.right(), area.right()));
    place.moveLeft(std::max(place.left(), area.left()));
    place.moveTop(std::max(place.top(), area.top()));
    return place;
}

/// Rows for which the strip has no room give way: the list of traces has the values at A and B too.
void PlotCursors::drawBox(QCPPainter &painter, std::size_t strip)
{
    const Theme &theme = m_theme.theme();
    const QFont caption = theme.font(TextRole::Caption, parentPlot()->font());
    QFont strong = caption;
    strong.setBold(true);
    const QFontMetrics metrics(caption);
    const double line = metrics.height() + 1;
    const double around = theme.u(4);
    std::vector<const Row *> rows;
    for (const Row &row : m_rows) {
        const double height = line * static_cast<double>(rows.size() + 1) + 2 * around;
        if (row.strip == static_cast<int>(strip) && (rows.empty() || height < m_rects[strip]->height() - theme.u(4)))
            rows.push_back(&row);
    }
    if (rows.empty())
        return;
    const auto nameOf = [](const Row &row) { return row.brief.isEmpty() ? row.name : row.brief; };
    int names = 0;
    int values = 0;
    for (const Row *row : rows) {
        names = std::max(names, metrics.horizontalAdvance(nameOf(*row)));
        values = std::max(values, QFontMetrics(strong).horizontalAdvance(row->value));
    }
    const QSizeF size(names + values + theme.u(28), line * static_cast<double>(rows.size()) + 2 * around);
    const QRectF box = boxFor(size, strip);
    m_boxes.push_back(box);
    painter.setAntialiasing(true);
    painter.setPen(QPen(theme.outline, 1));
    painter.setBrush(theme.panel);
    painter.drawRoundedRect(box, theme.u(4), theme.u(4));
    QRectF row(box.left() + theme.u(8), box.top() + around, box.width() - theme.u(16), line);
    for (const Row *entry : rows) {
        painter.setFont(caption);
        painter.setPen(theme.dim);
        painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter, nameOf(*entry));
        painter.setFont(entry->strong ? strong : caption);
        painter.setPen(theme.text);
        painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter, entry->value);
        row.translate(0, line);
    }
}

} // namespace mb
