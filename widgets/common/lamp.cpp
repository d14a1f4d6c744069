// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/lamp.h"

#include "widgets/common/spoken.h"

#include <QAccessible>
#include <QPainter>

namespace mb {

Lamp::Lamp(const ThemeSource &theme, QWidget *parent)
    : QAbstractButton(parent)
    , m_theme(theme)
    , m_hold(*this, [this] { press(); })
{
    setFocusPolicy(Qt::NoFocus);
    setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
    updateAccessibleText(LampState::Safe);
    followTheme(theme, *this);
    connect(&m_hold, &HoldGesture::holdingChanged, this, [this](bool holding) {
        updateGeometry();
        Q_EMIT holdingChanged(holding);
    });
    connect(&m_hold, &HoldGesture::completed, this, &Lamp::armRequested);
}

void Lamp::setStatus(const LampStatus &status)
{
    const LampState before = m_status.state;
    const bool isOther = status.candidate != m_status.candidate;
    m_status = status;
    if (m_hold.isUnderWay() && (isLive(m_status) || !status.armable || isOther))
        giveUp();
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
    else
        hold();
}

void Lamp::hold()
{
    if (!isLive(m_status) && m_status.state != LampState::MayTurn && m_status.armable)
        m_hold.begin();
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
