// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"

namespace mb::tinker {

namespace channel {
constexpr ChannelIndex position{0};
constexpr ChannelIndex duty{1};
constexpr ChannelIndex setPoint{2};
} // namespace channel

[[nodiscard]] std::span<const Parameter> parameterTable();
[[nodiscard]] std::span<const Channel> channelTable();
[[nodiscard]] std::span<const StateRow> stateTable();
[[nodiscard]] std::span<const FaultRow> faultTable();

} // namespace mb::tinker
