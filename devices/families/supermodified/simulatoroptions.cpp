// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/simulatoroptions.h"

#include "simulation/simulatoroptions.h"

#include <array>

namespace mb::supermodified::simulation {
namespace {

using Option = SimulatorOption<UnitOptions>;

constexpr std::array<std::pair<std::string_view, Dialect>, 3> dialects{
    {{"D1", Dialect::D1}, {"D2", Dialect::D2}, {"D3", Dialect::D3}}};
constexpr std::array<std::pair<std::string_view, bool>, 2> gains{{{"default", false}, {"tuned", true}}};
constexpr std::array<std::pair<std::string_view, bool>, 2> flags{{{"0", false}, {"1", true}}};

bool setBaudrate(UnitOptions &options, std::string_view text)
{
    int rate = 0;
    const bool good = takeWithin<int>(text, slowestRate, fastestRate, rate);
    options.baudrate = rate;
    return good;
}

constexpr std::array optionTable{
    Option{"dialect", [](UnitOptions &o, std::string_view text) { return takeWord(text, dialects, o.dialect); }},
    Option{"motor", [](UnitOptions &o, std::string_view text) { return takeMotor(text, o.motor); }},
    Option{"load", [](UnitOptions &o, std::string_view text) { return takeLoad(text, o.load); }},
    Option{"gains", [](UnitOptions &o, std::string_view text) { return takeWord(text, gains, o.tuned); }},
    Option{"baud", setBaudrate},
    Option{"mask", [](UnitOptions &o, std::string_view text) { return takeWithin(text, 1, 255, o.mask); }},
    Option{"level", [](UnitOptions &o, std::string_view text) { return takeWithin(text, 0, 1, o.level); }},
    Option{"halfpacket", [](UnitOptions &o, std::string_view text) { return takeWord(text, flags, o.halfPacket); }},
    Option{"hang", [](UnitOptions &o, std::string_view text) { return takeWord(text, flags, o.hangs); }},
    Option{"serial", [](UnitOptions &, std::string_view text) { return !text.empty(); }},
};

} // namespace

Result<UnitOptions> UnitOptions::parse(const SimulatedUnit &unit)
{
    if (unit.address < lowestNode || unit.address > highestNode)
        return fail(Fault::OutOfRange, say("a Supermodified has an id from 1 to 127, not %1", unit.address));
    UnitOptions options;
    options.node = unit.address;
    MB_TRY_VOID(takeOptions(unit, say("a simulated Supermodified"), optionTable, {FaultKind::Duplicate}, options));
    return options;
}

} // namespace mb::supermodified::simulation
