// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/event.h"
#include "async/scope.h"

namespace mb::console {

/// The task, cut off with `late` when it takes longer than `limit`; without a limit for as long as it takes.
template <class T> Task<T> within(Clock &clock, Task<T> task, std::optional<Duration> limit, Error late)
{
    if (!limit)
        co_return co_await std::move(task).attempt();
    Result<T> result = fail(std::move(late));
    Event over;
    Timer timer(clock);
    Scope scope(clock);
    scope.spawn<T>(std::move(task), [&result, &over](Result<T> ended) {
        result = std::move(ended);
        over.set();
    });
    timer.startIn(*limit, [&over] { over.set(); });
    co_await over.wait();
    co_return std::move(result);
}

} // namespace mb::console
