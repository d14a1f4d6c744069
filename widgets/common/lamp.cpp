// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/lamp.h"

#include "widgets/common/spoken.h"

#include <QAccessible>
#include <QMouseEvent>
#include <QPainter>

namespace mb {

Lamp::Lamp(const ThemeSource &theme, QWidget *parent)
    : QAbstractButton(parent)
    , m_theme(theme)
{
    setFocusPolicy(Qt::NoFocus);
    setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
    updateAccessibleText(LampState::Safe);
    followTheme(theme, *this);
    connect(this, &QAbstractButton::clicked, this, [this] { m_hold.isUnderWay() ? endHold(false) : press(); });
}

void Lamp::setStatus(const LampStatus &status)
{
    const LampState before = m_status.state;
    const bool isOther = status.candidate != m_status.candidate;
    m_status = status;
    if (m_hold.isUnderWay() && (isLive(m_status) || !status.armable || isOther))
        endHold(false);
    updateAccessibleText(before);
    updateGeometry();
    update();
}

void Lamp::updateAccessibleText(LampState before)
{
    const LampFace face = this->face();
    const QString detail = face.detail();
    const QString clock = face.clock();
    setSpoken(
        *this, tr("Arm button: %1").arg(face.word()), clock.isEmpty() ? detail : clock + QLatin1Char(' ') + detail);
    setToolTip(m_status.state == LampState::MayTurn ? detail + QLatin1Char('\n')
                + tr("A motor was told to stop and was not seen to. Cut its power, or look at it.")
            : isLive(m_status) ? tr("Press to make it safe again")
                               : tr("Hold for one second to arm"));
    if (before != m_status.state) {
        QAccessibleEvent event(this, QAccessible::Alert);
        QAccessible::updateAccessibility(&event);
    }
}

void Lamp::press()
{
    if (isLive(m_status) || m_status.state == LampState::MayTurn)
        Q_EMIT disarmRequested();
    else if (m_status.armable)
        beginHold();
}

void Lamp::hold()
{
    if (!m_hold.isUnderWay() && !isLive(m_status) && m_status.state != LampState::MayTurn && m_status.armable)
        beginHold();
}

void Lamp::beginHold()
{
    m_hold.begin(this);
    Q_EMIT holdingChanged(true);
    updateGeometry();
    update();
}

void Lamp::endHold(bool complete)
{
    if (!m_hold.isUnderWay())
        return;
    m_hold.end();
    update();
    Q_EMIT holdingChanged(false);
    if (complete)
        Q_EMIT armRequested();
}

void Lamp::mousePressEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton && !m_hold.isUnderWay())
        press();
}

void Lamp::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton)
        giveUp();
}

void Lamp::mouseMoveEvent(QMouseEvent *event)
{
    if (!rect().contains(event->pos()))
        endHold(false);
}

void Lamp::timerEvent(QTimerEvent *event)
{
    if (!m_hold.tick(*event))
        return QAbstractButton::timerEvent(event);
    if (holdProgress() >= 1.0)
        endHold(true);
    else
        update();
}

void Lamp::hideEvent(QHideEvent *event)
{
    endHold(false);
    QAbstractButton::hideEvent(event);
}

void Lamp::changeEvent(QEvent *event)
{
    const bool lost = event->type() == QEvent::ActivationChange && !isActiveWindow();
    if (lost || (event->type() == QEvent::EnabledChange && !isEnabled()))
        endHold(false);
    QAbstractButton::changeEvent(event);
}

LampFace Lamp::face() const
{
    return {m_theme.theme(), font(), m_status, m_hold.isUnderWay()};
}

void Lamp::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    face().paint(painter, size(), holdProgress());
}

} // namespace mb
