// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "async/event.h"
#include "async/noncopyable.h"
#include "async/task.h"

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace mb {

/// Where work is done that may block: opening a port, writing to a disk. What is under way in one lane is done in its order; lanes do
/// not wait for each other, so one port that hangs holds up nothing but itself.
class Background : NonCopyable {
public:
    virtual ~Background() = default;

    /// `work` in a thread where it may block, then `done` in the thread that called this, from its event loop. `work` is destroyed
    /// before `done` runs.
    virtual void run(const std::string &lane, std::function<void()> work, std::function<void()> done) = 0;
};

/// What becomes of work that nobody waits for any more before it has begun.
enum class WhenLate { Drop, Finish };

/// What `work` yields in the background; Timeout when that takes longer than `limit`. What it yields later, or after this was
/// cancelled, is dropped.
template <class T>
[[nodiscard]] Task<T> inBackground(Background &background, Clock &clock, std::string lane, Duration limit,
    std::function<Result<T>()> work, WhenLate whenLate)
{
    struct Job {
        std::optional<Result<T>> result; ///< of the worker's thread until `isDone`
        bool isDone = false;
        std::atomic<bool> isLate = false;
        Event ended;
    };
    const auto job = std::make_shared<Job>();
    struct Leave : private NonCopyable {
        explicit Leave(std::atomic<bool> &late)
            : isLate(late)
        {
        }
        ~Leave() { isLate = true; }
        std::atomic<bool> &isLate;
    };
    const Leave leave(job->isLate);
    background.run(
        lane,
        [job, work = std::move(work), whenLate] {
            if (whenLate == WhenLate::Finish || !job->isLate)
                job->result.emplace(work());
        },
        [job] {
            job->isDone = true;
            job->ended.set();
        });
    Timer late(clock);
    late.startIn(limit, [job] { job->ended.set(); });
    co_await job->ended.wait();
    if (!job->isDone)
        co_return fail(Fault::Timeout, say("this takes too long"));
    co_return std::move(*job->result);
}

} // namespace mb
