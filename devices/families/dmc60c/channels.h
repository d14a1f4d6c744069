// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "telemetry/channel.h"

#include <span>

namespace mb::dmc60c {

[[nodiscard]] std::span<const Channel> channelTable();

/// Rows of the table that code names.
namespace channel {
constexpr ChannelIndex position{0};
constexpr ChannelIndex velocity{1};
constexpr ChannelIndex current{2};
constexpr ChannelIndex duty{3};
constexpr ChannelIndex setPoint{4};
constexpr ChannelIndex error{5};
constexpr ChannelIndex busVoltage{6};
constexpr ChannelIndex temperature{7};
constexpr ChannelIndex analog1{8};
} // namespace channel

} // namespace mb::dmc60c
