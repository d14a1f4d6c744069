// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/simulatoroptions.h"

#include "model/motormodel.h"
#include "wire/number.h"

#include <algorithm>
#include <array>

namespace mb::supermodified::simulation {
namespace {

template <class T> bool setNumber(T &out, std::string_view text, T low, T high)
{
    return takeNumber(text, out) && out >= low && out <= high;
}

bool setDialect(UnitOptions &options, std::string_view text)
{
    constexpr std::array<std::string_view, 3> names{"D1", "D2", "D3"};
    const auto *const found = std::find(names.begin(), names.end(), text);
    if (found == names.end())
        return false;
    options.dialect = static_cast<Dialect>(found - names.begin());
    return true;
}

bool setBaudrate(UnitOptions &options, std::string_view text)
{
    int rate = 0;
    const bool good = setNumber(rate, text, slowestRate, fastestRate);
    options.baudrate = rate;
    return good;
}

bool setMotor(UnitOptions &options, std::string_view text)
{
    options.motor = text;
    return motorByName(text) != nullptr;
}

bool setGains(UnitOptions &options, std::string_view text)
{
    options.tuned = text == "tuned";
    return options.tuned || text == "default";
}

bool setHalfPacket(UnitOptions &options, std::string_view text)
{
    options.halfPacket = text == "1";
    return text == "0" || text == "1";
}

bool setHangs(UnitOptions &options, std::string_view text)
{
    options.hangs = text == "1";
    return text == "0" || text == "1";
}

struct Option {
    std::string_view key;
    bool (*set)(UnitOptions &, std::string_view);
};
constexpr std::array optionTable{
    Option{"dialect", setDialect},
    Option{"motor", setMotor},
    Option{"load", [](UnitOptions &o, std::string_view text) { return setNumber(o.load, text, 1.0, 1000.0); }},
    Option{"gains", setGains},
    Option{"baud", setBaudrate},
    Option{"mask", [](UnitOptions &o, std::string_view text) { return setNumber(o.mask, text, 1, 255); }},
    Option{"level", [](UnitOptions &o, std::string_view text) { return setNumber(o.level, text, 0, 1); }},
    Option{"halfpacket", setHalfPacket},
    Option{"hang", setHangs},
    Option{"serial", [](UnitOptions &, std::string_view text) { return !text.empty(); }},
};

} // namespace

Result<UnitOptions> UnitOptions::parse(const SimulatedUnit &unit)
{
    if (unit.address < lowestNode || unit.address > highestNode)
        return fail(Fault::OutOfRange, say("a Supermodified has an id from 1 to 127, not %1", unit.address));
    UnitOptions options;
    options.node = unit.address;
    options.seed = unit.seed;
    options.faults = unit.faults;
    for (const auto &[key, value] : unit.options) {
        const auto *const option = std::find_if(
            optionTable.begin(), optionTable.end(), [&wanted = key](const Option &o) { return o.key == wanted; });
        if (option == optionTable.end())
            return fail(Fault::OutOfRange, say("a simulated Supermodified has no option '%1'", key));
        if (!option->set(options, value))
            return fail(Fault::OutOfRange,
                say("'%1' is no value for the option '%2' of a simulated Supermodified", value, key));
    }
    return options;
}

bool UnitOptions::has(std::string_view fault) const
{
    return std::any_of(faults.begin(), faults.end(), [&](const SimulatedFault &f) { return f.kind == fault; });
}

} // namespace mb::supermodified::simulation
