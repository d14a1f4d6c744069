// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/enginecore.h"

namespace mb {

/// To whoever gave the order, if they want to know.
inline void answer(const EngineCore::Finished &finished, Result<void> result)
{
    if (finished)
        finished(std::move(result));
}

/// One story after another, which may fail.
template <class T> Task<T> after(Task<void> first, Task<T> then)
{
    (void)co_await std::move(first).attempt();
    co_return co_await std::move(then).attempt();
}

template <class T>
EngineCore::Running *EngineCore::begin(DeviceId id, const Message &title,
    const std::function<Task<T>(Device &, Progress &)> &make, std::function<void(Running &, Result<T>)> finished,
    const Finished &refused)
{
    Device *device = m_session.find(id);
    if (!device) {
        answer(refused, fail(Fault::Timeout, say("the device is gone")));
        return nullptr;
    }
    makeWay(id);
    if (hasOperation(id)) {
        answer(refused, fail(Fault::Unsafe, say("the device is busy with something else")));
        return nullptr;
    }
    prune();
    m_operations.push_back({OperationId{++m_lastOperation}, id, std::make_unique<Operation>(m_clock, title),
        std::nullopt, 0, false, {}, false});
    Running &running = m_operations.back();
    running.operation->run<T>(
        make(*device, *running.operation), [this, &running, finished = std::move(finished)](Result<T> result) {
            finished(running, std::move(result));
            touch();
        });
    touch();
    return &running;
}

} // namespace mb
