// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/motormodel.h"
#include "simulation/simulator.h"
#include "wire/number.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string>

namespace mb {

/// Options of simulated units (`FAMILY:ADDRESS,key=value…`): a family lists its own as a table of these, each with what takes
/// its value into the family's struct.
template <class Options> struct SimulatorOption {
    std::string_view key;
    bool (*set)(Options &, std::string_view value); ///< false: the value is none
};

/// Faults that every unit can have.
constexpr std::array commonFaults{FaultKind::Drop, FaultKind::Corrupt, FaultKind::Delay, FaultKind::Silent,
    FaultKind::Power, FaultKind::Reset, FaultKind::EncoderDead, FaultKind::EncoderReversed, FaultKind::Brownout,
    FaultKind::Stall};

[[nodiscard]] inline Message whereOptionsStand()
{
    return say("docs/bench.md has the options of each family, and what they take");
}

/// Options, seed and faults of `unit`. OutOfRange for a key that is in no row of `table` and for a value that its row refuses,
/// Unsupported for a fault that is neither common nor in `ownFaults`; `what` is "a simulated …".
template <class Options, std::size_t N>
[[nodiscard]] Result<void> takeOptions(const SimulatedUnit &unit, const Message &what,
    const std::array<SimulatorOption<Options>, N> &table, std::initializer_list<FaultKind> ownFaults, Options &options)
{
    options.seed = unit.seed;
    options.faults = unit.faults;
    for (const auto &[key, value] : unit.options) {
        const auto row = std::ranges::find_if(
            table, [&wanted = key](const SimulatorOption<Options> &option) { return option.key == wanted; });
        if (row == table.end())
            return fail(Fault::OutOfRange, say("%1 has no option '%2'", what, key), whereOptionsStand());
        if (!row->set(options, value))
            return fail(Fault::OutOfRange, say("'%1' is no value for the option '%2' of %3", value, key, what),
                whereOptionsStand());
    }
    const auto isIn = [](const auto &kinds, FaultKind kind) { return std::ranges::find(kinds, kind) != kinds.end(); };
    for (const SimulatedFault &fault : unit.faults) {
        if (!isIn(commonFaults, fault.kind) && !isIn(ownFaults, fault.kind))
            return fail(Fault::Unsupported,
                say("%1 has no option '%2'", what, "fault=" + std::string(toString(fault.kind))), whereOptionsStand());
    }
    return {};
}

/// A number from `low` to `high`; `out` stays as it is otherwise.
template <class Number> [[nodiscard]] bool takeWithin(std::string_view text, Number low, Number high, Number &out)
{
    Number number{};
    if (!takeNumber(text, number) || number < low || number > high)
        return false;
    out = number;
    return true;
}

/// How much heavier than its rotor a motor's load is (`load=`).
[[nodiscard]] inline bool takeLoad(std::string_view text, double &out)
{
    return takeWithin(text, 1.0, 1000.0, out);
}

/// The name of a motor (`motor=`).
[[nodiscard]] inline bool takeMotor(std::string_view text, std::string &out)
{
    out = text;
    return motorByName(text) != nullptr;
}

/// One of several words; `out` stays as it is otherwise.
template <class T, std::size_t N>
[[nodiscard]] bool takeWord(std::string_view text, const std::array<std::pair<std::string_view, T>, N> &words, T &out)
{
    const auto found = std::ranges::find_if(words, [&](const auto &entry) { return entry.first == text; });
    if (found == words.end())
        return false;
    out = found->second;
    return true;
}

} // namespace mb
