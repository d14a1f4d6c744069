// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "simulation/simulator.h"

#include <functional>
#include <list>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace mb {

/// nullptr: the unit has no such fault.
[[nodiscard]] const SimulatedFault *findFault(std::span<const SimulatedFault> faults, FaultKind kind);

/// What becomes of a frame that a simulated unit sends.
struct FrameFate {
    std::uint64_t number = 0; ///< from 1
    bool lost = false;
    bool corrupt = false;
    std::optional<Duration> delay;
};

/// The faults of one simulated unit: those that count its frames, and those that come at their time from its making on.
class FaultPlan {
public:
    static constexpr Duration brownoutTime = std::chrono::seconds(6);

    FaultPlan(Clock &clock, std::vector<SimulatedFault> faults);

    [[nodiscard]] bool has(FaultKind kind) const { return findFault(m_faults, kind) != nullptr; }
    /// One more frame is sent.
    [[nodiscard]] FrameFate sent();
    /// One more frame was for this unit; whether the supply goes with it.
    [[nodiscard]] bool failsWithFrame() { return strikes(FaultKind::Power, ++m_heard) != nullptr; }
    /// This page, or line, of firmware is being written; whether the supply goes with it. Once.
    [[nodiscard]] bool failsWithPage(int page);
    /// For a while nothing is heard and nothing sent.
    [[nodiscard]] bool isBusOff() const { return m_busOff.isActive(); }

    /// Runs `work` at each fault of this kind, or so much later.
    void at(FaultKind kind, const std::function<void()> &work) { after(kind, {}, work); }
    void after(FaultKind kind, Duration later, const std::function<void()> &work);
    /// A brownout takes the supply down to 5 V and back to 12 V.
    void sag(const std::function<void(double volts)> &setVoltage);

private:
    [[nodiscard]] const SimulatedFault *strikes(FaultKind kind, std::uint64_t number) const;

    Clock &m_clock;
    std::vector<SimulatedFault> m_faults;
    std::uint64_t m_sent = 0;
    std::uint64_t m_heard = 0;
    Timer m_busOff;
    std::list<Timer> m_timers;
};

} // namespace mb
