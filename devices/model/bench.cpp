// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/bench.h"

#include "async/seconds.h"
#include "async/virtualclock.h"
#include "wire/number.h"

#include <algorithm>

namespace mb {
namespace {

bool serves(const Family &family, LinkKind kind)
{
    return std::ranges::find(family.links, kind) != family.links.end();
}

struct BenchOptions {
    std::uint64_t seed = 1;
    double loss = 0.0;
    int bitrate = 0;
    std::vector<SimulatedFault> faults;
};

Result<BenchOptions> parseOptions(const LinkAddress &address)
{
    BenchOptions options;
    for (const auto &[key, value] : address.options) {
        bool good = false;
        if (key == "seed") {
            good = takeNumber(value, options.seed);
        } else if (key == "loss") {
            good = takeNumber(value, options.loss) && options.loss >= 0.0 && options.loss < 1.0;
        } else if (key == "bitrate") {
            good = takeNumber(value, options.bitrate) && options.bitrate > 0;
        } else if (key == "fault") {
            MB_TRY(auto fault, SimulatedFault::parse(value));
            options.faults.push_back(fault);
            good = true;
        } else {
            return fail(Fault::OutOfRange, say("unknown option '%1' of a simulated link", key),
                say("seed, loss, bitrate and fault are known"));
        }
        if (!good)
            return fail(Fault::OutOfRange, say("link option %1=%2 is out of range", key, value),
                say("seed and bitrate are whole numbers, loss is a fraction below 1"));
    }
    return options;
}

/// Asked on an end that nobody opens, before the unit itself is made.
bool hasFault(const Family &family, SimulatedUnit unit, const SimulatedFault &fault, Link &closed, Clock &clock)
{
    unit.faults = {fault};
    const auto made = family.simulate(closed, clock, unit);
    return made || made.error().fault != Fault::Unsupported;
}

} // namespace

Bench::Bench(LinkAddress address, Clock &outer, std::uint64_t seed)
    : m_address(std::move(address))
    , m_clock(outer)
    , m_seed(seed)
    , m_busOff(m_clock)
{
    m_clock.run(1.0);
}

Result<std::unique_ptr<Bench>> Bench::create(
    const LinkAddress &address, Clock &clock, std::span<const Family *const> families)
{
    MB_TRY(auto options, parseOptions(address));
    if (address.path.empty())
        return fail(Fault::Unsupported, say("sim: stands for several links"), say("name one, such as sim:can"));
    std::unique_ptr<Bench> bench(new Bench(address, clock, options.seed));
    MB_TRY(auto bus, makeSimulatedBus(kindOf(address), bench->m_clock, options.bitrate, options.seed));
    bench->m_bus = std::move(bus);
    bench->m_bus->setLoss(options.loss);
    for (const SimulatedFault &fault : options.faults) {
        if (fault.kind == FaultKind::BusOff)
            bench->m_busOffAt = fault.at;
    }
    std::erase_if(options.faults, [](const SimulatedFault &fault) { return fault.kind == FaultKind::BusOff; });
    MB_TRY_VOID(bench->populate(families, options.faults));
    if (bench->m_simulators.empty())
        return fail(Fault::Unsupported, say("this build simulates no devices on sim:%1", address.path));
    return bench;
}

Result<void> Bench::populate(std::span<const Family *const> families, const std::vector<SimulatedFault> &faults)
{
    std::vector<bool> known(faults.size());
    for (const Family *family : families) {
        if (!serves(*family, kindOf(m_address)) || !family->simulate)
            continue;
        for (const std::string_view text : family->bench) {
            MB_TRY(auto unit, SimulatedUnit::parse(text));
            for (std::size_t i = 0; i < faults.size(); ++i) {
                const auto closed = m_bus->makeEnd(m_address);
                if (!hasFault(*family, unit, faults[i], *closed, m_clock))
                    continue;
                known[i] = true;
                unit.faults.push_back(faults[i]);
            }
            unit.seed = m_seed * 1000 + m_simulators.size();
            MB_TRY_VOID(addUnit(*family, std::move(unit)));
        }
    }
    for (std::size_t i = 0; i < faults.size() && !m_simulators.empty(); ++i) {
        if (!known[i])
            return fail(Fault::OutOfRange,
                say("no device of %1 can have the fault '%2'", m_address.shortName(), toString(faults[i].kind)));
    }
    return {};
}

Result<void> Bench::addUnit(const Family &family, SimulatedUnit unit)
{
    auto link = m_bus->makeEnd(m_address);
    MB_TRY_VOID(link->open());
    MB_TRY(auto simulator, family.simulate(*link, m_clock, unit));
    m_links.push_back(std::move(link));
    m_simulators.push_back(std::move(simulator));
    return {};
}

std::unique_ptr<Link> Bench::hostLink()
{
    auto link = m_bus->makeHost(m_address);
    if (m_busOffAt) {
        const auto at = fromSeconds(*m_busOffAt);
        m_busOff.startIn(at, [this, host = link.get()] { m_bus->dropOut(*host); });
    }
    return link;
}

std::vector<Simulator *> Bench::simulators() const
{
    std::vector<Simulator *> all;
    for (const auto &simulator : m_simulators)
        all.push_back(simulator.get());
    return all;
}

namespace {

bool canHaveFault(LinkAddress link, const std::string &fault, std::span<const Family *const> families)
{
    VirtualClock clock;
    link.options = {{"fault", fault}};
    return Bench::create(link, clock, families).has_value();
}

/// A fault goes to those of the links that can have it. One that none can have goes to all, to be refused there.
void shareOut(const std::string &fault, std::vector<LinkAddress> &links, std::span<const Family *const> families)
{
    std::vector<LinkAddress *> without;
    for (LinkAddress &link : links) {
        if (!canHaveFault(link, fault, families))
            without.push_back(&link);
    }
    if (without.size() == links.size())
        return;
    for (LinkAddress *const link : without)
        std::erase(link->options, std::pair<std::string, std::string>("fault", fault));
}

} // namespace

std::vector<LinkAddress> expandLink(const LinkAddress &address, std::span<const Family *const> families)
{
    if (!address.isSimulated() || !address.path.empty())
        return {address};
    std::vector<LinkAddress> all;
    for (const LinkKind kind : {LinkKind::Can, LinkKind::Serial, LinkKind::Spi}) {
        const bool any
            = std::ranges::any_of(families, [kind](const Family *f) { return !f->bench.empty() && serves(*f, kind); });
        if (any)
            all.push_back({address.scheme, std::string(toString(kind)), address.options});
    }
    for (const auto &[key, value] : address.options) {
        if (key == "fault")
            shareOut(value, all, families);
    }
    return all;
}

} // namespace mb
