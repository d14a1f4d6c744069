// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/start/storydrawing.h"

#include <QPainter>
#include <QPainterPath>

#include <cmath>
#include <numbers>

namespace mb {
namespace {

constexpr int points = 160;
constexpr double edge = 0.08;     ///< of the width, where the step is
constexpr double wished = 0.62;   ///< of the height
constexpr double damping = 0.456; ///< overshoots by 20 %
constexpr double turns = 3.2;     ///< of the ringing, in the width
constexpr double limitEnd = 0.52;
constexpr double shortEnd = 0.86; ///< of the step, where friction holds it

/// Of a second-order loop, t in its own periods.
double rung(double t)
{
    const double root = std::sqrt(1.0 - damping * damping);
    const double phase = 2.0 * std::numbers::pi * t;
    return 1.0 - std::exp(-damping * phase / root) * (std::cos(phase) + damping / root * std::sin(phase));
}

/// Current that is held at a limit, and falls once the load is free.
double limited(double x)
{
    if (x < limitEnd)
        return 1.0 - std::exp(-(x - edge) * 18.0);
    return std::exp(-(x - limitEnd) * 22.0);
}

/// A place that is approached and not reached.
double held(double x)
{
    return shortEnd * (1.0 - std::exp(-(x - edge) * 7.0));
}

} // namespace

StoryDrawing::StoryDrawing(StoryPicture picture, const QString &caption, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_picture(picture)
    , m_caption(caption)
    , m_theme(theme)
{
    setAccessibleName(caption);
    connect(&theme, &ThemeSource::changed, this, QOverload<>::of(&QWidget::update));
}

QSize StoryDrawing::sizeHint() const
{
    return {m_theme.theme().u(240), m_theme.theme().u(136)};
}

QSize StoryDrawing::minimumSizeHint() const
{
    return {m_theme.theme().u(160), m_theme.theme().u(112)};
}

void StoryDrawing::paintEvent(QPaintEvent *)
{
    const Theme &theme = m_theme.theme();
    QPainter painter(this);
    painter.fillRect(rect(), theme.canvas);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF box = QRectF(rect()).adjusted(0, theme.u(28), 0, -theme.u(12));
    paintCurve(painter, box);
    painter.setPen(theme.dim);
    painter.setFont(theme.font(TextRole::Caption, font()));
    painter.drawText(rect().adjusted(theme.u(12), theme.u(8), -theme.u(12), 0), Qt::AlignLeft | Qt::AlignTop,
        painter.fontMetrics().elidedText(m_caption, Qt::ElideRight, width() - 2 * theme.u(12)));
}

void StoryDrawing::paintCurve(QPainter &painter, const QRectF &box) const
{
    const Theme &theme = m_theme.theme();
    const bool current = m_picture == StoryPicture::Limit;
    const bool position = m_picture == StoryPicture::Short;
    const double level = current ? 1.0 : wished;
    const auto at = [&box, level](double x, double y) {
        return QPointF(box.left() + x * box.width(), box.bottom() - y * level * box.height());
    };
    QPen dashed(theme.trace(TraceRole::Setpoint), 1.0, Qt::DashLine);
    painter.setPen(dashed);
    painter.drawLine(at(0.0, 1.0), at(1.0, 1.0));
    QPainterPath path(at(0.0, 0.0));
    path.lineTo(at(edge, 0.0));
    for (int i = 1; i <= points; ++i) {
        const double x = edge + (1.0 - edge) * i / points;
        const double y = current ? limited(x) : position ? held(x) : rung((x - edge) / (1.0 - edge) * turns);
        path.lineTo(at(x, y));
    }
    const TraceRole role = current ? TraceRole::Current : position ? TraceRole::Position : TraceRole::Velocity;
    painter.setPen(QPen(theme.trace(role), theme.u(2)));
    painter.drawPath(path);
}

} // namespace mb
