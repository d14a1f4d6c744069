// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/device.h"
#include "model/family.h"
#include "tinker/codec.h"
#include "transport/caninbox.h"

namespace mb::tinker {

/// Family::scan.
[[nodiscard]] Task<void> scan(Link &link, Clock &clock, ScanSink &sink);
/// Family::open.
[[nodiscard]] std::unique_ptr<Device> open(Link &link, Clock &clock, const Identity &identity);
/// What Here says of a unit.
[[nodiscard]] Identity identityOf(int address, const Here &here);

} // namespace mb::tinker
