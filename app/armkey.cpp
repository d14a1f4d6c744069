// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/armkey.h"

#include "widgets/common/lamp.h"

#include <QApplication>
#include <QKeyEvent>

namespace mb {
namespace {

constexpr Qt::KeyboardModifiers both = Qt::ControlModifier | Qt::ShiftModifier;

bool isOfIt(int key)
{
    return key == Qt::Key_F12 || key == Qt::Key_Control || key == Qt::Key_Shift;
}

} // namespace

ArmKey::ArmKey(Lamp &lamp, QWidget &window)
    : QObject(&window)
    , m_lamp(lamp)
    , m_window(window)
{
}

bool ArmKey::eventFilter(QObject *, QEvent *event)
{
    if (event->type() == QEvent::KeyPress)
        return press(static_cast<const QKeyEvent &>(*event));
    if (event->type() == QEvent::KeyRelease)
        release(static_cast<const QKeyEvent &>(*event));
    return false;
}

/// Keys that are held repeat; only the first of them begins.
bool ArmKey::press(const QKeyEvent &key)
{
    if (key.key() != Qt::Key_F12 || (key.modifiers() & ~Qt::KeypadModifier) != both)
        return false;
    const bool ours = QApplication::activeWindow() == &m_window && !QApplication::activeModalWidget();
    if (ours && !key.isAutoRepeat())
        m_lamp.hold();
    return ours;
}

void ArmKey::release(const QKeyEvent &key)
{
    if (isOfIt(key.key()) && !key.isAutoRepeat())
        m_lamp.giveUp();
}

} // namespace mb
