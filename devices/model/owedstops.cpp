// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/owedstops.h"

#include "model/family.h"

#include <algorithm>
#include <string_view>

namespace mb {
namespace {

/// "abstractdc:3" of "socketcan:can0/abstractdc:3": the name of an interface may change, the device on the line does not.
std::string_view unitOf(std::string_view selector)
{
    return selector.substr(selector.rfind('/') + 1);
}

bool isSameUnit(const OwedStop &owed, std::string_view line, std::string_view selector)
{
    return owed.line == line && unitOf(owed.device) == unitOf(selector);
}

} // namespace

void OwedStops::pay(Link &link, const std::string &line)
{
    if (m_guard) {
        for (OwedStop &owed : m_guard->takeOver(link, m_clock.now())) {
            const bool known = std::any_of(m_owed.begin(), m_owed.end(),
                [&owed](const OwedStop &other) { return isSameUnit(other, owed.line, owed.device); });
            if (!known)
                m_owed.push_back(std::move(owed));
        }
    }
    std::erase_if(m_owed, [this](const OwedStop &owed) { return m_clock.now() - owed.since >= DeviceStop::debtLimit; });
    for (const OwedStop &owed : m_owed) {
        if (owed.line == line)
            sendScript(link, owed.script);
    }
}

void OwedStops::add(Device &device, const std::string &line)
{
    const DeviceStop &stop = device.stopping();
    if (!stop.isDue() || !stop.isForMotion() || device.link().address().isSimulated())
        return;
    if (const StopScript script = device.stopScript(); !script.isEmpty() && !device.family().capabilities.watchdog)
        m_owed.push_back({line, device.selector(), script, m_clock.now()});
}

void OwedStops::passTo(Device &device, const std::string &line)
{
    if (!device.mayStop())
        return;
    const auto owed = std::find_if(m_owed.begin(), m_owed.end(),
        [&](const OwedStop &known) { return isSameUnit(known, line, device.selector()); });
    if (owed == m_owed.end())
        return;
    m_owed.erase(owed);
    device.stopping().inherit();
}

void OwedStops::settle(const Device &device, const std::string &line)
{
    if (m_guard)
        m_guard->settle(line, device.selector());
}

void OwedStops::leave(const std::string &line)
{
    if (m_guard)
        m_guard->leave(line);
}

void OwedStops::dismiss()
{
    for (const OwedStop &owed : m_owed) {
        if (m_guard)
            m_guard->settle(owed.line, owed.device);
    }
    m_owed.clear();
}

} // namespace mb
