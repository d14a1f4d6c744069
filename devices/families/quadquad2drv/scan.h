// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"

namespace mb::quadquad2drv {

/// Finds the board of a link by asking for its version (README.md#scan). Unsupported when the link is no SPI link.
[[nodiscard]] Task<void> scan(Link &link, Clock &clock, ScanSink &sink);

/// Family::probe: like scan, but a board that was named and does not answer is reported too, as one that may wait in its
/// bootloader, which does not listen to SPI: so it can be updated again after a cut.
[[nodiscard]] Task<void> probe(Link &link, Clock &clock, int address, ScanSink &sink);

/// What a version says about a board.
void setVersion(Identity &identity, int major, int minor, int protocol);

} // namespace mb::quadquad2drv
