// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "wire/canframe.h"

#include <cstdint>
#include <string>

namespace mb {

/// Whether the program that wrote a log had received a frame or sent it; most logs do not tell.
enum class LogDirection : std::uint8_t { Unknown, Received, Sent };

/// A frame as log files have it.
struct LoggedFrame {
    Duration time{};  ///< since 1970, or since the start on a simulated link; never negative
    std::string link; ///< no blanks in it
    CanFrame frame;   ///< its own `time` is not set: the log does not know our clock
    LogDirection direction = LogDirection::Unknown;
};

} // namespace mb
