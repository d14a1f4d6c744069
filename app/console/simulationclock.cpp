// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/simulationclock.h"

#include <algorithm>

namespace mb::console {
namespace {

constexpr Duration longestRun = std::chrono::milliseconds(5); // then signals and output have their turn

} // namespace

SimulationClock::SimulationClock(Clock &base)
    : m_base(base)
    , m_origin(base.now())
    , m_timer(base)
{
}

void SimulationClock::rescheduled()
{
    if (m_running)
        return; // runDue() does, once, at its end
    if (hasWork())
        m_timer.start(m_origin + nextDeadline().time_since_epoch(), [this] { runDue(); });
    else
        m_timer.stop();
}

void SimulationClock::runDue()
{
    m_running = true;
    const Instant begun = m_base.now();
    const Instant until = Instant(begun - m_origin);
    while (hasWork() && nextDeadline() <= until && m_base.now() - begun < longestRun) {
        m_now = std::max(m_now, nextDeadline());
        runNext();
    }
    m_running = false;
    rescheduled();
}

} // namespace mb::console
