// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/task.h"
#include "model/device.h"

namespace mb {

/// Listens long enough to hear another master: Unsafe where one drives the device, or its motor moves, or several units share its
/// number and would all be written. To be asked before a device is served or gets other firmware, which takes its motor away; in its
/// bootloader it drives none. Unsupported for a recording. Sends nothing. Engine thread.
[[nodiscard]] Task<void> standsStill(Device &device);
/// The same, whether or not its motor moves.
[[nodiscard]] Task<void> hasNoOtherMaster(Device &device);

} // namespace mb
