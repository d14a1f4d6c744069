// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "telemetry/channel.h"

#include <span>

namespace mb::quadquad2drv {

[[nodiscard]] std::span<const Channel> channelTable();

/// What an axis (0…3) has in the table.
enum class AxisChannel : std::uint16_t { Position, Velocity, Status, SetPoint };
constexpr std::uint16_t channelsPerAxis = 4;
constexpr std::uint16_t measuredPerAxis = 3; ///< the first ones; the set-point is ours

[[nodiscard]] constexpr ChannelIndex channelOf(int axis, AxisChannel which)
{
    return {static_cast<std::uint16_t>(axis * channelsPerAxis + static_cast<int>(which))};
}

} // namespace mb::quadquad2drv
