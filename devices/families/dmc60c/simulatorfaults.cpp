// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/simulatorfaults.h"

#include <algorithm>
#include <cmath>

namespace mb::dmc60c::simulation {
namespace {

constexpr int passesPerSecond = 2000;
constexpr int lowPassesForFault = 5 * passesPerSecond;
constexpr double lowVolts = 5.75;
constexpr double overCurrentAmperes = 100.0; ///< the rating: 2 s
constexpr int overCurrentPasses = 2 * passesPerSecond;
constexpr double hotCelsius = 100.0; ///< not documented
constexpr double coolCelsius = 90.0;
constexpr std::uint32_t drivingFaults
    = faultbit::overCurrent | faultbit::overTemperature | faultbit::underVoltage | faultbit::gateDriver;

} // namespace

void FaultMonitor::start(Instant now)
{
    m_outside &= faultbit::gateDriver;
    m_faults = 0;
    m_holds = false;
    m_until = now;
    m_lowPasses = 0;
    m_overCurrentPasses = 0;
}

void FaultMonitor::raiseOutside(std::uint32_t bit, bool present, Instant now)
{
    raise(present ? m_faults | bit : m_faults & ~bit, now);
}

void FaultMonitor::pass(const Rig &rig, Instant at)
{
    m_lowPasses = rig.bus() < lowVolts ? std::min(m_lowPasses + 1, lowPassesForFault) : 0;
    const bool much = std::abs(rig.current()) > overCurrentAmperes;
    m_overCurrentPasses = much ? std::min(m_overCurrentPasses + 1, overCurrentPasses) : 0;
    const bool wasHot = (m_faults & faultbit::overTemperature) != 0U;
    std::uint32_t present = m_outside;
    if (m_overCurrentPasses == overCurrentPasses)
        present |= faultbit::overCurrent;
    if (m_lowPasses == lowPassesForFault)
        present |= faultbit::underVoltage;
    if (rig.caseTemperature() > (wasHot ? coolCelsius : hotCelsius))
        present |= faultbit::overTemperature;
    raise(present, at);
}

void FaultMonitor::raise(std::uint32_t present, Instant at)
{
    const std::uint32_t fresh = present & ~m_faults;
    m_faults = present;
    m_bank.set(param::activeFaults, present);
    if (fresh != 0) {
        m_bank.set(param::stickyFaults, m_bank.raw(param::stickyFaults) | fresh);
        for (unsigned bit = 0; bit < 5; ++bit) {
            const auto count = static_cast<std::uint8_t>(param::overCurrentCount + bit);
            if ((fresh >> bit & 1U) != 0U)
                m_bank.set(count, m_bank.raw(count) + 1);
        }
        m_notify(at, "fault", static_cast<double>(present));
    }
    if ((present & drivingFaults) != 0U)
        m_until = at + faultHold;
    m_holds = at < m_until;
}

} // namespace mb::dmc60c::simulation
