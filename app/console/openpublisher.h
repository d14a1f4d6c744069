// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/console.h"
#include "app/console/publisher.h"

#include <memory>

namespace mb::console {

/// Resolves the host and, with mqtt, waits for the broker to take us: for --timeout, 5 s without it, in a thread of its own, so that a
/// signal ends the waiting. LinkLost with cause and remedy otherwise.
[[nodiscard]] Task<std::unique_ptr<Publisher>> openPublisher(Console &console, PublishAddress address);

} // namespace mb::console
