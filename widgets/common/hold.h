// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QBasicTimer>
#include <QElapsedTimer>

class QObject;
class QTimerEvent;

namespace mb {

/// How long something has been held, added up by the ticks of a window that runs: a window that stood still has not seen whether it was
/// let go meanwhile, so one tick counts for `mostOfATick` at most. GUI thread.
class Hold {
public:
    static constexpr qint64 mostOfATick = 100; ///< ms

    [[nodiscard]] int milliseconds() const { return m_whole; }
    void setMilliseconds(int milliseconds) { m_whole = milliseconds; }

    /// Ticks come to `receiver` as timer events.
    void begin(QObject *receiver);
    void end() { m_ticks.stop(); }
    [[nodiscard]] bool isUnderWay() const { return m_ticks.isActive(); }
    /// 0 … 1; 0 while nothing is held.
    [[nodiscard]] double progress() const;
    /// False if the event is somebody else's.
    [[nodiscard]] bool tick(const QTimerEvent &event);

private:
    int m_whole = 1000;
    qint64 m_sum = 0;
    QElapsedTimer m_sinceTick;
    QBasicTimer m_ticks;
};

} // namespace mb
