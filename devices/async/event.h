// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"

#include <coroutine>
#include <utility>

namespace mb {

/// Something that one task waits for and somebody else announces. `co_await event.wait();` goes on at once when it was set.
class Event : NonCopyable {
public:
    void set()
    {
        m_set = true;
        if (const auto waiting = std::exchange(m_waiting, {}))
            waiting.resume();
    }
    [[nodiscard]] bool isSet() const { return m_set; }

    class Wait : NonCopyable {
    public:
        explicit Wait(Event &event)
            : m_event(event)
        {
        }
        ~Wait() { m_event.m_waiting = {}; }
        [[nodiscard]] bool await_ready() const noexcept { return m_event.m_set; }
        void await_suspend(std::coroutine_handle<> handle) noexcept { m_event.m_waiting = handle; }
        void await_resume() const noexcept { }

    private:
        Event &m_event;
    };
    [[nodiscard]] Wait wait() { return Wait(*this); }

private:
    bool m_set = false;
    std::coroutine_handle<> m_waiting;
};

} // namespace mb
