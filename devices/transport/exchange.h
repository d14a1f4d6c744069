// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transport/caninbox.h"

namespace mb {

/// How often and how long to ask.
struct Attempts {
    int tries = 3;
    Duration timeout = std::chrono::milliseconds(250);
};

/// Sends `request` and yields the first frame that `match` accepts; asks again on a time-out. The patience of the link wins. The link and the clock
/// outlive the task. Name the match before the call (docs/architecture.md#asynchrony).
[[nodiscard]] Task<CanFrame> exchange(
    CanLink &link, Clock &clock, CanFrame request, CanInbox::Match match, Attempts attempts);

} // namespace mb
