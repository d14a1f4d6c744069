// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/pacedclock.h"

#include <algorithm>
#include <cmath>

namespace mb {
namespace {

constexpr int mostAtOnce = 256; ///< pieces of work before others get their turn

} // namespace

PacedClock::PacedClock(Clock &outer)
    : m_outer(outer)
    , m_offset(outer.unixOffset())
    , m_now(outer.now())
    , m_anchor(m_now)
    , m_outerAnchor(m_now)
    , m_timer(outer)
{
}

Instant PacedClock::timeAt(Instant outer) const
{
    const Duration passed = std::max(outer - m_outerAnchor, Duration::zero());
    if (m_pace == 1.0)
        return m_anchor + passed;
    return m_anchor + Duration(static_cast<Duration::rep>(static_cast<double>(passed.count()) * m_pace));
}

Instant PacedClock::outerTimeOf(Instant deadline) const
{
    const Duration ahead = std::max(deadline - m_anchor, Duration::zero());
    if (m_pace == 1.0)
        return m_outerAnchor + ahead;
    if (m_pace == 0.0)
        return m_outer.now();
    const double scaled = std::ceil(static_cast<double>(ahead.count()) / m_pace);
    constexpr double farthest = 4e18; // far beyond any recording, and an Instant still
    return m_outerAnchor + Duration(static_cast<Duration::rep>(std::min(scaled, farthest / 2)));
}

Instant PacedClock::now() const
{
    if (!m_running || m_inWork || m_pace == 0.0)
        return m_now;
    Instant time = timeAt(m_outer.now());
    if (hasWork())
        time = std::min(time, nextDeadline()); // it must not seem later than work that is still to be done
    return std::max(m_now, time);
}

void PacedClock::run(double pace)
{
    m_now = now();
    m_pace = pace;
    m_running = true;
    m_anchor = m_now;
    m_outerAnchor = m_outer.now();
    rescheduled();
}

void PacedClock::pause()
{
    m_now = now();
    m_running = false;
    m_timer.stop();
}

void PacedClock::jump(Instant to)
{
    m_now = to;
    m_anchor = to;
    m_outerAnchor = m_outer.now();
    rescheduled();
}

void PacedClock::rescheduled()
{
    if (m_inWork)
        return; // runDue() looks at its end
    if (!m_running || !hasWork()) {
        m_timer.stop();
        return;
    }
    const Instant outer = outerTimeOf(nextDeadline());
    if (m_timer.isActive() && m_armedFor == nextDeadline() && m_outerArmedFor == outer)
        return;
    m_armedFor = nextDeadline();
    m_outerArmedFor = outer;
    m_timer.start(outer, [this] { runDue(); });
}

void PacedClock::runDue()
{
    m_inWork = true;
    const Instant until = m_pace == 0.0 ? Instant::max() : std::max(m_armedFor, timeAt(m_outer.now()));
    for (int i = 0; i < mostAtOnce && m_running && hasWork() && nextDeadline() <= until; ++i) {
        m_now = std::max(m_now, nextDeadline());
        runNext();
    }
    m_inWork = false;
    rescheduled();
}

} // namespace mb
