// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/faultplan.h"
#include "transport/canlink.h"

#include <map>

namespace mb {

/// The transmit side of a simulated unit: replies after a delay and in order, status frames at once, and the faults that strike
/// the N-th frame sent.
class CanOutbox {
public:
    /// All outlive it.
    CanOutbox(CanLink &link, Clock &clock, FaultPlan &faults);

    /// Not before `delay` has passed, nor before what was posted earlier.
    void post(const CanFrame &frame, Duration delay);
    void send(const CanFrame &frame);
    /// Replies that were not sent yet, with what waits in the link.
    [[nodiscard]] std::size_t waiting() const { return m_waiting.size() + m_link.backlog(); }
    /// What was not sent yet never will be, not even what a fault has delayed.
    void clear();

private:
    void rearm();
    void flush();

    CanLink &m_link;
    Clock &m_clock;
    FaultPlan &m_faults;
    std::multimap<Instant, CanFrame> m_waiting;
    std::multimap<Instant, CanFrame> m_delayed; ///< by a fault: others overtake
    Instant m_lastDue{};
    Timer m_timer;
};

} // namespace mb
