// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"

namespace mb::quadquad2drv {

/// Finds the board of a link by asking for its version (README.md#scan). Unsupported when the link is no SPI link.
[[nodiscard]] Task<void> scan(Link &link, Clock &clock, ScanSink &sink);

/// What a version says about a board: it runs, too.
void setVersion(Identity &identity, int major, int minor, int protocol);

} // namespace mb::quadquad2drv
