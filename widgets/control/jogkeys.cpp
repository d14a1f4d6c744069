// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/jogkeys.h"

#include "widgets/control/arming.h"

#include <QApplication>
#include <QKeyEvent>

namespace mb {
namespace {

constexpr std::chrono::milliseconds nudgeTime{100};

} // namespace

JogKeys::JogKeys(Arming &arming, QWidget &page, SetPointOf setPointOf)
    : QObject(&page)
    , m_arming(arming)
    , m_page(page)
    , m_setPointOf(std::move(setPointOf))
{
    page.installEventFilter(this);
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget *, QWidget *now) { followFocus(now); });
    m_nudge.setSingleShot(true);
    m_nudge.setTimerType(Qt::PreciseTimer);
    connect(&m_nudge, &QTimer::timeout, this, &JogKeys::release);
}

bool JogKeys::press(int key)
{
    if (m_held != 0 || m_arming.state() != LampState::Armed)
        return false;
    const auto setPoint = m_setPointOf(key == Qt::Key_J);
    if (!setPoint)
        return false;
    m_held = key;
    m_since.start();
    qApp->installEventFilter(this); // a menu that opens meanwhile gets the release, not the page
    m_arming.run(*setPoint);
    return true;
}

void JogKeys::release()
{
    if (std::exchange(m_held, 0) == 0)
        return;
    qApp->removeEventFilter(this);
    m_nudge.stop();
    m_arming.halt();
}

void JogKeys::hold(bool forwards)
{
    press(forwards ? Qt::Key_J : Qt::Key_K);
}

void JogKeys::letGo()
{
    const std::chrono::milliseconds held(m_since.isValid() ? m_since.elapsed() : 0);
    if (m_held != 0 && held < nudgeTime)
        m_nudge.start(nudgeTime - held);
    else
        release();
}

void JogKeys::followFocus(const QWidget *now)
{
    if (now && now != &m_page && !m_page.isAncestorOf(now))
        release();
}

bool JogKeys::pageKey(const QKeyEvent &key)
{
    const bool ours = (key.key() == Qt::Key_J || key.key() == Qt::Key_K) && key.modifiers() == Qt::NoModifier;
    if (!ours || key.isAutoRepeat())
        return ours && m_held != 0;
    return key.type() == QEvent::KeyRelease || press(key.key());
}

bool JogKeys::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::KeyRelease) {
        const auto &key = static_cast<const QKeyEvent &>(*event);
        if (key.key() == m_held && !key.isAutoRepeat())
            release();
    }
    if (watched != &m_page)
        return QObject::eventFilter(watched, event);
    switch (event->type()) {
    case QEvent::KeyPress:
    case QEvent::KeyRelease: return pageKey(static_cast<const QKeyEvent &>(*event));
    case QEvent::Hide:
    case QEvent::WindowDeactivate:
    case QEvent::FocusOut: release(); break;
    default: break;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace mb
