// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/holdbutton.h"

#include <QMouseEvent>
#include <QPainter>
#include <QTimerEvent>

#include <algorithm>

namespace mb {

HoldButton::HoldButton(const ThemeSource &theme, Symbol symbol, const QString &text, QWidget *parent)
    : CommandButton(theme, symbol, text, parent)
    , m_theme(theme)
{
    connect(this, &QAbstractButton::clicked, this, [this] {
        if (!m_needed)
            Q_EMIT activated();
    });
}

void HoldButton::setHoldNeeded(bool needed)
{
    if (needed == m_needed)
        return;
    m_needed = needed;
    endHold();
}

void HoldButton::endHold()
{
    m_tick.stop();
    setDown(false);
    update();
}

void HoldButton::giveUp()
{
    if (m_needed)
        endHold();
}

void HoldButton::mousePressEvent(QMouseEvent *event)
{
    CommandButton::mousePressEvent(event);
    if (!m_needed || event->button() != Qt::LeftButton)
        return;
    m_held.start();
    m_tick.start(16, this);
}

void HoldButton::mouseReleaseEvent(QMouseEvent *event)
{
    if (m_needed)
        endHold();
    CommandButton::mouseReleaseEvent(event);
}

void HoldButton::mouseMoveEvent(QMouseEvent *event)
{
    CommandButton::mouseMoveEvent(event);
    if (m_tick.isActive() && !rect().contains(event->pos()))
        endHold();
}

void HoldButton::timerEvent(QTimerEvent *event)
{
    if (event->timerId() != m_tick.timerId())
        return CommandButton::timerEvent(event);
    update();
    if (m_held.elapsed() < m_hold)
        return;
    endHold();
    Q_EMIT activated();
}

void HoldButton::hideEvent(QHideEvent *event)
{
    endHold();
    CommandButton::hideEvent(event);
}

void HoldButton::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::EnabledChange && !isEnabled())
        endHold();
    CommandButton::changeEvent(event);
}

/// The release goes to whatever window has the focus by then.
bool HoldButton::event(QEvent *event)
{
    if (event->type() == QEvent::WindowDeactivate || event->type() == QEvent::ActivationChange)
        giveUp();
    return CommandButton::event(event);
}

void HoldButton::paintEvent(QPaintEvent *event)
{
    CommandButton::paintEvent(event);
    if (!m_tick.isActive())
        return;
    QPainter painter(this);
    QColor fill = m_theme.theme().armed;
    fill.setAlphaF(0.45);
    const double part = std::min(1.0, static_cast<double>(m_held.elapsed()) / std::max(m_hold, 1));
    painter.fillRect(QRectF(1, 1, (width() - 2) * part, height() - 2), fill);
}

} // namespace mb
