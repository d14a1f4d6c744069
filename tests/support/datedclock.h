// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

namespace mb::test {

/// The time of another clock, as a computer has it: far from what Unix calls now, so that who mixes the two up is seen.
class DatedClock final : public Clock {
public:
    explicit DatedClock(Clock &outer)
        : m_outer(outer)
        , m_timer(outer)
    {
    }
    [[nodiscard]] Instant now() const override { return m_outer.now(); }
    [[nodiscard]] Duration unixOffset() const override { return std::chrono::hours(500'000); }

private:
    void rescheduled() override
    {
        if (hasWork())
            m_timer.start(nextDeadline(), [this] { serve(); });
        else
            m_timer.stop();
    }
    void serve()
    {
        while (hasWork() && nextDeadline() <= now())
            runNext();
        rescheduled();
    }

    Clock &m_outer;
    Timer m_timer;
};

} // namespace mb::test
