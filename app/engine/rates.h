// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine/context.h"
#include "widgets/orders/deviceorders.h"

#include <functional>
#include <map>
#include <set>

namespace mb {

/// How often devices send their telemetry: the one place where the wishes for it meet. Engine thread.
///
/// Who asks: each page that draws a device (widgets/common/pagerates.h), under a number of its own, by orders::WishRates.
/// Who wins: of several wishes for a channel the highest, so nobody's wish lowers another's. Where channels come in one frame, the
/// family sends it for the fastest of them (telemetry/framerate.h). An experiment has the device to itself and rates of its own
/// while it runs, whatever pages wish (tuning/experimentrun.h); afterwards the wishes hold again.
/// How a wish ends: the same one wishes without it, and a page that is hidden or closed wishes nothing. Then the next highest holds,
/// or the device's own rate where nobody is left, also at the end of the program.
///
/// Each rate is an operation of its device, so they are set one after the other, each while its device is free, what somebody waits to
/// see before what nobody does. A rate that a device refuses is told in the log, and not asked for again; one that got lost is told
/// once, and asked for until it is answered; where nobody wishes it any more the device's own rate is.
class Rates {
public:
    explicit Rates(const EngineContext &context)
        : m_context(context)
        , m_next(context.clock)
        , m_limit(context.clock)
    {
    }

    void carryOut(const orders::WishRates &order, const Finished &finished);
    /// An experiment had rates of its own in this device.
    void restore(DeviceId device);
    /// Nobody wishes anything any more. `done` is called once, later: when devices have their own rates, or after a second.
    void end(std::function<void()> done);

private:
    using Place = std::pair<DeviceId, ChannelIndex>;

    [[nodiscard]] std::map<Place, double> wished() const;
    [[nodiscard]] std::map<Place, double> open() const;
    [[nodiscard]] bool isFree(DeviceId device) const;
    void wait();
    void setNext();
    void set(const Place &place, double hertz);
    void ended(const Place &place, DeviceId device, const Result<void> &result);
    void finish();

    EngineContext m_context;
    std::map<std::uint64_t, std::map<Place, double>> m_wishes; ///< by who wishes
    std::map<Place, double> m_inForce;                         ///< what the devices were asked for
    std::set<Place> m_lost;                                    ///< without an answer, so perhaps not in force; told so
    int m_underWay = 0;
    std::function<void()> m_done; ///< of end(); empty: it has not begun, or is over
    Timer m_next;
    Timer m_limit;
};

} // namespace mb
