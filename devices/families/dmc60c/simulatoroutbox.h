// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/faultplan.h"
#include "transport/canlink.h"

#include <map>

namespace mb::dmc60c::simulation {

/// The device's transmit side: replies after a delay and in order, status frames at once, and the faults that strike
/// the N-th frame sent.
class Outbox {
public:
    /// All outlive it.
    Outbox(CanLink &link, Clock &clock, FaultPlan &faults);

    /// Not before `delay` has passed, nor before what was posted earlier.
    void post(const CanFrame &frame, Duration delay);
    void send(const CanFrame &frame);
    /// What was not sent yet never will be.
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

} // namespace mb::dmc60c::simulation
