// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "async/noncopyable.h"
#include "async/task.h"
#include "transport/canlink.h"

#include <coroutine>
#include <deque>
#include <functional>

namespace mb {

/// Collects matching frames from its construction on, so that an answer which comes while nobody waits is not lost.
/// `co_await inbox.next(250ms)` yields the next of them, Timeout, or LinkLost as soon as the link goes.
class CanInbox : NonCopyable {
public:
    using Match = std::function<bool(const CanFrame &)>;

    CanInbox(CanLink &link, Clock &clock, Match match);

    class Next : NonCopyable {
    public:
        explicit Next(CanInbox &inbox, Duration timeout)
            : m_inbox(inbox)
            , m_timeout(timeout)
        {
        }
        ~Next() { m_inbox.forget(); }
        [[nodiscard]] bool await_ready() const { return m_inbox.isReady(); }
        void await_suspend(std::coroutine_handle<> handle) { m_inbox.wait(handle, m_timeout); }
        [[nodiscard]] Result<CanFrame> await_resume() { return m_inbox.take(); }

    private:
        CanInbox &m_inbox;
        Duration m_timeout;
    };
    [[nodiscard]] Next next(Duration timeout) { return Next(*this, timeout); }
    void clear() { m_frames.clear(); }

private:
    [[nodiscard]] bool isReady() const { return !m_frames.empty() || m_link.state() != LinkState::Open; }
    void wait(std::coroutine_handle<> handle, Duration timeout);
    [[nodiscard]] Result<CanFrame> take();
    void forget();
    void wake();

    CanLink &m_link;
    std::deque<CanFrame> m_frames;
    std::coroutine_handle<> m_waiting;
    Timer m_timer;
    Subscription m_received;
    Subscription m_stateChanged;
};

} // namespace mb
