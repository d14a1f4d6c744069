// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/stopkeys.h"

#include "widgets/common/numberfield.h"
#include "widgets/common/scanfield.h"

#include <QApplication>
#include <QKeyEvent>

namespace mb {
namespace {

constexpr unsigned long scanTime = 50; ///< ms between two keys of a scanner are fewer

bool isTyped(const QKeyEvent &key)
{
    return !key.isAutoRepeat() && !key.text().isEmpty() && key.text().front().isPrint();
}

} // namespace

bool StopKeys::eventFilter(QObject *, QEvent *event)
{
    // What is dragged takes every key, by a filter of its own that begins after this.
    if (event->type() == QEvent::ChildAdded && !m_queued)
        m_queued = QMetaObject::invokeMethod(this, &StopKeys::comeFirst, Qt::QueuedConnection);
    // A key that a shortcut or an editor would take is announced as ShortcutOverride first.
    if (event->type() != QEvent::KeyPress && event->type() != QEvent::ShortcutOverride)
        return false;
    const auto &key = static_cast<const QKeyEvent &>(*event);
    if (key.key() == Qt::Key_Escape || key.key() == Qt::Key_Pause) {
        announce(key, key.key() == Qt::Key_Pause ? QStringLiteral("Pause") : QStringLiteral("Esc"));
        return false; // it still closes dialogs and clears fields
    }
    if (key.key() != Qt::Key_Space || isText(key)) {
        m_typed = isTyped(key) ? key.timestamp() : m_typed;
        return false;
    }
    announce(key, QStringLiteral("Space"));
    return event->type()
        == QEvent::KeyPress; // Space never activates a button, ticks a box or opens a list, however long it is held
}

/// Of Space.
bool StopKeys::isText(const QKeyEvent &key) const
{
    const QWidget *const focus = QApplication::focusWidget();
    if (qobject_cast<const ScanField *>(focus))
        return m_typed && key.timestamp() - *m_typed < scanTime;
    return acceptsLetters(focus);
}

void StopKeys::comeFirst()
{
    m_queued = false;
    qApp->installEventFilter(this);
}

void StopKeys::announce(const QKeyEvent &key, const QString &name)
{
    // One press passes here several times: as override, for the window, for the widget, and as long as it is held.
    if (key.isAutoRepeat() || (key.timestamp() != 0 && key.timestamp() == m_announced))
        return;
    m_announced = key.timestamp();
    Q_EMIT stopPressed(name);
}

} // namespace mb
