// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "telemetry/channel.h"

#include <span>

namespace mb::supermodified {

namespace channel {
constexpr ChannelIndex position{0};
constexpr ChannelIndex velocity{1};
constexpr ChannelIndex current{2};
constexpr ChannelIndex setPoint{3};
constexpr ChannelIndex reportedVelocity{4};
constexpr ChannelIndex absolutePosition{5};
constexpr ChannelIndex analog1{6}; ///< and the next three
constexpr ChannelIndex digital{10};
} // namespace channel

namespace calibration {
constexpr std::string_view amperes = "amperes_per_count";
} // namespace calibration

/// D1 and D2 tell the current as a count of their converter, D3 in mA.
[[nodiscard]] std::span<const Channel> channelTable(bool currentKnown = false);

} // namespace mb::supermodified
