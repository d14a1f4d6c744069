// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/message.h"

#include <string_view>

namespace mb::service {

/// What a key of Acceptance is called in a sentence; what is none, as it is written.
[[nodiscard]] Message figureName(std::string_view key);

/// A value of that key with three digits and the unit that people read it in: "450 ms", "4.2 %", "46.1 A". Friction and gain have
/// another unit on a device without a bus voltage, which the value does not tell: they stand without one.
[[nodiscard]] MessageNumber figureNumber(std::string_view key, double value);

} // namespace mb::service
