// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "telemetry/channel.h"

#include <span>

namespace mb::abstractdc {

/// Current and temperature are counts of the converter until the user says what a count is.
[[nodiscard]] std::span<const Channel> channelTable(bool currentKnown = false, bool temperatureKnown = false);

/// Rows of the table that code names.
namespace channel {
constexpr ChannelIndex position{0};
constexpr ChannelIndex velocity{1};
constexpr ChannelIndex current{2};
constexpr ChannelIndex duty{3};
constexpr ChannelIndex setPoint{4};
constexpr ChannelIndex temperature{5};
} // namespace channel

} // namespace mb::abstractdc
