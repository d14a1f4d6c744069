// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "families/dmc60c/simulatorparameters.h"
#include "families/dmc60c/simulatorrig.h"

#include <functional>
#include <string_view>

namespace mb::dmc60c::simulation {

/// The faults of a unit: what the loop finds and what comes from outside, counted in the parameters. Some hold the bridge open for
/// a while.
class FaultMonitor {
public:
    using Notify = std::function<void(Instant, std::string_view, double)>;

    /// The bank outlives it.
    FaultMonitor(ParameterBank &bank, Notify notify)
        : m_bank(bank)
        , m_notify(std::move(notify))
    {
    }

    /// The application starts.
    void start(Instant now);
    /// One pass of the loop.
    void pass(const Rig &rig, Instant at);
    /// Fault bits that do not come from the loop: gate driver, communication.
    void setOutside(std::uint32_t bit, bool present) { m_outside = present ? m_outside | bit : m_outside & ~bit; }
    /// The same for a loop that runs: they hold at once.
    void raiseOutside(std::uint32_t bit, bool present, Instant now);
    [[nodiscard]] bool holdsBridge() const { return m_holds; }
    [[nodiscard]] bool any() const { return m_faults != 0; }
    [[nodiscard]] bool has(std::uint32_t bit) const { return (m_faults & bit) != 0U; }
    /// The supply has been low for a while: something may happen without anybody asking.
    [[nodiscard]] bool isSupplyLow() const { return m_lowPasses != 0; }

private:
    void raise(std::uint32_t bits, Instant at);

    ParameterBank &m_bank;
    Notify m_notify;
    std::uint32_t m_faults = 0;
    std::uint32_t m_outside = 0;
    Instant m_until{};
    bool m_holds = false;
    int m_lowPasses = 0;
    int m_overCurrentPasses = 0;
};

} // namespace mb::dmc60c::simulation
