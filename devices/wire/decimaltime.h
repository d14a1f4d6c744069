// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

#include <optional>
#include <string>
#include <string_view>

namespace mb {

/// `1436509052.249713`: digits, a point, 1…9 digits, nothing else. Nothing for times that a Duration cannot hold.
[[nodiscard]] std::optional<Duration> parseSeconds(std::string_view text);

/// Seconds with microseconds, finer parts cut off, below zero as zero; the whole seconds have at least `digits` places,
/// filled up with `fill`.
void appendSeconds(std::string &out, Duration time, std::size_t digits, char fill);

} // namespace mb
