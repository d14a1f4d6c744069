// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QBasicTimer>
#include <QElapsedTimer>
#include <QObject>

#include <functional>

class QAbstractButton;

namespace mb {

/// Holding a button: with the pointer, or by an assistive "press", which begins it and a second one ends it. Let go, left, hidden, disabled,
/// without focus or in a window that is not active any more it ends for nothing. How long it was held is added up by the ticks of a window
/// that runs: one that stood still has not seen whether it was let go meanwhile, so one tick counts for `mostOfATick` at most. GUI thread.
class HoldGesture : public QObject {
    Q_OBJECT
public:
    static constexpr qint64 mostOfATick = 100; ///< ms

    /// `press` decides what a press does: begin(), or something else. The button outlives this.
    HoldGesture(QAbstractButton &button, std::function<void()> press);

    [[nodiscard]] int milliseconds() const { return m_whole; }
    void setMilliseconds(int milliseconds) { m_whole = milliseconds; }
    void begin();
    /// For nothing.
    void end();
    [[nodiscard]] bool isUnderWay() const { return m_ticks.isActive(); }
    /// 0 … 1; 0 while nothing is held.
    [[nodiscard]] double progress() const;

Q_SIGNALS:
    /// It began (true) or ended in any way (false).
    void holdingChanged(bool holding);
    /// It was held long enough, and has ended.
    void completed();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
    void timerEvent(QTimerEvent *event) override;

private:
    QAbstractButton &m_button;
    std::function<void()> m_press;
    int m_whole = 1000;
    qint64 m_sum = 0;
    QElapsedTimer m_sinceTick;
    QBasicTimer m_ticks;
};

} // namespace mb
