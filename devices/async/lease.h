// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

namespace mb {

/// Something that ends unless it is renewed in time: the motion lease of docs/architecture.md#motion-lease.
class Lease {
public:
    Lease(Clock &clock, Duration term, std::function<void()> expired)
        : m_clock(clock)
        , m_term(term)
        , m_expired(std::move(expired))
        , m_timer(clock)
    {
        renew();
    }
    void renew()
    {
        m_timer.start(m_clock.now() + m_term, [this] {
            const auto expired = m_expired; // the callback may destroy the lease
            expired();
        });
    }
    [[nodiscard]] Duration term() const { return m_term; }

private:
    Clock &m_clock;
    Duration m_term;
    std::function<void()> m_expired;
    Timer m_timer;
};

} // namespace mb
