// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "async/task.h"
#include "transport/link.h"

namespace mb {

/// Waits until a lost link is open again, for long jobs that can go on then. Opens it itself as soon as that is possible, whether
/// or not somebody else tries as well. LinkLost with the last cause after `limit`; at once when the link was closed by
/// us, or is bus-off: then its interface is there, and waiting helps nothing.
[[nodiscard]] Task<void> linkReturn(Link &link, Clock &clock, Duration limit);

} // namespace mb
