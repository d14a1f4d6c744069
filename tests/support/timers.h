// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>
#include <QTimer>

namespace mb::test {

/// Waits until a timer of this interval, which begins now, has come so often. What a timer of the program that began before was to
/// do by then is done, also on a computer that was busy meanwhile: timers come in the order in which they are due.
inline void passTimers(std::chrono::milliseconds interval, int times = 1)
{
    int came = 0;
    QTimer timer;
    timer.setTimerType(Qt::PreciseTimer);
    timer.callOnTimeout([&came] { ++came; });
    timer.start(interval);
    QVERIFY(QTest::qWaitFor([&] { return came >= times; }, 60'000));
}

} // namespace mb::test
