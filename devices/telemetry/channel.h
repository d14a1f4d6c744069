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
