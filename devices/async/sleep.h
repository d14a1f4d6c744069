// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

#include <coroutine>

namespace mb {

/// `co_await Sleep(clock, 20ms);` inside a Task. Cancelled with its coroutine.
class Sleep {
public:
    Sleep(Clock &clock, Duration time)
        : m_time(time)
        , m_clock(clock)
        , m_timer(clock)
    {
    }
    [[nodiscard]] bool await_ready() const noexcept { return false; }
    void await_suspend(std::coroutine_handle<> handle)
    {
        m_timer.start(m_clock.now() + m_time, [handle] { std::coroutine_handle<>(handle).resume(); });
    }
    void await_resume() const noexcept { }

private:
    Duration m_time;
    Clock &m_clock;
    Timer m_timer;
};

} // namespace mb
