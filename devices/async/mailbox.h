// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"

#include <atomic>
#include <functional>
#include <mutex>
#include <vector>

namespace mb {

/// The one way across threads: functions posted by any thread, run by the thread that drains. Plain C++ and an eventfd,
/// so that ThreadSanitizer can judge it without Qt.
class Mailbox : NonCopyable {
public:
    Mailbox();
    ~Mailbox();

    /// Any thread. False after close(): the work was not taken.
    bool post(std::function<void()> work);
    /// Any thread: a lane of its own, for STOP. Goes before everything that waits, also before the rest of a drain() under way.
    bool postUrgent(std::function<void()> work);
    /// The owner's thread: runs what was posted before this call, in order.
    void drain();
    /// Any thread: nothing is taken any more, and what waits is dropped, the rest of a drain() under way too.
    void close();
    /// Readable while work waits.
    [[nodiscard]] int descriptor() const { return m_event; }

private:
    bool put(std::vector<std::function<void()>> &lane, std::function<void()> work);
    void drainUrgent();

    int m_event = -1;
    std::mutex m_mutex;
    std::vector<std::function<void()>> m_waiting;
    std::vector<std::function<void()>> m_urgent;
    std::atomic<bool> m_closed = false;
};

} // namespace mb
