// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/logslider.h"

#include <QKeyEvent>
#include <QPainter>

#include <cmath>

namespace mb {
namespace {

constexpr int steps = 2000; ///< a decade
constexpr double usualStep = 1.02;
constexpr double fineStep = 1.002;
constexpr double coarseStep = 1.2;

} // namespace

LogSlider::LogSlider(const ThemeSource &theme, QWidget *parent)
    : QSlider(Qt::Horizontal, parent)
    , m_theme(theme)
{
    setRange(-steps, steps);
    setFocusPolicy(Qt::StrongFocus);
    setEnabled(false);
    connect(&theme, &ThemeSource::changed, this, [this] { update(); });
}

void LogSlider::setCentre(double centre)
{
    m_centre = std::isfinite(centre) ? centre : 0.0;
    setEnabled(m_centre != 0.0);
    update();
}

void LogSlider::showNumber(double number)
{
    const double ratio = m_centre != 0.0 ? number / m_centre : 0.0;
    const QSignalBlocker quiet(this);
    setValue(ratio > 0.0 ? static_cast<int>(std::lround(std::log10(ratio) * steps)) : 0);
    update();
}

double LogSlider::number() const
{
    return m_centre * std::pow(10.0, static_cast<double>(value()) / steps);
}

QSize LogSlider::sizeHint() const
{
    return {m_theme.theme().u(120), m_theme.theme().u(32)};
}

double LogSlider::xOf(int position) const
{
    return margin() + (width() - 2.0 * margin()) * (position + steps) / (2.0 * steps);
}

void LogSlider::paintEvent(QPaintEvent *)
{
    const Theme &theme = m_theme.theme();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double middle = height() / 2.0;
    const double thick = theme.u(3);
    painter.setPen(Qt::NoPen);
    painter.setBrush(isEnabled() ? theme.outline : theme.line);
    painter.drawRoundedRect(
        QRectF(xOf(-steps), middle - thick / 2, xOf(steps) - xOf(-steps), thick), thick / 2, thick / 2);
    for (int i = -4; i <= 4; ++i) { // quarters of a decade; the centre and the ends are taller
        const double tall = theme.u(i == 0 ? 14 : i % 4 == 0 ? 10 : 7);
        painter.fillRect(
            QRectF(std::round(xOf(i * steps / 4)), middle - tall / 2, 1, tall), isEnabled() ? theme.dim : theme.line);
    }
    const QPointF at(isEnabled() ? xOf(value()) : xOf(-steps), middle);
    const double radius = theme.u(6);
    painter.setPen(hasFocus() ? QPen(theme.text, 2) : isEnabled() ? QPen(theme.window, 1) : QPen(theme.outline, 1.4));
    painter.setBrush(isEnabled() ? theme.accent : theme.window);
    painter.drawEllipse(at, radius, radius);
}

void LogSlider::moveTo(double x)
{
    const double part = (x - margin()) / std::max(width() - 2.0 * margin(), 1.0);
    setValue(static_cast<int>(std::lround((2.0 * part - 1.0) * steps)));
    update();
    Q_EMIT numberChosen(number());
}

void LogSlider::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton)
        return;
    setSliderDown(true);
    moveTo(event->localPos().x());
}

void LogSlider::mouseMoveEvent(QMouseEvent *event)
{
    if (isSliderDown())
        moveTo(event->localPos().x());
}

void LogSlider::mouseReleaseEvent(QMouseEvent *event)
{
    if (!isSliderDown() || event->button() != Qt::LeftButton)
        return;
    setSliderDown(false);
    Q_EMIT choiceEnded();
}

void LogSlider::multiply(double factor)
{
    if (!isEnabled())
        return;
    const double chosen = number() * factor;
    showNumber(chosen);
    Q_EMIT numberChosen(chosen);
    Q_EMIT choiceEnded();
}

void LogSlider::keyPressEvent(QKeyEvent *event)
{
    const bool up = event->key() == Qt::Key_Right || event->key() == Qt::Key_Plus;
    const bool down = event->key() == Qt::Key_Left || event->key() == Qt::Key_Minus;
    if (!up && !down) {
        event->ignore(); // up and down belong to the rows
        return;
    }
    const double step = event->modifiers() & Qt::ShiftModifier ? fineStep
        : event->modifiers() & Qt::ControlModifier             ? coarseStep
                                                               : usualStep;
    multiply(up ? step : 1.0 / step);
}

void LogSlider::wheelEvent(QWheelEvent *event)
{
    if (!hasFocus()) { // scrolling the panel must not change gains
        event->ignore();
        return;
    }
    multiply(event->angleDelta().y() > 0 ? usualStep : 1.0 / usualStep);
    event->accept();
}

} // namespace mb
