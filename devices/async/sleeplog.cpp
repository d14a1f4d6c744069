// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/sleeplog.h"

namespace mb {
namespace {

constexpr Duration shortestSleep = std::chrono::milliseconds(10); ///< below it two clocks were read one after the other

} // namespace

void SleepLog::look(Instant now, Duration slept)
{
    if (m_sleeps.empty())
        m_sleeps.push_back({Instant::min(), slept});
    else if (slept - m_sleeps.back().total >= shortestSleep)
        m_sleeps.push_back({m_lookedAt, slept});
    m_lookedAt = now;
}

Duration SleepLog::sleptAt(Instant time) const
{
    Duration slept{};
    for (const Sleep &sleep : m_sleeps) {
        if (sleep.after < time)
            slept = sleep.total;
    }
    return slept;
}

} // namespace mb
