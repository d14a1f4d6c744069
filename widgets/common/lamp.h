// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QAbstractButton>
#include <QBasicTimer>
#include <QElapsedTimer>
#include <QKeyEvent>
#include <chrono>
#include <optional>

namespace mb {

/// Whether energy may flow. Stopped means: was stopped, motion needs a new arming. Stopping: told, and not seen to stand yet.
/// MayTurn: told, nobody has seen it stand, and nothing of its own stops it.
enum class LampState { Safe, Armed, Moving, Stopped, Stopping, MayTurn };

/// What the lamp says. `detail` is the small text behind the word ("#5 velocity", "4 motors", "nothing to arm");
/// empty gives the instruction "hold to arm"; of MayTurn it stands below the word. `remaining` is shown while armed, as m:ss.
struct LampStatus {
    LampState state = LampState::Safe;
    QString detail;
    std::optional<std::chrono::seconds> remaining;
    bool armable = true; ///< false: holding does nothing, the lamp is faint
};

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
    double holdProgress() const;
    int holdMilliseconds() const { return m_hold; }
    void setHoldMilliseconds(int milliseconds) { m_hold = milliseconds; }
    /// Begins a hold as the mouse does; nothing while it is held, armed or moving, or nothing can be armed.
    void hold();
    /// Ends a hold; before its time nothing happens.
    void letGo() { endHold(holdProgress() >= 1.0); }
    QSize sizeHint() const override;
    /// Word above, detail below: what a narrow window leaves of it.
    QSize minimumSizeHint() const override;

Q_SIGNALS:
    /// The hold is complete.
    void armRequested();
    /// Pressed while armed or moving: the user wants to be safe again.
    void disarmRequested();
    /// The hold began (true) or ended in any way (false).
    void holdingChanged(bool holding);

protected:
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override { mousePressEvent(event); }
    void keyPressEvent(QKeyEvent *event) override { event->ignore(); }
    void keyReleaseEvent(QKeyEvent *event) override { event->ignore(); }
    void timerEvent(QTimerEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    bool live() const { return m_status.state == LampState::Armed || m_status.state == LampState::Moving; }
    void press();
    void beginHold();
    void endHold(bool complete);
    void updateAccessibleText(LampState before);
    QString word() const;
    QString clock() const;
    QString detail() const;
    int textWidth(const QString &word, const QString &time, const QString &detail) const;
    int contentWidth() const;
    /// "May still turn" is too long for one line beside its detail.
    bool hasTwoLines() const { return m_status.state == LampState::MayTurn; }
    bool isNarrow() const { return hasTwoLines() || width() < contentWidth(); }
    void paintMark(QPainter &painter, int x, const QColor &color) const;
    void paintLines(QPainter &painter, const QColor &color, const QColor &detailColor) const;
    void paintFace(QPainter &painter) const;
    void paintContent(QPainter &painter, const QColor &color, const QColor &detailColor) const;

    const ThemeSource &m_theme;
    LampStatus m_status;
    int m_hold = 1000;
    bool m_holding = false;
    QElapsedTimer m_held;
    QBasicTimer m_tick;
};

} // namespace mb
