// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/clock.h"

namespace mb {

Clock::Key Clock::arm(Instant deadline, std::function<void()> work)
{
    const Key key{deadline, ++m_sequence};
    m_queue.emplace(key, std::move(work));
    rescheduled();
    return key;
}

void Clock::disarm(Key key)
{
    // The work is destroyed last: what it captured may disarm other work.
    if (const auto forgotten = m_queue.extract(key))
        rescheduled();
}

void Clock::runNext()
{
    auto next = m_queue.extract(m_queue.begin());
    next.mapped()();
}

void Timer::start(Instant deadline, std::function<void()> work)
{
    stop();
    m_active = true;
    m_key = m_clock.arm(deadline, [this, work = std::move(work)] {
        m_active = false;
        work();
    });
}

void Timer::stop()
{
    if (std::exchange(m_active, false))
        m_clock.disarm(m_key);
}

} // namespace mb
