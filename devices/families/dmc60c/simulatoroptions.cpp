// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/simulatoroptions.h"

#include "wire/number.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mb::dmc60c::simulation {
namespace {

bool setSession(UnitOptions &options, std::string_view text)
{
    const bool hex = text.starts_with("0x");
    options.session = wholeFrom<std::uint16_t>(hex ? text.substr(2) : text, hex ? 16 : 10);
    return options.session.value_or(0) != 0;
}

bool setFirmware(UnitOptions &options, std::string_view text)
{
    const auto dot = text.find('.');
    if (dot == std::string_view::npos)
        return false;
    const auto major = wholeFrom<std::uint8_t>(text.substr(0, dot));
    const auto minor = wholeFrom<std::uint8_t>(text.substr(dot + 1));
    if (!major || !minor)
        return false;
    options.firmware = static_cast<std::uint16_t>(*major << 8 | *minor);
    return options.firmware != noApplication;
}

bool setLoad(UnitOptions &options, std::string_view text)
{
    return takeNumber(text, options.load) && options.load >= 1.0 && options.load <= 1000.0;
}

bool setText(std::string &out, std::string_view text, std::size_t longest)
{
    out = text;
    return !text.empty() && text.size() <= longest;
}

template <class T, std::size_t N>
bool choose(T &out, std::string_view text, const std::array<std::pair<std::string_view, T>, N> &choices)
{
    const auto found
        = std::find_if(choices.begin(), choices.end(), [&](const auto &choice) { return choice.first == text; });
    if (found == choices.end())
        return false;
    out = found->second;
    return true;
}

using Setter = bool (*)(UnitOptions &, std::string_view);
struct Option {
    std::string_view key;
    Setter set;
};

constexpr std::array<std::pair<std::string_view, CrcVariant>, 3> crcs{
    {{"A", CrcVariant::A}, {"B", CrcVariant::B}, {"C", CrcVariant::C}}};
constexpr std::array<std::pair<std::string_view, bool>, 2> states{{{"application", false}, {"bootloader", true}}};
constexpr std::array<std::pair<std::string_view, VelocityWindow>, 2> windows{
    {{"rolling", VelocityWindow::Rolling}, {"block", VelocityWindow::Block}}};
constexpr std::array<std::pair<std::string_view, StoredGains>, 3> gains{
    {{"default", StoredGains::Default}, {"tuned", StoredGains::Tuned}, {"overshoot", StoredGains::Overshoot}}};

constexpr std::array optionTable{
    Option{"motor",
        [](UnitOptions &o, std::string_view text) {
            o.motor = text;
            return motorByName(text) != nullptr;
        }},
    Option{"load", setLoad},
    Option{"serial", [](UnitOptions &o, std::string_view text) { return setText(o.serial, text, 12); }},
    Option{"session", setSession},
    Option{"name", [](UnitOptions &o, std::string_view text) { return setText(o.name, text, maxNameLength); }},
    Option{"firmware", setFirmware},
    Option{"state", [](UnitOptions &o, std::string_view text) { return choose(o.inBootloader, text, states); }},
    Option{"crc", [](UnitOptions &o, std::string_view text) { return choose(o.crc, text, crcs); }},
    Option{"velocity", [](UnitOptions &o, std::string_view text) { return choose(o.velocity, text, windows); }},
    Option{"gains", [](UnitOptions &o, std::string_view text) { return choose(o.gains, text, gains); }},
};

std::string defaultSerial(std::uint64_t seed, int number)
{
    constexpr std::string_view digits = "0123456789ABCDEF";
    std::uint64_t mixed = (seed * 64U + static_cast<std::uint64_t>(number)) * std::uint64_t{0x9E3779B97F4A7C15};
    std::string text = "210334";
    for (int i = 0; i < 6; ++i, mixed >>= 5U)
        text += digits[(mixed >> 32U) & 15U];
    return text;
}

double usualLoad(std::string_view motor)
{
    if (motor == "cim")
        return 9.0;
    return motor == "775pro" ? 7.0 : 5.0;
}

} // namespace

Result<UnitOptions> UnitOptions::parse(const SimulatedUnit &unit)
{
    if (unit.address < 0 || unit.address > maxDeviceNumber)
        return fail(Fault::OutOfRange, say("a DMC60C has a number from 0 to 63, not %1", unit.address));
    UnitOptions options;
    options.number = unit.address;
    options.seed = unit.seed;
    options.faults = unit.faults;
    options.serial = defaultSerial(unit.seed, unit.address);
    options.load = usualLoad(unit.option("motor").value_or("cim"));
    for (const auto &[key, value] : unit.options) {
        const auto option = std::find_if(
            optionTable.begin(), optionTable.end(), [&wanted = key](const Option &o) { return o.key == wanted; });
        if (option == optionTable.end())
            return fail(Fault::OutOfRange, say("a simulated DMC60C has no option '%1'", key));
        if (!option->set(options, value))
            return fail(
                Fault::OutOfRange, say("'%1' is no value for the option '%2' of a simulated DMC60C", value, key));
    }
    return options;
}

bool UnitOptions::has(std::string_view fault) const
{
    return std::any_of(faults.begin(), faults.end(), [&](const SimulatedFault &f) { return f.kind == fault; });
}

UnitOptions UnitOptions::twin() const
{
    UnitOptions other = *this;
    other.seed = seed ^ 0x5DEECE66DULL;
    other.serial = defaultSerial(other.seed, number);
    if (session)
        other.session = static_cast<std::uint16_t>(*session == 0xFFFFU ? 1 : *session + 1);
    return other;
}

} // namespace mb::dmc60c::simulation
