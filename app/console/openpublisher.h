// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/publisher.h"

#include <memory>

namespace mb::console {

/// Resolves the host and, with mqtt, waits up to 5 s for the broker to take us. LinkLost with cause and remedy otherwise.
[[nodiscard]] Result<std::unique_ptr<Publisher>> openPublisher(const PublishAddress &address);

} // namespace mb::console
