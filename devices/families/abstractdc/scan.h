// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/abstractdc/protocol.h"
#include "model/family.h"

namespace mb::abstractdc {

/// Family::scan, README.md#dialects: log requests only, which never move anything. First everybody is asked for the speed, whose code is
/// the same in all dialects; then each answer is asked, alone, for the logs that tell dialects apart by where the answer comes.
[[nodiscard]] Task<void> scan(Link &link, Clock &clock, ScanSink &sink);

/// What is shown of a drive that was found to speak this dialect; nullptr: not proven.
[[nodiscard]] Identity identityOf(int offset, const Dialect *dialect);

} // namespace mb::abstractdc
