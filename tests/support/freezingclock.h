// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

#include <algorithm>

namespace mb::test {

/// Virtual time that can also stand still for the program while the world goes on, as after SIGSTOP, or for the whole computer.
class FreezingClock final : public Clock {
public:
    [[nodiscard]] Instant now() const override { return m_now; }
    [[nodiscard]] Duration unixOffset() const override { return {}; }
    [[nodiscard]] Duration slept() const override { return m_slept; }

    void advance(Duration time)
    {
        const Instant end = m_now + time;
        while (hasWork() && nextDeadline() <= end) {
            m_now = std::max(m_now, nextDeadline());
            runNext();
        }
        m_now = end;
    }
    /// Nothing is served for this long.
    void freeze(Duration time) { m_now += time; }
    /// The computer is suspended: no time passes here.
    void suspend(Duration time) { m_slept += time; }

private:
    Instant m_now{std::chrono::seconds(1)};
    Duration m_slept{};
};

} // namespace mb::test
