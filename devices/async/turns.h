// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "async/noncopyable.h"

#include <coroutine>
#include <deque>
#include <utility>

namespace mb {

/// Where only one may talk at a time: `const Turns::Turn turn = co_await turns.take();` goes on when everybody who asked
/// before has let go. Letting go is the destruction of the turn. Outlives turns and waiters.
class Turns : NonCopyable {
public:
    explicit Turns(Clock &clock)
        : m_next(clock)
    {
    }

    class [[nodiscard]] Turn {
    public:
        explicit Turn(Turns &turns)
            : m_turns(&turns)
        {
        }
        Turn(Turn &&other) noexcept
            : m_turns(std::exchange(other.m_turns, nullptr))
        {
        }
        Turn &operator=(Turn &&) = delete;
        ~Turn()
        {
            if (m_turns)
                m_turns->release();
        }

    private:
        Turns *m_turns;
    };

    class Take : NonCopyable {
    public:
        explicit Take(Turns &turns)
            : m_turns(turns)
        {
        }
        ~Take() { m_turns.forget(this); }
        [[nodiscard]] bool await_ready() noexcept
        {
            m_given = !m_turns.m_taken && m_turns.m_waiting.empty();
            m_turns.m_taken = m_turns.m_taken || m_given;
            return m_given;
        }
        void await_suspend(std::coroutine_handle<> handle)
        {
            m_handle = handle;
            m_turns.m_waiting.push_back(this);
        }
        [[nodiscard]] Turn await_resume() noexcept
        {
            m_given = false;
            return Turn(m_turns);
        }

    private:
        friend class Turns;
        Turns &m_turns;
        std::coroutine_handle<> m_handle;
        bool m_given = false; ///< holds the turn, and nobody has been told yet
    };
    [[nodiscard]] Take take() { return Take(*this); }
    [[nodiscard]] bool isFree() const { return !m_taken; }

private:
    void release()
    {
        m_taken = false;
        if (!m_waiting.empty())
            m_next.startIn(Duration::zero(), [this] { handOver(); });
    }
    void handOver()
    {
        if (m_taken || m_waiting.empty())
            return;
        Take *next = m_waiting.front();
        m_waiting.pop_front();
        m_taken = true;
        next->m_given = true;
        std::coroutine_handle<>(next->m_handle).resume();
    }
    void forget(Take *take)
    {
        std::erase(m_waiting, take);
        if (take->m_given)
            release();
    }

    bool m_taken = false;
    std::deque<Take *> m_waiting;
    Timer m_next;
};

} // namespace mb
