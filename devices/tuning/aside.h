// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/background.h"
#include "model/device.h"

#include <functional>

namespace mb::tuning {

/// What `work` yields, in the background of the device's link where it has one: a search takes longer than everything else that the
/// thread of the session has to do may wait. It owns all that it looks at. Timeout when nothing came of it within half a minute.
template <class T> [[nodiscard]] Task<T> aside(Device &device, std::function<Result<T>()> work)
{
    Background *const background = device.link().settings().background;
    if (!background)
        co_return work();
    auto working = inBackground<T>(
        *background, device.clock(), "design", std::chrono::seconds(30), std::move(work), WhenLate::Drop);
    co_return co_await std::move(working).attempt();
}

} // namespace mb::tuning
