// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

#include <algorithm>
#include <random>

namespace mb::test {

/// The clock of a computer that is busy: virtual time, but whoever is called is called late, now and then by as much as
/// `most`, and everything that fell due meanwhile comes at once. The same delays with the same seed.
class StallingClock final : public Clock {
public:
    explicit StallingClock(Duration most, std::uint64_t seed = 1)
        : m_most(most)
        , m_random(seed)
    {
    }
    [[nodiscard]] Instant now() const override { return m_now; }
    [[nodiscard]] Duration unixOffset() const override { return Duration::zero(); }

    void advance(Duration time)
    {
        (void)runUntil([] { return false; }, time);
    }
    /// False when `limit` passed first.
    bool runUntil(const std::function<bool()> &done, Duration limit)
    {
        const Instant end = m_now + limit;
        while (!done()) {
            if (!hasWork() || nextDeadline() > end) {
                m_now = std::max(m_now, end);
                return false;
            }
            m_now = std::max(m_now, nextDeadline() + lateness());
            while (hasWork() && nextDeadline() <= m_now && !done())
                runNext();
        }
        return true;
    }

private:
    /// Mostly some microseconds; one time in fifty up to `most`.
    Duration lateness()
    {
        const auto drawn = m_random();
        const Duration most = drawn % 50 == 0 ? m_most : Duration(std::chrono::microseconds(50));
        return Duration(static_cast<Duration::rep>((drawn >> 8U) % static_cast<std::uint64_t>(most.count())));
    }

    Duration m_most;
    std::mt19937_64 m_random;
    Instant m_now{};
};

} // namespace mb::test
