// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/sleep.h"
#include "async/task.h"

namespace mb::test {

using namespace std::chrono_literals;

inline Task<int> valueNow(int value)
{
    co_return value;
}

inline Task<int> valueLater(Clock &clock, int value, Duration delay = 1ms)
{
    co_await Sleep(clock, delay);
    co_return value;
}

inline Task<int> failLater(Clock &clock)
{
    co_await Sleep(clock, 1ms);
    co_return fail(Fault::Timeout, say("later"));
}

} // namespace mb::test
