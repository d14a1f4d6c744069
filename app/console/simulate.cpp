// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/ending.h"
#include "app/console/simulatedunits.h"
#include "app/console/target.h"
#include "app/console/verb.h"
#include "simulation/simulatedbus.h"
#include "transport/backends/ptyline.h"
#include "transport/backends/unixspiserver.h"

#include <algorithm>
#include <memory>

namespace mb::console {
namespace {

struct SimulateArguments {
    std::vector<std::vector<std::string>> on; ///< each: a link, then its devices
    std::string seed;
    std::string seconds;
    bool events = false;
};

struct SimulatePlan {
    std::vector<LinkAddress> links;
    std::vector<PlannedUnit> units;
    std::optional<Duration> time;
};

Result<PlannedUnit> parseUnit(Console &console, const LinkAddress &link, const std::string &text)
{
    MB_TRY(auto unit, SimulatedUnit::parse(text));
    MB_TRY(const auto family, parseFamily(console.families(), unit.family));
    const auto &kinds = family->links;
    if (!family->simulate || std::ranges::find(kinds, kindOf(link)) == kinds.end())
        return fail(Fault::Usage, say("%1 cannot be simulated on %2", unit.family, link.text()),
            say("name a link of the kind %1", toString(kinds.front())));
    return PlannedUnit{link, std::move(unit), family};
}

/// Makes the unit once on a bus in memory: what it does not understand is told before a real link is opened.
Result<void> rehearse(Console &console, const PlannedUnit &unit)
{
    MB_TRY(const auto bus, makeSimulatedBus(kindOf(unit.link), console.clock(), 0, 1));
    const auto end = bus->makeEnd(unit.link);
    const auto simulator = unit.family->simulate(*end, console.clock(), unit.unit);
    return simulator ? Result<void>() : fail(simulator.error());
}

Result<void> addGroup(Console &console, const std::vector<std::string> &group, std::uint64_t seed, SimulatePlan &plan)
{
    MB_TRY(const auto link, LinkAddress::parse(group.front()));
    if (link.isSimulated())
        return fail(Fault::Usage, say("--on needs a real link, and %1 lives inside one program", link.text()),
            say("use it directly"));
    if (link.scheme == "unix")
        MB_TRY_VOID(UnixSpiServer::create(link, console.clock()));
    if (group.size() < 2)
        return fail(Fault::Usage, say("--on %1 names no device", link.text()), say("add one such as dmc60c:5"));
    if (link.scheme == "pty")
        MB_TRY_VOID(PtyLine::create(link, console.clock()));
    const bool isTwice = std::ranges::any_of(plan.links,
        [&link](const LinkAddress &other) { return other.scheme == link.scheme && other.path == link.path; });
    if (link.scheme == "unix" && (group.size() > 2 || isTwice))
        return fail(Fault::Usage, say("%1 carries one board", link.text()), say("give each its own path"));
    if (link.scheme == "pty" && isTwice)
        return fail(
            Fault::Usage, say("%1 is named twice", link.text()), say("put all nodes of a line behind one --on"));
    plan.links.push_back(link);
    for (std::size_t i = 1; i < group.size(); ++i) {
        MB_TRY(auto unit, parseUnit(console, link, group[i]));
        unit.unit.seed = seed * 1000 + plan.units.size();
        MB_TRY_VOID(rehearse(console, unit));
        plan.units.push_back(std::move(unit));
    }
    return {};
}

Result<SimulatePlan> check(Console &console, const SimulateArguments &arguments)
{
    MB_TRY(const auto seed, integerOr(1, "--seed", arguments.seed, 0, 1'000'000'000));
    MB_TRY(const auto time, parseSpan(arguments.seconds));
    SimulatePlan plan;
    plan.time = time;
    for (const auto &group : arguments.on)
        MB_TRY_VOID(addGroup(console, group, static_cast<std::uint64_t>(seed), plan));
    return plan;
}

Task<int> simulate(Console &console, SimulateArguments arguments)
{
    const auto plan = co_await check(console, arguments);
    Ending ending(console);
    SimulatedUnits units(console, arguments.events);
    for (const PlannedUnit &unit : plan.units)
        co_await units.add(unit);
    units.watch(ending);
    console.out().json({{QStringLiteral("ready"), true}, {QStringLiteral("links"), units.links()}});
    console.out().flush();
    ending.after(plan.time);
    co_await ending.wait();
    if (ending.cause() == Ending::Cause::LinkLost)
        co_return fail(ending.loss());
    co_return exitDone;
}

} // namespace

Job declareSimulate(CLI::App &arguments)
{
    const auto a = std::make_shared<SimulateArguments>();
    arguments
        .add_option("--on", a->on,
            "A link, then the devices on it, such as socketcan:vcan0 dmc60c:5,motor=cim or pty:./tty0 FAMILY:4; all "
            "have motor=, load= and fault=; what else a family has stands in docs/bench.md")
        ->required();
    arguments.add_option("--seed", a->seed, "Of everything random; 1 by default");
    arguments.add_option("--for", a->seconds, "Seconds; until a signal otherwise");
    arguments.add_flag("--events", a->events, "Print what happens in the simulated devices (always with --json)");
    return [a](Console &console) { return simulate(console, *a); };
}

} // namespace mb::console
