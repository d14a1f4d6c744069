// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace mb {

/// Position in the channel table of a family; never mixed with a parameter index or an axis.
struct ChannelIndex {
    std::uint16_t value = 0;
    friend auto operator<=>(const ChannelIndex &, const ChannelIndex &) = default;
};

/// What a channel measures: picks its colour, its pane and its display units.
enum class Quantity : std::uint8_t { Position, Velocity, Current, Duty, SetPoint, Error, Voltage, Temperature, Other };

/// One row of a family's table. Keys and units are those of docs/names.md#units.
struct Channel {
    std::string_view key;   ///< stable: position, velocity, ch1.position, …
    std::string_view unit;  ///< counts, counts/s, A, V, °C, fraction; empty for a bare number
    std::string_view label; ///< English; widgets translate it
    Quantity quantity = Quantity::Other;
};

/// How a value stands in front of people: times `scale`, with this unit and so many decimals.
struct UnitForm {
    double scale = 1.0;
    std::string_view text; ///< English; widgets translate it
    int decimals = 0;      ///< that mean something to a person
};

/// The one table of that; `unit` as in Channel.
[[nodiscard]] constexpr UnitForm unitForm(Quantity quantity, std::string_view unit)
{
    switch (quantity) {
    case Quantity::Position:
    case Quantity::Velocity: return {1.0, unit, 0};
    case Quantity::Current:
    case Quantity::Voltage:
    case Quantity::Temperature:
        if (unit == "counts") // of a converter, until somebody said what one of them is
            return {1.0, "ADC", 0};
        return {1.0, unit, quantity == Quantity::Temperature ? 1 : 2};
    case Quantity::Duty:
        if (unit == "fraction")
            return {100.0, "%", 1};
        break;
    default: break;
    }
    return {1.0, unit, 1};
}

[[nodiscard]] constexpr std::optional<ChannelIndex> findChannel(std::span<const Channel> table, std::string_view key)
{
    for (std::size_t i = 0; i < table.size(); ++i) {
        if (table[i].key == key)
            return ChannelIndex{static_cast<std::uint16_t>(i)};
    }
    return std::nullopt;
}

/// Every row has a label and a key of its own.
template <std::size_t N> consteval bool checkChannels(const std::array<Channel, N> &table)
{
    for (std::size_t i = 0; i < N; ++i) {
        if (table[i].key.empty() || table[i].label.empty())
            return false;
        if (findChannel(table, table[i].key)->value != i)
            return false;
    }
    return N <= 65535;
}

} // namespace mb
