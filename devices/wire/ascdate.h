// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

#include <optional>
#include <string>
#include <string_view>

namespace mb {

/// The time in `Wed Sep 30 15:06:13.191 2017`, as ASC logs have it: day of the week, month (English or German), day,
/// time with up to nine places or none, `am` or `pm` where it is there, year 1970…2200. Since 1970, as if it were UTC.
/// Nothing for other spellings.
[[nodiscard]] std::optional<Duration> unixTimeOfAscDate(std::string_view text);

/// The same in English, in UTC, to the millisecond.
[[nodiscard]] std::string toAscDate(Duration unixTime);

} // namespace mb
