// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/simulator.h"
#include "transport/canlink.h"

#include <map>
#include <vector>

namespace mb::dmc60c::simulation {

/// The device's transmit side: replies after a delay and in order, status frames at once, and the faults that strike
/// the N-th frame sent.
class Outbox {
public:
    Outbox(CanLink &link, Clock &clock, std::vector<SimulatedFault> faults);

    /// Not before `delay` has passed, nor before what was posted earlier.
    void post(const CanFrame &frame, Duration delay);
    void send(const CanFrame &frame);
    /// What was not sent yet never will be.
    void clear();

private:
    void rearm();
    void flush();
    [[nodiscard]] const SimulatedFault *strikes(std::string_view kind) const;

    CanLink &m_link;
    Clock &m_clock;
    std::vector<SimulatedFault> m_faults;
    std::multimap<Instant, CanFrame> m_waiting;
    std::multimap<Instant, CanFrame> m_delayed; ///< by a fault: others overtake
    Instant m_lastDue{};
    std::uint64_t m_sent = 0;
    Timer m_timer;
};

} // namespace mb::dmc60c::simulation
