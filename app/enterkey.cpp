// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/enterkey.h"

#include "widgets/common/holdbutton.h"
#include "widgets/common/iconbutton.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QKeyEvent>
#include <QMenu>
#include <QPointer>
#include <QTimer>
#include <QToolButton>

namespace mb {
namespace {

/// Whether the current row has a box that can be ticked.
bool tick(QAbstractItemView &view)
{
    const QModelIndex index = view.currentIndex();
    constexpr Qt::ItemFlags tickable = Qt::ItemIsUserCheckable | Qt::ItemIsEnabled;
    if (!index.isValid() || (index.flags() & tickable) != tickable || !index.data(Qt::CheckStateRole).isValid())
        return false;
    const bool ticked = index.data(Qt::CheckStateRole).toInt() == Qt::Checked;
    return view.model()->setData(index, ticked ? Qt::Unchecked : Qt::Checked, Qt::CheckStateRole);
}

} // namespace

bool EnterKey::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::KeyPress || watched != QApplication::focusWidget())
        return false;
    const auto &key = static_cast<const QKeyEvent &>(*event);
    const bool enter = key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter;
    if (!enter || key.isAutoRepeat() || (key.modifiers() & ~Qt::KeypadModifier) != 0)
        return false;
    if (auto *view = qobject_cast<QAbstractItemView *>(watched))
        return tick(*view);
    auto *button = qobject_cast<QAbstractButton *>(watched);
    const auto *held = qobject_cast<HoldButton *>(watched); // as long as the key
    if (!button || !button->isEnabled() || (held && held->isHoldNeeded()))
        return false;
    press(*button);
    return true;
}

/// With the next turn of the event loop: what it opens may have a loop of its own.
void EnterKey::press(QAbstractButton &button)
{
    QTimer::singleShot(0, &button, [pointed = QPointer<QAbstractButton>(&button)] {
        const auto *command = qobject_cast<CommandButton *>(pointed.data());
        if (!pointed || !pointed->isEnabled() || (command && command->isFresh())) // nobody has read what it does
            return;
        auto *tool = qobject_cast<QToolButton *>(pointed.data());
        if (tool && tool->menu() && tool->popupMode() == QToolButton::InstantPopup)
            tool->menu()->popup(tool->mapToGlobal({0, tool->height()}));
        else
            pointed->click();
    });
}

} // namespace mb
