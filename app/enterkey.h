// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QAbstractButton;

namespace mb {

/// Space stops, so Enter presses the button, ticks the box or opens the menu that has the focus, in the window and in dialogs; a button that
/// has to be held is left to itself, and one that did something else a moment ago is not pressed.
/// Install on the application. GUI thread.
class EnterKey : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    static void press(QAbstractButton &button);
};

} // namespace mb
