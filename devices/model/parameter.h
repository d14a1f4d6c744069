// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"
#include "wire/number.h"

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace mb {

/// How a value travels. The codec of a family has one function per wire type, never one per parameter.
enum class WireType : std::uint8_t {
    Boolean,
    Int16,
    Int32,
    Uint8,
    Uint16,
    Uint31,
    Uint32,
    Fixed16x16,
    Flags32,
    Flags64
};

struct RawRange {
    std::int64_t low = 0;
    std::int64_t high = 0;
};

[[nodiscard]] constexpr RawRange rangeOf(WireType type)
{
    switch (type) {
    case WireType::Boolean: return {0, 1};
    case WireType::Int16: return {-32768, 32767};
    case WireType::Int32: return {-2147483648LL, 2147483647LL};
    case WireType::Uint8: return {0, 255};
    case WireType::Uint16: return {0, 65535};
    case WireType::Uint31: return {0, 2147483647LL};
    case WireType::Uint32: return {0, 4294967295LL};
    case WireType::Fixed16x16: return {-2147483648LL, 2147483647LL};
    case WireType::Flags32: return {0, 4294967295LL};
    case WireType::Flags64: return {0, std::int64_t{1} << 53}; // what a JSON number holds exactly
    }
    return {};
}

enum class Access : std::uint8_t { ReadOnly, ReadWrite, WriteOnly };

/// What is special about a parameter, for everybody who must not treat it like a setting.
enum class Nature : std::uint8_t {
    Setting,
    Live,    ///< moves by itself: a read-back may differ from what was written, and it is never restored from a file
    Counter, ///< reading it through a write clears it; never verified, never restored from a file
};

/// What a parameter does to a motion, for what must know it without knowing the family: the order of writing, a leap that is
/// asked about, what gains mean and are made of. Nobody knows one by its key.
enum class Role : std::uint8_t {
    None,
    Proportional, ///< P, I, D, F: gains of a loop (TrialTraits::loops)
    Integral,
    Derivative,
    FeedForward,
    Divisor,        ///< what the gains of its loop are divided by
    IntegralLimit,  ///< greatest output that the integral of its loop may make
    IntegralZone,   ///< bounds the sum of errors itself; 0: nothing does
    LeastForward,   ///< least output of its loop, forward: overcomes friction
    LeastReverse,   ///< the same, reverse: a number at or below 0
    AllowableError, ///< error below which its loop does nothing
    Ramp,           ///< greatest change of output in a period of its loop; 0: none
    Limit,          ///< bounds what a motor may do, whichever loop drives it; a boolean switches such a bound
    MostForward,    ///< such a limit: of the output of its loop, forward
    MostReverse,    ///< the same, reverse: a number at or below 0
    PowerLimit,     ///< such a limit: of the power that its motor gets at most
};

struct Choice {
    std::int64_t raw = 0;
    std::string_view label;
};

/// Position in the table of a family; not the number on the wire.
struct ParameterIndex {
    std::uint16_t value = 0;
    friend auto operator<=>(const ParameterIndex &, const ParameterIndex &) = default;
};

struct ParameterChange {
    ParameterIndex index;
    std::int64_t raw = 0;
};

/// One row of a family's table. Numbers are in `unit`; the raw value on the wire is `number * one`.
struct Parameter {
    std::string_view key; ///< stable, released keys never change
    std::uint16_t id = 0; ///< number on the wire
    WireType type = WireType::Int32;
    double one = 1.0;      ///< raw value of 1.0: 65536 for 16.16
    std::string_view unit; ///< empty for a bare number
    double minimum = 0.0;
    double maximum = 0.0;
    double fallback = 0.0; ///< the data sheet's default
    Access access = Access::ReadWrite;
    bool persistent = false; ///< survives a power cycle once stored
    Nature nature = Nature::Setting;
    std::string_view group; ///< English; widgets translate it
    std::string_view label;
    std::string_view help;
    std::span<const Choice> choices{};
    bool belongsToUnit
        = false; ///< tells one unit from another, or was calibrated for it: not copied to another unit unasked
    bool afterRestart = false; ///< what is written is in force after the next power cycle only, and so not compared
    Role role = Role::None;
    bool inverted = false;   ///< of a limit: a boolean switches it off when on, a position is wider the lower it is
    bool ofOutput = false;   ///< a part of the whole output, which is its wider bound
    bool zeroIsNone = false; ///< of a limit that is an amount: 0 is no limit, not the tightest
};

[[nodiscard]] constexpr bool isGain(Role role)
{
    return role >= Role::Proportional && role <= Role::FeedForward;
}
[[nodiscard]] constexpr bool isGain(const Parameter &parameter)
{
    return isGain(parameter.role);
}
[[nodiscard]] constexpr bool isLimit(const Parameter &parameter)
{
    return parameter.role >= Role::Limit;
}

/// For tables: the row with this role.
[[nodiscard]] constexpr Parameter as(Role role, Parameter row)
{
    row.role = role;
    return row;
}
/// For tables: a switch that is on while its limit is off, a position that nothing drives below.
[[nodiscard]] constexpr Parameter inverted(Parameter row)
{
    row.inverted = true;
    return row;
}

/// For tables: a limit that is off at 0.
[[nodiscard]] constexpr Parameter noneAtZero(Parameter row)
{
    row.zeroIsNone = true;
    return row;
}

/// A row has names, a default inside its range, and a range that its wire type can carry.
consteval bool checkParameter(const Parameter &p)
{
    const RawRange wire = rangeOf(p.type);
    const bool named = !p.key.empty() && !p.label.empty() && !p.group.empty() && p.one > 0.0;
    const bool ordered = p.minimum <= p.maximum && p.fallback >= p.minimum && p.fallback <= p.maximum;
    return named && ordered && p.minimum * p.one >= static_cast<double>(wire.low)
        && p.maximum * p.one <= static_cast<double>(wire.high);
}

/// Every row is one, with a key and an id of its own.
template <std::size_t N> consteval bool checkParameters(const std::array<Parameter, N> &table)
{
    for (std::size_t i = 0; i < N; ++i) {
        const Parameter &p = table[i];
        if (!checkParameter(p))
            return false;
        for (std::size_t j = 0; j < i; ++j) {
            if (table[j].key == p.key || table[j].id == p.id)
                return false;
        }
    }
    return true;
}

/// What a person or a JSON reader sees: nothing when unknown, on/off, or a number in the parameter's unit.
using Value = std::variant<std::monostate, bool, double>;

[[nodiscard]] std::optional<ParameterIndex> findParameter(std::span<const Parameter> table, std::string_view key);

/// boolean, integer, number or flags: the `type` of `motorbenchctl parameters`.
[[nodiscard]] std::string_view typeName(const Parameter &parameter);
[[nodiscard]] Value toValue(const Parameter &parameter, std::int64_t raw);
/// Nearest raw value. OutOfRange, with the legal range in the detail, when `number` is outside or not a whole number where
/// one is needed.
[[nodiscard]] Result<std::int64_t> toRaw(const Parameter &parameter, double number);
/// A raw value that the row allows, such as one that a file kept.
[[nodiscard]] bool isLegal(const Parameter &parameter, std::int64_t raw);
/// What a command line or a file says: a number as numberFrom() takes it, `0x…`, on/off/true/false/yes/no, or a choice.
/// OutOfRange otherwise. What people type into the window, comma and all, is `widgets/common/numberformat`.
[[nodiscard]] Result<std::int64_t> parseRaw(const Parameter &parameter, std::string_view text);
/// Shortest text that parseRaw() turns back into `raw`; on/off for booleans.
[[nodiscard]] std::string toText(const Parameter &parameter, std::int64_t raw);
/// The same for people, but a gain that is no integer with four digits at least: 0.003464, where 0.00346 would read back equal.
[[nodiscard]] std::string shownText(const Parameter &parameter, std::int64_t raw);

} // namespace mb
