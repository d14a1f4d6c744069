// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/holdbutton.h"

#include <QMouseEvent>
#include <QPainter>
#include <QTimerEvent>

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
    m_hold.end();
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
    m_hold.begin(this);
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
    if (m_hold.isUnderWay() && !rect().contains(event->pos()))
        endHold();
}

void HoldButton::timerEvent(QTimerEvent *event)
{
    if (!m_hold.tick(*event))
        return CommandButton::timerEvent(event);
    update();
    if (m_hold.progress() < 1.0)
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
    if (!m_hold.isUnderWay())
        return;
    QPainter painter(this);
    QColor fill = m_theme.theme().armed;
    fill.setAlphaF(0.45);
    painter.fillRect(QRectF(1, 1, (width() - 2) * m_hold.progress(), height() - 2), fill);
}

} // namespace mb
