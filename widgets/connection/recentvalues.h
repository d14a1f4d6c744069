// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/snapshot.h"

#include <deque>
#include <string_view>

namespace mb {

inline constexpr int recentPoints = 120;

/// The last ten seconds of a channel for a Sparkline, oldest first; NaN where nothing came. Empty where the device has no such
/// channel.
[[nodiscard]] std::deque<double> recentValues(const DeviceView &device, std::string_view channel, Instant now);

} // namespace mb
