// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transport/link.h"

#include <span>
#include <string>
#include <string_view>

namespace mb {

/// `(1436509052.249713) ttyUSB0 tx 5504FF`: bytes of a serial line or of SPI as text, in the manner of candump -L, without the end
/// of the line. A time before 1970 is written as 0.
[[nodiscard]] std::string bytesLine(
    Duration time, std::string_view link, Direction direction, std::span<const std::uint8_t> bytes);
/// "5504FF".
[[nodiscard]] std::string hexText(std::span<const std::uint8_t> bytes);

} // namespace mb
