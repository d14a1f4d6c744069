// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/parameters.h"

#include <QtGlobal>

#include <algorithm>
#include <array>

namespace mb::dmc60c {
namespace {

constexpr double fixedOne = 65536.0;
constexpr double fixedLow = -32768.0;
constexpr double fixedHigh = 2147483647.0 / fixedOne;
constexpr double intLow = -2147483648.0;
constexpr double intHigh = 2147483647.0;
constexpr double uintHigh = 4294967295.0;
constexpr double faultBits = 31.0;
constexpr double greatestCurrent = 100.0; ///< 60 A continuous, 100 A for 2 s: the rating, narrower than the wire

constexpr std::string_view limitSwitches = QT_TRANSLATE_NOOP("table", "Limit switches");
constexpr std::string_view softLimits = QT_TRANSLATE_NOOP("table", "Soft limits");
constexpr std::string_view slot0 = QT_TRANSLATE_NOOP("table", "Loop, slot 0");
constexpr std::string_view slot1 = QT_TRANSLATE_NOOP("table", "Loop, slot 1");
constexpr std::string_view limiter = QT_TRANSLATE_NOOP("table", "Current limiter");
constexpr std::string_view encoder = QT_TRANSLATE_NOOP("table", "Encoder");
constexpr std::string_view faults = QT_TRANSLATE_NOOP("table", "Faults");
constexpr std::string_view currentLimit = QT_TRANSLATE_NOOP("table", "Current limit");
constexpr std::string_view statusFrames = QT_TRANSLATE_NOOP("table", "Status frames");

constexpr std::string_view contactHelp = QT_TRANSLATE_NOOP("table",
    "Normally closed is hit when the switch opens, normally open when it closes. "
    "A hit blocks output in this direction.");
constexpr std::string_view disableHelp
    = QT_TRANSLATE_NOOP("table", "On switches the limit OFF: the sense is the opposite of the soft limits' Enabled.");
constexpr std::string_view pHelp = QT_TRANSLATE_NOOP(
    "table", "Output (32767 = 100 %) per unit of error: counts/100 ms, counts or A, depending on the mode.");
constexpr std::string_view iHelp
    = QT_TRANSLATE_NOOP("table", "Output per unit of error and loop of 500 µs. With F·K = 1 any I overshoots.");
constexpr std::string_view dHelp = QT_TRANSLATE_NOOP(
    "table", "Output per change of error in one loop of 500 µs. One count of noise makes a spike of D.");
constexpr std::string_view zoneHelp
    = QT_TRANSLATE_NOOP("table", "Bound of the integral accumulator, raw integer. 0 means unlimited, not zero.");
constexpr std::string_view fHelp = QT_TRANSLATE_NOOP("table", "Output per unit of set-point, added to P, I and D.");
constexpr std::string_view errorHelp = QT_TRANSLATE_NOOP("table",
    "Below it P, I and D contribute nothing and the integral is cleared; F still "
    "applies. 0 switches the feature off.");
constexpr std::string_view rampHelp = QT_TRANSLATE_NOOP("table",
    "Greatest change of output in a loop of 500 µs; 16 takes 1.024 s from 0 to 100 "
    "%. Lower is slower, but 0 is no ramp.");
constexpr std::string_view maxForwardHelp = QT_TRANSLATE_NOOP("table", "Greatest forward output, 32767 = 100 %.");
constexpr std::string_view maxReverseHelp
    = QT_TRANSLATE_NOOP("table", "Greatest reverse output, −32768 = −100 %. A number at or below 0.");
constexpr std::string_view nominalForwardHelp = QT_TRANSLATE_NOOP(
    "table", "Least forward output outside the allowable error; overcomes friction. Closed-loop modes only.");
constexpr std::string_view nominalReverseHelp = QT_TRANSLATE_NOOP(
    "table", "Least reverse output outside the allowable error, a number at or below 0. Closed-loop modes only.");
constexpr std::string_view levelHelp = QT_TRANSLATE_NOOP(
    "table", "Keeps clearing as long as the switch is active, even if its limit is disabled. Lost at power-off.");
constexpr std::string_view counterHelp
    = QT_TRANSLATE_NOOP("table", "Writing anything but 0 reads the count and clears it.");

// Rows of one wire type differ in little; these say the rest once.
constexpr Parameter toggle(std::string_view key, std::uint16_t id, bool persistent, std::string_view group,
    std::string_view label, std::string_view help)
{
    return {key, id, WireType::Boolean, 1.0, "", 0.0, 1.0, 0.0, Access::ReadWrite, persistent, Nature::Setting, group,
        label, help, {}};
}
constexpr Parameter fixed(std::string_view key, std::uint16_t id, std::string_view unit, double fallback,
    std::string_view group, std::string_view label, std::string_view help)
{
    return {key, id, WireType::Fixed16x16, fixedOne, unit, fixedLow, fixedHigh, fallback, Access::ReadWrite, true,
        Nature::Setting, group, label, help, {}};
}
constexpr Parameter integer(std::string_view key, std::uint16_t id, WireType type, std::string_view unit, double low,
    double high, double fallback, std::string_view group, std::string_view label, std::string_view help)
{
    Parameter row{key, id, type, 1.0, unit, low, high, fallback, Access::ReadWrite, true, Nature::Setting, group, label,
        help, {}};
    row.ofOutput = unit == "throttle";
    return row;
}
constexpr Parameter amperes(
    std::string_view key, std::uint16_t id, double fallback, std::string_view label, std::string_view help)
{
    return as(Role::Limit,
        {key, id, WireType::Fixed16x16, fixedOne, "A", 0.0, greatestCurrent, fallback, Access::ReadWrite, true,
            Nature::Setting, currentLimit, label, help, {}});
}
constexpr Parameter counter(
    std::string_view key, std::uint16_t id, bool persistent, std::string_view label, std::string_view help)
{
    return {key, id, WireType::Uint32, 1.0, "", 0.0, uintHigh, 0.0, Access::ReadWrite, persistent, Nature::Counter,
        faults, label, help, {}};
}
constexpr Parameter period(std::string_view key, std::uint16_t id, double longest, double fallback,
    std::string_view label, std::string_view help)
{
    return {key, id, WireType::Uint32, 1.0, "ms", 1.0, longest, fallback, Access::ReadWrite, false, Nature::Setting,
        statusFrames, label, help, {}};
}
/// Calibrated at the factory for this one. With 0 or less it would measure no current, and limit none.
constexpr Parameter ofUnit(Parameter row)
{
    row.belongsToUnit = true;
    row.minimum = 1.0 / fixedOne;
    return row;
}

// One row per line, whatever its length.
// clang-format off
constexpr std::array<Parameter, 55> table {{
    toggle("limit.forward.switch.normally_closed", 1, true, limitSwitches, QT_TRANSLATE_NOOP("table", "Forward switch is normally closed"), contactHelp),
    as(Role::Limit, inverted(toggle("limit.forward.switch.disabled", 2, true, limitSwitches, QT_TRANSLATE_NOOP("table", "Forward switch disabled"), disableHelp))),
    toggle("limit.reverse.switch.normally_closed", 3, true, limitSwitches, QT_TRANSLATE_NOOP("table", "Reverse switch is normally closed"), contactHelp),
    as(Role::Limit, inverted(toggle("limit.reverse.switch.disabled", 4, true, limitSwitches, QT_TRANSLATE_NOOP("table", "Reverse switch disabled"), disableHelp))),
    as(Role::Limit, integer("limit.forward.soft.threshold", 5, WireType::Int32, "counts", intLow, intHigh, 0.0, softLimits, QT_TRANSLATE_NOOP("table", "Forward soft limit"), QT_TRANSLATE_NOOP("table", "At or above this position forward output is blocked, if enabled."))),
    as(Role::Limit, toggle("limit.forward.soft.enabled", 6, true, softLimits, QT_TRANSLATE_NOOP("table", "Forward soft limit enabled"), QT_TRANSLATE_NOOP("table", "On switches the limit ON: the sense is the opposite of the switches' Disabled."))),
    as(Role::Limit, inverted(integer("limit.reverse.soft.threshold", 7, WireType::Int32, "counts", intLow, intHigh, 0.0, softLimits, QT_TRANSLATE_NOOP("table", "Reverse soft limit"), QT_TRANSLATE_NOOP("table", "At or below this position reverse output is blocked, if enabled.")))),
    as(Role::Limit, toggle("limit.reverse.soft.enabled", 8, true, softLimits, QT_TRANSLATE_NOOP("table", "Reverse soft limit enabled"), QT_TRANSLATE_NOOP("table", "On switches the limit ON: the sense is the opposite of the switches' Disabled."))),
    ofUnit(fixed("current.adc_multiplier", 9, "A/LSB", 2070.0 / fixedOne, limiter, QT_TRANSLATE_NOOP("table", "Current scale"), QT_TRANSLATE_NOOP("table", "Calibrated at the factory. All current limiting depends on it: change it only to trim the reading."))),
    as(Role::Proportional, fixed("slot0.p", 10, "throttle/error", 0.0, slot0, "P", pHelp)),
    as(Role::Integral, fixed("slot0.i", 11, "throttle/error/loop", 0.0, slot0, "I", iHelp)),
    as(Role::Derivative, fixed("slot0.d", 12, "throttle·loop/error", 0.0, slot0, "D", dHelp)),
    as(Role::IntegralZone, integer("slot0.i_zone", 13, WireType::Uint31, "", 0.0, intHigh, 0.0, slot0, QT_TRANSLATE_NOOP("table", "I zone"), zoneHelp)),
    as(Role::FeedForward, fixed("slot0.f", 14, "throttle/set-point", 0.0, slot0, "F", fHelp)),
    as(Role::AllowableError, integer("slot0.allowable_error", 15, WireType::Uint31, "error", 0.0, intHigh, 0.0, slot0, QT_TRANSLATE_NOOP("table", "Allowable error"), errorHelp)),
    as(Role::Ramp, integer("slot0.ramp", 16, WireType::Uint31, "throttle/loop", 0.0, intHigh, 0.0, slot0, QT_TRANSLATE_NOOP("table", "Ramp"), rampHelp)),
    as(Role::MostForward, integer("slot0.max_forward", 17, WireType::Int32, "throttle", 0.0, 32767.0, 32767.0, slot0, QT_TRANSLATE_NOOP("table", "Maximum forward"), maxForwardHelp)),
    as(Role::MostReverse, integer("slot0.max_reverse", 18, WireType::Int32, "throttle", -32768.0, 0.0, -32768.0, slot0, QT_TRANSLATE_NOOP("table", "Maximum reverse"), maxReverseHelp)),
    as(Role::LeastForward, integer("slot0.nominal_forward", 19, WireType::Int32, "throttle", 0.0, 32767.0, 0.0, slot0, QT_TRANSLATE_NOOP("table", "Nominal forward"), nominalForwardHelp)),
    as(Role::LeastReverse, integer("slot0.nominal_reverse", 20, WireType::Int32, "throttle", -32768.0, 0.0, 0.0, slot0, QT_TRANSLATE_NOOP("table", "Nominal reverse"), nominalReverseHelp)),
    as(Role::Proportional, fixed("slot1.p", 21, "throttle/error", 0.0, slot1, "P", pHelp)),
    as(Role::Integral, fixed("slot1.i", 22, "throttle/error/loop", 0.0, slot1, "I", iHelp)),
    as(Role::Derivative, fixed("slot1.d", 23, "throttle·loop/error", 0.0, slot1, "D", dHelp)),
    as(Role::IntegralZone, integer("slot1.i_zone", 24, WireType::Uint31, "", 0.0, intHigh, 0.0, slot1, QT_TRANSLATE_NOOP("table", "I zone"), zoneHelp)),
    as(Role::FeedForward, fixed("slot1.f", 25, "throttle/set-point", 0.0, slot1, "F", fHelp)),
    as(Role::AllowableError, integer("slot1.allowable_error", 26, WireType::Uint31, "error", 0.0, intHigh, 0.0, slot1, QT_TRANSLATE_NOOP("table", "Allowable error"), errorHelp)),
    as(Role::Ramp, integer("slot1.ramp", 27, WireType::Uint31, "throttle/loop", 0.0, intHigh, 0.0, slot1, QT_TRANSLATE_NOOP("table", "Ramp"), rampHelp)),
    as(Role::MostForward, integer("slot1.max_forward", 28, WireType::Int32, "throttle", 0.0, 32767.0, 32767.0, slot1, QT_TRANSLATE_NOOP("table", "Maximum forward"), maxForwardHelp)),
    as(Role::MostReverse, integer("slot1.max_reverse", 29, WireType::Int32, "throttle", -32768.0, 0.0, -32768.0, slot1, QT_TRANSLATE_NOOP("table", "Maximum reverse"), maxReverseHelp)),
    as(Role::LeastForward, integer("slot1.nominal_forward", 30, WireType::Int32, "throttle", 0.0, 32767.0, 0.0, slot1, QT_TRANSLATE_NOOP("table", "Nominal forward"), nominalForwardHelp)),
    as(Role::LeastReverse, integer("slot1.nominal_reverse", 31, WireType::Int32, "throttle", -32768.0, 0.0, 0.0, slot1, QT_TRANSLATE_NOOP("table", "Nominal reverse"), nominalReverseHelp)),
    as(Role::Proportional, fixed("current_limit.p", 32, "throttle/A", 100.0, limiter, "P", QT_TRANSLATE_NOOP("table", "The factory value suits most motors."))),
    as(Role::Integral, fixed("current_limit.i", 33, "throttle/A/loop", 60.0, limiter, "I", QT_TRANSLATE_NOOP("table", "The factory value suits most motors."))),
    as(Role::Derivative, fixed("current_limit.d", 34, "throttle·loop/A", 0.0, limiter, "D", QT_TRANSLATE_NOOP("table", "The factory value suits most motors."))),
    noneAtZero(as(Role::Limit, integer("current_limit.i_zone", 35, WireType::Uint31, "", 0.0, intHigh, 21809288.0, limiter, QT_TRANSLATE_NOOP("table", "I zone"), zoneHelp))),
    as(Role::FeedForward, fixed("current_limit.f", 36, "throttle/A", 0.0, limiter, "F", QT_TRANSLATE_NOOP("table", "The factory value suits most motors."))),
    {"encoder.position", 41, WireType::Int32, 1.0, "counts", intLow, intHigh, 0.0, Access::ReadWrite, false, Nature::Live, encoder, QT_TRANSLATE_NOOP("table", "Position"), QT_TRANSLATE_NOOP("table", "The live count. Written only while the output is off."), {}},
    toggle("encoder.clear_on_index", 42, false, encoder, QT_TRANSLATE_NOOP("table", "Index clears position"), QT_TRANSLATE_NOOP("table", "At the index edge chosen below. Lost at power-off.")),
    toggle("encoder.clear_on_forward_limit", 43, false, encoder, QT_TRANSLATE_NOOP("table", "Forward switch clears position"), levelHelp),
    toggle("encoder.clear_on_reverse_limit", 44, false, encoder, QT_TRANSLATE_NOOP("table", "Reverse switch clears position"), levelHelp),
    toggle("encoder.index_rising", 45, false, encoder, QT_TRANSLATE_NOOP("table", "Index acts on its rising edge"), QT_TRANSLATE_NOOP("table", "Off is the falling edge. Lost at power-off.")),
    {"faults.active", 51, WireType::Flags32, 1.0, "", 0.0, faultBits, 0.0, Access::ReadOnly, false, Nature::Setting, faults, QT_TRANSLATE_NOOP("table", "Present faults"), QT_TRANSLATE_NOOP("table", "1 over-current, 2 over-temperature, 4 under-voltage, 8 gate driver, 16 communication."), {}},
    {"faults.sticky", 52, WireType::Flags32, 1.0, "", 0.0, faultBits, 0.0, Access::ReadWrite, true, Nature::Counter, faults, QT_TRANSLATE_NOOP("table", "Faults since the last clear"), QT_TRANSLATE_NOOP("table", "The bits of the present faults. Writing anything but 0 reads them and clears them."), {}},
    counter("faults.over_current.count", 53, true, QT_TRANSLATE_NOOP("table", "Over-current count"), counterHelp),
    counter("faults.over_temperature.count", 54, true, QT_TRANSLATE_NOOP("table", "Over-temperature count"), counterHelp),
    counter("faults.under_voltage.count", 55, true, QT_TRANSLATE_NOOP("table", "Under-voltage count"), QT_TRANSLATE_NOOP("table", "Supply below 5.75 V for 5 s. Writing anything but 0 reads the count and clears it.")),
    counter("faults.gate_driver.count", 56, true, QT_TRANSLATE_NOOP("table", "Gate driver count"), QT_TRANSLATE_NOOP("table", "Usually a short between M+ and M−. Writing anything but 0 reads the count and clears it.")),
    counter("faults.communication.count", 57, false, QT_TRANSLATE_NOOP("table", "Communication loss count"), QT_TRANSLATE_NOOP("table", "Since the last power-up. Writing anything but 0 reads the count and clears it.")),
    amperes("current_limit.continuous", 61, 40.0, QT_TRANSLATE_NOOP("table", "Continuous limit"), QT_TRANSLATE_NOOP("table", "At or above the peak limit, limiting starts as soon as this is exceeded.")),
    amperes("current_limit.peak", 62, 60.0, QT_TRANSLATE_NOOP("table", "Peak limit"), QT_TRANSLATE_NOOP("table", "Above it for the peak duration, the current is brought down to the continuous limit.")),
    as(Role::Limit, integer("current_limit.peak_duration", 63, WireType::Uint16, "ms", 0.0, 65535.0, 500.0, currentLimit, QT_TRANSLATE_NOOP("table", "Peak duration"), QT_TRANSLATE_NOOP("table", "Time above the peak limit before limiting starts; 0 limits at once."))),
    as(Role::Limit, toggle("current_limit.enabled", 64, true, currentLimit, QT_TRANSLATE_NOOP("table", "Current limit enabled"), QT_TRANSLATE_NOOP("table", "Off is the factory setting: nothing limits the current."))),
    period("status.analog.period", 91, 30000.0, 100.0, QT_TRANSLATE_NOOP("table", "Analog period"), QT_TRANSLATE_NOOP("table", "Milliseconds between frames, although the vendor calls it a rate. Back to 100 at every restart.")),
    period("status.encoder.period", 92, 30000.0, 100.0, QT_TRANSLATE_NOOP("table", "Encoder period"), QT_TRANSLATE_NOOP("table", "Milliseconds between frames, although the vendor calls it a rate. Back to 100 at every restart.")),
    period("status.general.period", 93, 50.0, 10.0, QT_TRANSLATE_NOOP("table", "General period"), QT_TRANSLATE_NOOP("table", "Milliseconds between frames. At most 50, because followers stop after 104 ms without one.")),
}};
// clang-format on

static_assert(checkParameters(table));

} // namespace

std::span<const Parameter> parameterTable()
{
    return table;
}

std::optional<ParameterIndex> parameterWithId(std::uint8_t wireNumber)
{
    const auto *const row = std::ranges::find(table, wireNumber, &Parameter::id);
    if (row == table.end())
        return std::nullopt;
    return ParameterIndex{static_cast<std::uint16_t>(row - table.begin())};
}

} // namespace mb::dmc60c
