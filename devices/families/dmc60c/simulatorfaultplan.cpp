// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/simulatorfaultplan.h"

#include <algorithm>
#include <utility>

namespace mb::dmc60c::simulation {
namespace {

constexpr auto busOffTime = std::chrono::milliseconds(100);
constexpr double brownoutVolts = 5.0;
constexpr double brownoutSeconds = 6.0;
constexpr double nominalVolts = 12.0;

} // namespace

FaultPlan::FaultPlan(Clock &clock, std::vector<SimulatedFault> faults, Actions actions)
    : m_clock(clock)
    , m_faults(std::move(faults))
    , m_actions(std::move(actions))
    , m_busOff(clock)
{
    for (const SimulatedFault &fault : m_faults)
        schedule(fault);
}

void FaultPlan::schedule(const SimulatedFault &fault)
{
    if (fault.kind == "reset") {
        at(fault.at, m_actions.reset);
    } else if (fault.kind == "busoff") {
        at(fault.at, [this] {
            m_actions.loseBus();
            m_busOff.startIn(busOffTime, [] {});
        });
    } else if (fault.kind == "encoder-dead") {
        at(fault.at, m_actions.killEncoder);
    } else if (fault.kind == "brownout") {
        at(fault.at, [this] { m_actions.disturb("bus-voltage", brownoutVolts); });
        at(fault.at + brownoutSeconds, [this] { m_actions.disturb("bus-voltage", nominalVolts); });
    } else if (fault.kind == "stall") {
        at(fault.at, [this] { m_actions.disturb("stall", 1.0); });
    }
}

void FaultPlan::at(double seconds, std::function<void()> work)
{
    const auto delay = std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds));
    m_timers.push_back(std::make_unique<Timer>(m_clock));
    m_timers.back()->startIn(delay, std::move(work));
}

bool FaultPlan::powerFailsWithFrame()
{
    ++m_addressed;
    return std::any_of(m_faults.begin(), m_faults.end(),
        [this](const SimulatedFault &f) { return f.kind == "power" && f.at == static_cast<double>(m_addressed); });
}

bool FaultPlan::powerFailsWithPage(int page)
{
    const auto fault = std::find_if(m_faults.begin(), m_faults.end(),
        [page](const SimulatedFault &f) { return f.kind == "power-page" && static_cast<int>(f.at) == page; });
    if (fault == m_faults.end())
        return false;
    m_faults.erase(fault);
    return true;
}

} // namespace mb::dmc60c::simulation
