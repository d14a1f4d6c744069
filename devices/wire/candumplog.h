// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wire/loggedframe.h"

#include <optional>
#include <string>
#include <string_view>

namespace mb {

/// A line of `candump -L`: `(1436509052.249713) vcan0 044#2A366C2BBA`, and of `candump -L -x`, where R or T follows.
using CandumpLine = LoggedFrame;

/// Reads one line, its end allowed. Nothing for everything else: comments, CAN FD frames (`##`), more than 9 digits
/// after the point, a malformed frame.
[[nodiscard]] std::optional<CandumpLine> parseCandumpLine(std::string_view text);

/// A whole line of a CAN FD frame: `(1436509052.249713) vcan0 044##1AABB`. Only classic CAN is read.
[[nodiscard]] bool isCandumpFdLine(std::string_view text);

/// Without the end of the line. Microseconds, as candump writes them: finer parts are cut off.
[[nodiscard]] std::string toCandumpLine(Duration time, std::string_view link, const CanFrame &frame);
[[nodiscard]] std::string toCandumpLine(const CandumpLine &line);

} // namespace mb
