// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "transport/qtclock.h"

#include <QCoreApplication>
#include <QEvent>

#include <functional>

namespace mb::test {

/// The real event loop, for tests of what works on descriptors. Make it first: notifiers need it.
class EventLoop {
public:
    EventLoop()
        : m_application(m_count, m_arguments)
    {
    }
    EventLoop(const EventLoop &) = delete;
    EventLoop &operator=(const EventLoop &) = delete;
    /// What was to be deleted later, is: no loop comes after this one.
    ~EventLoop() { QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); }
    [[nodiscard]] QtClock &clock() { return m_clock; }

    /// Serves events until `done()`; false when that did not come true within `limit`, so that no test hangs. Asked again after
    /// every event and every few milliseconds: what another process or thread does need not be an event here.
    bool runUntil(const std::function<bool()> &done, Duration limit = std::chrono::seconds(20))
    {
        bool late = false;
        Timer alarm(m_clock);
        alarm.startIn(limit, [&late] { late = true; });
        Timer look(m_clock);
        while (!done() && !late) {
            look.startIn(std::chrono::milliseconds(5), [] {});
            turn();
        }
        return done();
    }
    /// Waits until something is to be served, and serves what is, each once.
    static void turn() { QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents); }
    /// Serves what is at hand: everything that was ready before this call has run when it returns.
    void runReady()
    {
        bool reached = false;
        m_clock.post([&reached] { reached = true; });
        runUntil([&reached] { return reached; });
        QCoreApplication::processEvents();
    }

private:
    int m_count = 1;
    char m_name[5] = "test";
    char *m_arguments[2] = {m_name, nullptr};
    QCoreApplication m_application;
    QtClock m_clock;
};

} // namespace mb::test
