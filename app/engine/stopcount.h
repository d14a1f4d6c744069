// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/devicestop.h"
#include "widgets/orders/order.h"

#include <atomic>
#include <cstdint>

namespace mb {

/// How often everything was stopped: what was ordered before a stop and is come to after it would turn a motor that everybody takes for
/// stopped. Any thread.
class StopCount {
public:
    struct Moment {
        std::uint64_t stops = 0;
        std::uint64_t ofTheUser = 0;
    };

    void count(StopCause cause)
    {
        ++m_stops;
        m_ofTheUser += cause == StopCause::User ? 1 : 0;
    }
    [[nodiscard]] Moment now() const { return {m_stops, m_ofTheUser}; }
    /// A stop that came after `given` takes this order back.
    [[nodiscard]] bool takesBack(const Order &order, Moment given) const
    {
        switch (takenBackBy(order)) {
        case TakenBackBy::EveryStop: return m_stops != given.stops;
        case TakenBackBy::StopOfTheUser: return m_ofTheUser != given.ofTheUser;
        case TakenBackBy::NoStop: break;
        }
        return false;
    }

private:
    std::atomic<std::uint64_t> m_stops = 0;
    std::atomic<std::uint64_t> m_ofTheUser = 0;
};

} // namespace mb
