// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QKeyEvent;
class QWidget;

namespace mb {

class Lamp;

/// Arming without a mouse: Ctrl+Shift+F12 held for as long as the Arm button has to be held. Any of the three let go, another window, or
/// a dialog in front ends it, and nothing has happened; while armed it does nothing. Install on the application. GUI thread.
class ArmKey : public QObject {
    Q_OBJECT
public:
    ArmKey(Lamp &lamp, QWidget &window);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    [[nodiscard]] bool press(const QKeyEvent &key);
    void release(const QKeyEvent &key);

    Lamp &m_lamp;
    QWidget &m_window;
};

} // namespace mb
