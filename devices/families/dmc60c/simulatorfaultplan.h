// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "simulation/simulator.h"

#include <functional>
#include <memory>
#include <string_view>
#include <vector>

namespace mb::dmc60c::simulation {

/// The faults of a unit that are no matter of its outbox: those that come at their time, and losses of the supply.
class FaultPlan {
public:
    struct Actions {
        std::function<void()> reset;
        std::function<void()> loseBus;
        std::function<void()> killEncoder;
        std::function<void(std::string_view what, double value)> disturb;
    };
    FaultPlan(Clock &clock, std::vector<SimulatedFault> faults, Actions actions);

    /// For a while nothing is heard.
    [[nodiscard]] bool isBusOff() const { return m_busOff.isActive(); }
    /// One more frame was for this unit; whether the supply goes with it.
    [[nodiscard]] bool powerFailsWithFrame();
    /// Half of this page is written; whether the supply goes at this moment. Once.
    [[nodiscard]] bool powerFailsWithPage(int page);

private:
    void schedule(const SimulatedFault &fault);
    void at(double seconds, std::function<void()> work);

    Clock &m_clock;
    std::vector<SimulatedFault> m_faults;
    Actions m_actions;
    std::uint64_t m_addressed = 0;
    Timer m_busOff;
    std::vector<std::unique_ptr<Timer>> m_timers;
};

} // namespace mb::dmc60c::simulation
