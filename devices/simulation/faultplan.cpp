// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/faultplan.h"

#include "async/seconds.h"

#include <algorithm>

namespace mb {
namespace {

constexpr Duration busOffTime = std::chrono::milliseconds(100);
constexpr double brownoutVolts = 5.0;
constexpr double nominalVolts = 12.0;

} // namespace

const SimulatedFault *findFault(std::span<const SimulatedFault> faults, FaultKind kind)
{
    const auto found = std::ranges::find(faults, kind, &SimulatedFault::kind);
    return found == faults.end() ? nullptr : &*found;
}

FaultPlan::FaultPlan(Clock &clock, std::vector<SimulatedFault> faults)
    : m_clock(clock)
    , m_faults(std::move(faults))
    , m_busOff(clock)
{
    at(FaultKind::BusOff, [this] { m_busOff.startIn(busOffTime, [] {}); });
}

const SimulatedFault *FaultPlan::strikes(FaultKind kind, std::uint64_t number) const
{
    const auto found = std::ranges::find_if(m_faults, [&](const SimulatedFault &fault) {
        const auto count = static_cast<double>(number);
        return fault.kind == kind && (count == fault.at || (kind == FaultKind::Silent && count > fault.at));
    });
    return found == m_faults.end() ? nullptr : &*found;
}

FrameFate FaultPlan::sent()
{
    ++m_sent;
    FrameFate fate{m_sent, strikes(FaultKind::Silent, m_sent) || strikes(FaultKind::Drop, m_sent),
        strikes(FaultKind::Corrupt, m_sent) != nullptr, {}};
    if (const SimulatedFault *late = strikes(FaultKind::Delay, m_sent))
        fate.delay = fromSeconds(late->argument / 1000.0);
    return fate;
}

bool FaultPlan::failsWithPage(int page)
{
    const auto fault = std::ranges::find_if(m_faults, [page](const SimulatedFault &f) {
        return f.kind == FaultKind::PowerPage && f.at == static_cast<double>(page);
    });
    if (fault == m_faults.end())
        return false;
    m_faults.erase(fault);
    return true;
}

void FaultPlan::after(FaultKind kind, Duration later, const std::function<void()> &work)
{
    for (const SimulatedFault &fault : m_faults) {
        if (fault.kind == kind)
            m_timers.emplace_back(m_clock).startIn(fromSeconds(fault.at) + later, work);
    }
}

void FaultPlan::sag(const std::function<void(double volts)> &setVoltage)
{
    at(FaultKind::Brownout, [setVoltage] { setVoltage(brownoutVolts); });
    after(FaultKind::Brownout, brownoutTime, [setVoltage] { setVoltage(nominalVolts); });
}

} // namespace mb
