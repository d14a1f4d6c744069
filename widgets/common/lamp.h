// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/holdgesture.h"
#include "widgets/common/lampface.h"

#include <QAbstractButton>
#include <QKeyEvent>

namespace mb {

/// The arming lamp: held for a second it fills from the left and then asks for arming; let go early, nothing happens.
/// It takes no key itself (a key that is held comes by hold()), and Tab never comes here. An assistive "press" starts the same filling, a second one cancels it.
class Lamp : public QAbstractButton {
    Q_OBJECT
    Q_PROPERTY(int holdMilliseconds READ holdMilliseconds WRITE setHoldMilliseconds)
public:
    explicit Lamp(const ThemeSource &theme, QWidget *parent = nullptr);

    const LampStatus &status() const { return m_status; }
    void setStatus(const LampStatus &status);
    /// 0 … 1, how much of the hold has passed.
    double holdProgress() const { return m_hold.progress(); }
    int holdMilliseconds() const { return m_hold.milliseconds(); }
    void setHoldMilliseconds(int milliseconds) { m_hold.setMilliseconds(milliseconds); }
    /// Begins a hold as the mouse does; nothing while it is held, armed or moving, or nothing can be armed.
    void hold();
    /// Ends a hold for nothing.
    void giveUp() { m_hold.end(); }
    QSize sizeHint() const override { return face().preferred(); }
    /// Word above, detail below: what a narrow window leaves of it.
    QSize minimumSizeHint() const override { return face().least(); }

Q_SIGNALS:
    /// The hold is complete.
    void armRequested();
    /// Pressed while armed or moving: the user wants to be safe again.
    void disarmRequested();
    /// The hold began (true) or ended in any way (false).
    void holdingChanged(bool holding);

protected:
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *) override { } // held, never clicked
    void keyPressEvent(QKeyEvent *event) override { event->ignore(); }
    void keyReleaseEvent(QKeyEvent *event) override { event->ignore(); }

private:
    [[nodiscard]] LampFace face() const;
    void press();
    void updateAccessibleText(LampState before);

    const ThemeSource &m_theme;
    LampStatus m_status;
    HoldGesture m_hold;
};

} // namespace mb
