// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/sparkline.h"

#include <QPainter>
#include <QPainterPath>
#include <QTimerEvent>
#include <cmath>
#include <utility>

namespace mb {
namespace {

constexpr std::size_t MostPoints = 240;
constexpr int RepaintInterval = 100;

} // namespace

Sparkline::Sparkline(const ThemeSource &theme, TraceRole role, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
    , m_role(role)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    followTheme(theme, *this);
}

void Sparkline::setCapacity(int points)
{
    m_capacity = std::clamp<std::size_t>(static_cast<std::size_t>(std::max(points, 2)), 2, MostPoints);
    while (m_values.size() > m_capacity)
        m_values.pop_front();
    touched();
}

void Sparkline::setValues(std::deque<double> values)
{
    while (values.size() > m_capacity)
        values.pop_front();
    if (std::exchange(m_values, values) != values)
        touched();
}

void Sparkline::setRole(TraceRole role)
{
    if (std::exchange(m_role, role) != role)
        touched();
}

void Sparkline::touched()
{
    if (m_tick.isActive()) {
        m_dirty = true;
        return;
    }
    update();
    m_tick.start(RepaintInterval, this);
}

void Sparkline::timerEvent(QTimerEvent *event)
{
    if (event->timerId() != m_tick.timerId())
        return QWidget::timerEvent(event);
    if (m_dirty)
        update();
    else
        m_tick.stop();
    m_dirty = false;
}

std::optional<std::pair<double, double>> Sparkline::range() const
{
    std::optional<std::pair<double, double>> found;
    for (const double value : m_values) {
        if (!std::isfinite(value))
            continue;
        if (!found)
            found = {value, value};
        found->first = std::min(found->first, value);
        found->second = std::max(found->second, value);
    }
    return found;
}

QSize Sparkline::sizeHint() const
{
    return {m_theme.theme().u(120), m_theme.theme().u(40)};
}

/// What is constant has no area: it would look like half of something.
void Sparkline::paintRun(QPainter &painter, const QPolygonF &run, bool filled) const
{
    const QColor line = m_theme.theme().trace(m_role);
    if (filled && run.size() > 1) {
        QColor fill = line;
        fill.setAlphaF(0.16);
        QPolygonF area = run;
        area << QPointF(run.last().x(), height()) << QPointF(run.first().x(), height());
        painter.setPen(Qt::NoPen);
        painter.setBrush(fill);
        painter.drawPolygon(area);
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(line, 1.3));
    run.size() > 1 ? painter.drawPolyline(run) : painter.drawPoint(run.first());
}

void Sparkline::paintEvent(QPaintEvent *)
{
    const auto bounds = range();
    if (!bounds)
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double span = bounds->second - bounds->first;
    const double pad = 2.0;
    const double step = static_cast<double>(width()) / static_cast<double>(m_capacity - 1);
    const auto y = [&](double value) {
        return span > 0 ? height() - pad - (value - bounds->first) / span * (height() - 2 * pad) : height() / 2.0;
    };
    QPolygonF run;
    const auto flush = [&] {
        if (!run.isEmpty())
            paintRun(painter, run, span > 0);
        run.clear();
    };
    double x = width() - step * static_cast<double>(m_values.size() - 1);
    for (const double value : m_values) {
        if (std::isfinite(value))
            run << QPointF(x, y(value));
        else
            flush();
        x += step;
    }
    flush();
}

} // namespace mb
