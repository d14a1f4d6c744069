// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/holdgesture.h"
#include "widgets/common/iconbutton.h"

namespace mb {

/// A button that acts by a click, or, where that would be too easy, only when the pointer, or Enter where it has the focus, has held it for
/// a second. An assistive "press" begins that, a second one ends it. It is never the default button of a dialog.
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
    void giveUp() { m_hold.end(); }

Q_SIGNALS:
    /// Clicked, or held long enough: what is to be connected, not clicked().
    void activated();

protected:
    void paintEvent(QPaintEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void keyReleaseEvent(QKeyEvent *event) override;

private:
    [[nodiscard]] bool holds(const QKeyEvent &key) const;

    const ThemeSource &m_theme;
    bool m_needed = false;
    HoldGesture m_hold;
};

} // namespace mb
