// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/abstractdc/simulatoroptions.h"
#include "simulation/faultplan.h"
#include "transport/canlink.h"

#include <list>

namespace mb::abstractdc::simulation {

/// The replies of one simulated drive: three mailboxes, sent from the receive interrupt, spoilt by the faults that count them.
class Outbox {
public:
    /// All outlive it.
    Outbox(CanLink &link, Clock &clock, const UnitOptions &options, FaultPlan &faults);

    void reply(Log log, std::int32_t value);
    /// The power has gone: what waits is lost.
    void clear();

private:
    void transmit(CanFrame frame);

    CanLink &m_link;
    Clock &m_clock;
    const UnitOptions &m_options;
    FaultPlan &m_faults;
    std::list<Timer> m_replies;
    std::list<Timer> m_late; ///< frames that a fault delays
    std::size_t m_pending = 0;
};

} // namespace mb::abstractdc::simulation
