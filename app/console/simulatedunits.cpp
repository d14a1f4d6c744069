// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/simulatedunits.h"

#include "app/console/target.h"
#include "model/family.h"
#include "transport/backends/unixspiserver.h"
#include "transport/linkcatalog.h"

#include <algorithm>

namespace mb::console {
namespace {

QJsonObject gainsOf(const Simulator &simulator, const Family &family)
{
    QJsonObject gains;
    for (const Parameter &parameter : family.parameters) {
        if (const auto raw = simulator.gain(parameter.key))
            gains.insert(qt(parameter.key), static_cast<double>(*raw));
    }
    return gains;
}

} // namespace

SimulatedUnits::SimulatedUnits(Console &console, bool events)
    : m_console(console)
    , m_events(events || console.json())
{
}

Result<void> SimulatedUnits::add(const PlannedUnit &unit)
{
    MB_TRY(const auto end, endOf(unit.link));
    MB_TRY(auto simulator, unit.family->simulate(*end, m_console.clock(), unit.unit));
    m_units.push_back({std::move(simulator), {}});
    Running &running = m_units.back();
    std::vector<std::string> served = running.simulator->otherLinks();
    served.insert(served.begin(), unit.link.text());
    for (const std::string &link : served) {
        if (!m_links.contains(qt(link)))
            m_links.append(qt(link));
    }
    if (m_events)
        running.events = running.simulator->events().add(
            [this, &link = *end, &running, family = unit.family](
                const SimulatorEvent &event) { print(link, *running.simulator, *family, event); });
    return {};
}

Result<Link *> SimulatedUnits::endOf(const LinkAddress &address)
{
    if (address.scheme == "serial") {
        const auto same = [&address](const auto &end) { return end->address() == address; };
        if (const auto known = std::ranges::find_if(m_ends, same); known != m_ends.end())
            return known->get();
    }
    MB_TRY(auto end, makeEnd(address));
    MB_TRY_VOID(end->open());
    m_ends.push_back(std::move(end));
    return m_ends.back().get();
}

Result<std::unique_ptr<Link>> SimulatedUnits::makeEnd(const LinkAddress &address)
{
    if (address.scheme == "unix")
        return UnixSpiServer::create(address, m_console.clock());
    if (address.scheme != "pty")
        return createLink(address, m_console.clock());
    const auto same = [&address](const Terminal &terminal) { return terminal.address == address; };
    auto terminal = std::ranges::find_if(m_terminals, same);
    if (terminal == m_terminals.end()) {
        MB_TRY(auto line, PtyLine::create(address, m_console.clock()));
        MB_TRY_VOID(line->open());
        terminal = m_terminals.insert(m_terminals.end(), {address, std::move(line)});
    }
    return terminal->line->makeEnd();
}

void SimulatedUnits::watch(Ending &ending)
{
    for (const auto &end : m_ends)
        ending.watch(*end);
}

void SimulatedUnits::print(
    const Link &link, const Simulator &simulator, const Family &family, const SimulatorEvent &event)
{
    const TimeOrigin base(m_console.clock(), link.address());
    QJsonObject row{
        {QStringLiteral("t"), base.seconds(event.time)},
        {QStringLiteral("link"), qt(link.address().text())},
        {QStringLiteral("device"), qt(simulator.name())},
        {QStringLiteral("event"), qt(event.what)},
        {QStringLiteral("value"), event.value},
    };
    if (event.what == "gains-written")
        row.insert(QStringLiteral("gains"), gainsOf(simulator, family));
    m_console.out().json(row);
}

} // namespace mb::console
