// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/hold.h"
#include "widgets/common/iconbutton.h"

namespace mb {

/// A button that acts by a click, or, where that would be too easy, only when the pointer has held it for a second. No key and no
/// synthetic click passes then.
class HoldButton : public CommandButton {
    Q_OBJECT
    Q_PROPERTY(int holdMilliseconds READ holdMilliseconds WRITE setHoldMilliseconds)
public:
    HoldButton(const ThemeSource &theme, Symbol symbol, const QString &text, QWidget *parent = nullptr);

    /// Ends a hold that is under way.
    void setHoldNeeded(bool needed);
    [[nodiscard]] bool isHoldNeeded() const { return m_needed; }
    [[nodiscard]] int holdMilliseconds() const { return m_hold.milliseconds(); }
    void setHoldMilliseconds(int milliseconds) { m_hold.setMilliseconds(milliseconds); }

    /// Ends a hold for nothing; the pointer has to come again.
    void giveUp();

Q_SIGNALS:
    /// Clicked, or held long enough: what is to be connected, not clicked().
    void activated();

protected:
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void timerEvent(QTimerEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    void changeEvent(QEvent *event) override;
    bool event(QEvent *event) override;

private:
    void endHold();

    const ThemeSource &m_theme;
    bool m_needed = false;
    Hold m_hold;
};

} // namespace mb
