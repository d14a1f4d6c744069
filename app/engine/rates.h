// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine/operations.h"
#include "widgets/orders/deviceorders.h"

#include <map>

namespace mb {

/// How often devices send telemetry, as the window has asked for it last. A rate is an operation of the device: what is asked for
/// while it is busy waits for it. Engine thread.
class Rates {
public:
    explicit Rates(const EngineContext &context);

    void carryOut(const orders::SetRate &order, const Finished &finished);
    /// An experiment had rates of its own: what was asked for before holds again.
    void restore(DeviceId device);

private:
    using Place = std::pair<DeviceId, ChannelIndex>;
    struct Waiting {
        double hertz = 0.0;
        std::vector<Finished> finished;
    };

    void set(const Place &place, double hertz, const Finished &finished);
    void setWaiting();

    EngineContext m_context;
    std::map<Place, double> m_wished; ///< asked for last; a trial has rates of its own meanwhile
    std::map<Place, Waiting> m_waiting;
    Timer m_again;
};

} // namespace mb
