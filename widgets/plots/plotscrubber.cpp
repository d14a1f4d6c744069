// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotscrubber.h"

#include "widgets/common/clamped.h"
#include "widgets/plots/columnpath.h"
#include "widgets/plots/plottickers.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <cmath>

namespace mb {
namespace {

constexpr double fetchEvery = 1.0;    ///< seconds
constexpr double shortestSpan = 60.0; ///< a session is drawn at least as long as this

} // namespace

PlotScrubber::PlotScrubber(const ThemeSource &theme, PlotStack &stack, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
    , m_stack(stack)
{
    setFocusPolicy(Qt::TabFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(tr("Whole session"));
    setToolTip(tr("The whole session: drag the box or click to scroll back, End returns to the present.\n"
                  "The recording goes on meanwhile."));
    connect(&theme, &ThemeSource::changed, this, [this] { updateGeometry(); });
}

QSize PlotScrubber::sizeHint() const
{
    return {m_theme.theme().u(400), m_theme.theme().u(56)};
}

void PlotScrubber::setSource(std::shared_ptr<const TraceSource> source, const TraceLook &look)
{
    m_source = std::move(source);
    m_look = look;
    m_fetchedAt = -1e9;
    update();
}

void PlotScrubber::setSession(double first, double now)
{
    m_first = std::min(first, now - shortestSpan);
    m_now = now;
}

QRectF PlotScrubber::band() const
{
    const Theme &theme = m_theme.theme();
    return QRectF(rect()).adjusted(theme.u(56), theme.u(6), -theme.u(16), -theme.u(20));
}

double PlotScrubber::x(double key) const
{
    const QRectF area = band();
    return area.left() + (key - m_first) / std::max(m_now - m_first, 1e-9) * area.width();
}

double PlotScrubber::keyOf(double at) const
{
    const QRectF area = band();
    return m_first + (at - area.left()) / std::max(area.width(), 1.0) * (m_now - m_first);
}

QRectF PlotScrubber::box() const
{
    const auto [from, to] = m_stack.view().range();
    const QRectF area = band();
    const double left = clamped(x(from), area.left(), area.right() - 6);
    const double right = clamped(x(to), left + 6, area.right());
    return {left, area.top() - 2, right - left, area.height() + 4};
}

void PlotScrubber::follow()
{
    if (!isVisible())
        return;
    const bool stale = m_now - m_fetchedAt >= fetchEvery || m_now < m_fetchedAt;
    if (stale && m_source) {
        m_fetchedAt = m_now;
        m_source->columns(m_first, m_now, static_cast<int>(band().width()), m_points);
    }
    const QRectF now = box();
    if (stale || std::abs(now.left() - m_drawnBox.left()) >= 1 || std::abs(now.width() - m_drawnBox.width()) >= 1)
        update();
}

void PlotScrubber::drawEnvelope(QPainter &painter) const
{
    const auto values = valueRange(m_points, m_first, m_now);
    if (!values)
        return;
    const QRectF area = band();
    const double span = std::max(values->second - values->first, 1e-12);
    QColor color = m_theme.theme().trace(m_look.colourRole());
    color.setAlphaF(0.55);
    painter.setPen(color);
    painter.setRenderHint(QPainter::Antialiasing, false);
    const auto y = [&](double value) { return area.bottom() - (value - values->first) / span * area.height(); };
    PixelMap map;
    map.keyScale = area.width() / (m_now - m_first);
    map.keyOffset = area.left() - m_first * map.keyScale;
    map.valueScale = -area.height() / span;
    map.valueOffset = y(0.0);
    const ColumnPath path = columnPath(m_points, map);
    painter.drawLines(path.spans);
    for (const QPolygonF &line : path.lines)
        painter.drawPolyline(line);
}

void PlotScrubber::drawTimes(QPainter &painter) const
{
    const Theme &theme = m_theme.theme();
    const QFont font = theme.font(TextRole::Caption, this->font());
    const QFontMetrics metrics(font);
    TimeTicker ticker;
    ticker.setClock(m_stack.strips().clock());
    const QRectF area = band();
    const int places = std::clamp(static_cast<int>(area.width()) / theme.u(110), 2, 8);
    painter.setFont(font);
    painter.setPen(theme.dim);
    for (int i = 0; i <= places; ++i) {
        const double key = m_first + (m_now - m_first) * i / places;
        const QString text = ticker.text(ticker.clock() ? key : key - m_now, 1.0);
        const double wide = metrics.horizontalAdvance(text);
        const double left = clamped(x(key) - wide / 2, 1.0 * theme.u(8), width() - wide - theme.u(8));
        painter.drawText(QPointF(left, height() - theme.u(5)), text);
    }
}

void PlotScrubber::paintEvent(QPaintEvent *)
{
    const Theme &theme = m_theme.theme();
    QPainter painter(this);
    painter.fillRect(rect(), theme.canvas);
    painter.fillRect(QRect(0, 0, width(), 1), theme.line);
    drawEnvelope(painter);
    drawTimes(painter);
    m_drawnBox = box();
    QColor inside = theme.accent;
    inside.setAlphaF(0.18);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(theme.accent, hasFocus() ? 2 : 1));
    painter.setBrush(inside);
    painter.drawRoundedRect(m_drawnBox.adjusted(0.5, 0.5, -0.5, -0.5), 2, 2);
}

void PlotScrubber::showAround(double key)
{
    const double half = m_stack.view().window() / 2;
    if (key + half >= m_now)
        m_stack.view().setLive(true);
    else
        m_stack.view().setRange(key - half, key + half);
    update();
}

void PlotScrubber::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton)
        return QWidget::mousePressEvent(event);
    const auto [from, to] = m_stack.view().range();
    const double middle = (from + to) / 2;
    const double key = keyOf(event->pos().x());
    m_grip = box().contains(event->pos()) ? key - middle : 0.0;
    if (m_grip == 0.0)
        showAround(key);
}

void PlotScrubber::mouseMoveEvent(QMouseEvent *event)
{
    if (event->buttons().testFlag(Qt::LeftButton))
        showAround(keyOf(event->pos().x()) - m_grip);
}

void PlotScrubber::keyPressEvent(QKeyEvent *event)
{
    const auto [from, to] = m_stack.view().range();
    switch (event->key()) {
    case Qt::Key_Left: return showAround((from + to) / 2 - m_stack.view().window() / 2);
    case Qt::Key_Right: return showAround((from + to) / 2 + m_stack.view().window() / 2);
    case Qt::Key_Home: return showAround(m_first + m_stack.view().window() / 2);
    case Qt::Key_End: return m_stack.view().setLive(true);
    default: QWidget::keyPressEvent(event);
    }
}

} // namespace mb
