// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wire/loggedframe.h"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace mb {

/// A line of `monitor` on a serial or SPI link: `(1436509052.249713) ttyUSB0 tx 55AA04010E000F`.
struct LoggedBytes {
    Duration time{};                                ///< since 1970, or since the start on a simulated link
    std::string link;                               ///< no blanks in it
    LogDirection direction = LogDirection::Unknown; ///< never Unknown in a line that was read
    std::vector<std::uint8_t> bytes;                ///< never empty
};

/// Reads one line; blanks between the bytes are allowed. Nothing for everything else.
[[nodiscard]] std::optional<LoggedBytes> parseByteLine(std::string_view text);

/// Without the end of the line. Microseconds, finer parts are cut off.
[[nodiscard]] std::string toByteLine(
    Duration time, std::string_view link, LogDirection direction, std::span<const std::uint8_t> bytes);

/// Digits in pairs, upper case, no blanks: as `data` in JSON.
[[nodiscard]] std::string toHexText(std::span<const std::uint8_t> bytes);

} // namespace mb
