// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "async/noncopyable.h"
#include "async/task.h"

#include <list>
#include <memory>

namespace mb {

/// Owns tasks that nobody awaits. Destroying the scope cancels what still runs. `finished` gets the result; it runs
/// after the task's last step, from the clock, so that it may destroy the scope.
class Scope : NonCopyable {
public:
    explicit Scope(Clock &clock)
        : m_clock(clock)
    {
    }
    ~Scope() { clear(); }

    template <class T> void spawn(Task<T> task, std::function<void(Result<T>)> finished = {})
    {
        auto running = std::make_unique<Running<T>>(m_clock, std::move(task), std::move(finished));
        Running<T> &ref = *running;
        m_running.push_back(std::move(running));
        const auto self = std::prev(m_running.end());
        ref.task.start([this, self, &ref] {
            ref.timer.startIn(Duration::zero(), [this, self, &ref] {
                auto ended = std::move(*self);
                m_running.erase(self);
                const auto callback = std::move(ref.finished);
                Result<T> result = std::move(ref.task.result());
                ended.reset(); // locals of a task that failed die before anybody hears of it
                if (callback)
                    callback(std::move(result));
            });
        });
    }
    /// Cancels everything. Not from inside a task of this scope.
    void clear()
    {
        std::list<std::unique_ptr<Any>> cancelled;
        cancelled.swap(m_running);
    }
    [[nodiscard]] bool isIdle() const { return m_running.empty(); }

private:
    struct Any {
        virtual ~Any() = default;
    };
    template <class T> struct Running final : Any {
        Running(Clock &clock, Task<T> work, std::function<void(Result<T>)> callback)
            : task(std::move(work))
            , finished(std::move(callback))
            , timer(clock)
        {
        }
        Task<T> task;
        std::function<void(Result<T>)> finished;
        Timer timer;
    };

    Clock &m_clock;
    std::list<std::unique_ptr<Any>> m_running;
};

} // namespace mb
