// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/holdgesture.h"

#include <QAbstractButton>
#include <QMouseEvent>

#include <algorithm>
#include <utility>

namespace mb {

HoldGesture::HoldGesture(QAbstractButton &button, std::function<void()> press)
    : m_button(button)
    , m_press(std::move(press))
{
    button.installEventFilter(this);
    // who begins with the pointer does not click: its button is up again before that
    connect(&button, &QAbstractButton::clicked, this, [this] { isUnderWay() ? end() : m_press(); });
}

void HoldGesture::begin()
{
    if (isUnderWay())
        return;
    m_sum = 0;
    m_sinceTick.start();
    m_ticks.start(std::clamp(m_whole / 10, 1, 16), Qt::PreciseTimer, this);
    m_button.update();
    Q_EMIT holdingChanged(true);
}

void HoldGesture::end()
{
    if (!isUnderWay())
        return;
    m_ticks.stop();
    m_button.setDown(false);
    m_button.update();
    Q_EMIT holdingChanged(false);
}

double HoldGesture::progress() const
{
    return isUnderWay() ? std::min(1.0, static_cast<double>(m_sum) / std::max(m_whole, 1)) : 0.0;
}

bool HoldGesture::eventFilter(QObject *, QEvent *event)
{
    const QEvent::Type type = event->type();
    const bool press = type == QEvent::MouseButtonPress || type == QEvent::MouseButtonDblClick;
    if (press || type == QEvent::MouseButtonRelease) {
        if (static_cast<const QMouseEvent *>(event)->button() != Qt::LeftButton)
            return false;
        if (!press)
            end();
        else if (m_button.isEnabled() && !isUnderWay())
            m_press();
    }
    // A release goes to whatever window has the focus by then.
    if ((type == QEvent::MouseMove && !m_button.rect().contains(static_cast<const QMouseEvent *>(event)->pos()))
        || (type == QEvent::EnabledChange && !m_button.isEnabled())
        || (type == QEvent::ActivationChange && !m_button.isActiveWindow()) || type == QEvent::WindowDeactivate
        || type == QEvent::FocusOut || type == QEvent::Hide)
        end();
    return false;
}

void HoldGesture::timerEvent(QTimerEvent *)
{
    m_sum += std::min(m_sinceTick.restart(), mostOfATick);
    m_button.update();
    if (progress() < 1.0)
        return;
    end();
    Q_EMIT completed();
}

} // namespace mb
