// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/simulatoroptions.h"

#include "simulation/faultplan.h"
#include "simulation/simulatoroptions.h"

#include <array>

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

bool setProduct(UnitOptions &options, std::string_view text)
{
    const auto product = wholeFrom<std::uint32_t>(text, 16);
    options.product = product.value_or(0);
    return product && *product > 0 && *product <= 0xFFFU;
}

bool setText(std::string &out, std::string_view text, std::size_t longest)
{
    out = text;
    return !text.empty() && text.size() <= longest;
}

using Option = SimulatorOption<UnitOptions>;

constexpr std::array<std::pair<std::string_view, CrcVariant>, 3> crcs{
    {{"A", CrcVariant::A}, {"B", CrcVariant::B}, {"C", CrcVariant::C}}};
constexpr std::array<std::pair<std::string_view, bool>, 2> states{{{"application", false}, {"bootloader", true}}};
constexpr std::array<std::pair<std::string_view, bool>, 2> buttons{{{"brake", true}, {"coast", false}}};
constexpr std::array<std::pair<std::string_view, VelocityWindow>, 2> windows{
    {{"rolling", VelocityWindow::Rolling}, {"block", VelocityWindow::Block}}};
constexpr std::array<std::pair<std::string_view, StoredGains>, 3> gains{
    {{"default", StoredGains::Default}, {"tuned", StoredGains::Tuned}, {"overshoot", StoredGains::Overshoot}}};

constexpr std::array optionTable{
    Option{"motor", [](UnitOptions &o, std::string_view text) { return takeMotor(text, o.motor); }},
    Option{"load", [](UnitOptions &o, std::string_view text) { return takeLoad(text, o.load); }},
    Option{"serial", [](UnitOptions &o, std::string_view text) { return setText(o.serial, text, 12); }},
    Option{"session", setSession},
    Option{"name", [](UnitOptions &o, std::string_view text) { return setText(o.name, text, maxNameLength); }},
    Option{"firmware", setFirmware},
    Option{"product", setProduct},
    Option{"state", [](UnitOptions &o, std::string_view text) { return takeWord(text, states, o.inBootloader); }},
    Option{"crc", [](UnitOptions &o, std::string_view text) { return takeWord(text, crcs, o.crc); }},
    Option{"button", [](UnitOptions &o, std::string_view text) { return takeWord(text, buttons, o.brake); }},
    Option{"velocity", [](UnitOptions &o, std::string_view text) { return takeWord(text, windows, o.velocity); }},
    Option{"gains", [](UnitOptions &o, std::string_view text) { return takeWord(text, gains, o.gains); }},
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
    options.serial = defaultSerial(unit.seed, unit.address);
    options.load = usualLoad(unit.option("motor").value_or("cim"));
    if (auto taken = takeOptions(unit, say("a simulated DMC60C"), optionTable,
            {FaultKind::PowerPage, FaultKind::BusOff, FaultKind::Duplicate}, options);
        !taken)
        return fail(taken.error());
    const SimulatedFault *page = findFault(options.faults, FaultKind::PowerPage);
    if (page && page->at > lastPage)
        return fail(Fault::OutOfRange, say("fault '%1' does not parse", "power-page"),
            say("legal is %1", "0 … " + std::to_string(lastPage)));
    return options;
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
