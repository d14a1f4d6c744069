// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/canoutbox.h"

#include <algorithm>

namespace mb {

CanOutbox::CanOutbox(CanLink &link, Clock &clock, FaultPlan &faults)
    : m_link(link)
    , m_clock(clock)
    , m_faults(faults)
    , m_timer(clock)
{
}

void CanOutbox::post(const CanFrame &frame, Duration delay)
{
    m_lastDue = std::max(m_clock.now() + delay, m_lastDue);
    m_waiting.emplace(m_lastDue, frame);
    rearm();
}

void CanOutbox::clear()
{
    m_waiting.clear();
    m_delayed.clear();
    m_timer.stop();
}

void CanOutbox::send(const CanFrame &frame)
{
    const FrameFate fate = m_faults.sent();
    if (fate.lost)
        return;
    CanFrame sent = frame;
    if (fate.corrupt && sent.size > 0)
        sent.data[fate.number % sent.size] ^= 0x55U;
    if (fate.delay) {
        m_delayed.emplace(m_clock.now() + *fate.delay, sent);
        rearm();
        return;
    }
    (void)m_link.send(sent); // a lost link is noticed by its state
}

void CanOutbox::rearm()
{
    if (m_waiting.empty() && m_delayed.empty()) {
        m_timer.stop();
        return;
    }
    const Instant first = m_waiting.empty() ? Instant::max() : m_waiting.begin()->first;
    const Instant second = m_delayed.empty() ? Instant::max() : m_delayed.begin()->first;
    m_timer.start(std::min(first, second), [this] { flush(); });
}

void CanOutbox::flush()
{
    const Instant now = m_clock.now();
    while (!m_delayed.empty() && m_delayed.begin()->first <= now)
        (void)m_link.send(m_delayed.extract(m_delayed.begin()).mapped());
    while (!m_waiting.empty() && m_waiting.begin()->first <= now)
        send(m_waiting.extract(m_waiting.begin()).mapped());
    rearm();
}

} // namespace mb
