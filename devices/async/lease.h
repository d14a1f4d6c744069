// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

namespace mb {

/// Something that ends unless it is renewed in time: the motion lease of docs/architecture.md#motion-lease.
class Lease {
public:
    Lease(Clock &clock, std::function<void()> expired)
        : m_clock(clock)
        , m_expired(std::move(expired))
        , m_timer(clock)
    {
    }
    /// It counts while nothing is held, too.
    void renew()
    {
        m_renewedAt = m_clock.now();
        if (m_timer.isActive())
            hold(m_term);
    }
    /// The last renewal is so long ago that one of this term would be over.
    [[nodiscard]] bool isOver(Duration term) const { return m_clock.now() >= m_renewedAt + term; }
    /// From now on it expires a term after the last renewal.
    void hold(Duration term)
    {
        m_term = term;
        m_timer.start(m_renewedAt + term, [this] {
            const auto expired = m_expired; // the callback may destroy the lease
            expired();
        });
    }
    void release() { m_timer.stop(); }

private:
    Clock &m_clock;
    std::function<void()> m_expired;
    Duration m_term{};
    Instant m_renewedAt = Instant::min();
    Timer m_timer;
};

} // namespace mb
