// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

#include <functional>
#include <optional>

namespace mb::supermodified {

/// Waits until nobody has said anything on a line for a while. A line that is never silent is taken for silent after 300 ms.
class Silence {
public:
    /// `over` is called from the clock after a look that said no.
    Silence(Clock &clock, std::function<void()> over)
        : m_clock(clock)
        , m_over(std::move(over))
        , m_timer(clock)
    {
    }

    /// From now on for at least this long.
    void await(Duration time)
    {
        m_end = m_clock.now() + time;
        m_limit = m_clock.now() + longest;
    }
    /// Bytes came; more may follow within `gap`.
    void interrupt(Duration gap)
    {
        m_heardAt = m_clock.now();
        if (m_end)
            m_end = std::max(*m_end, m_heardAt + gap);
    }
    [[nodiscard]] bool isAwaited() const { return m_end.has_value(); }
    [[nodiscard]] Instant heardAt() const { return m_heardAt; }
    /// Ends the wait when its time is over.
    [[nodiscard]] bool look()
    {
        if (!m_end)
            return true;
        const Instant end = std::min(*m_end, m_limit);
        if (end > m_clock.now()) {
            m_timer.start(end, m_over);
            return false;
        }
        m_end.reset();
        m_timer.stop();
        return true;
    }

    static constexpr Duration longest = std::chrono::milliseconds(300);

private:
    Clock &m_clock;
    std::function<void()> m_over;
    std::optional<Instant> m_end;
    Instant m_limit{};
    Instant m_heardAt{};
    Timer m_timer;
};

} // namespace mb::supermodified
