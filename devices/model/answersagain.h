// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/task.h"
#include "model/device.h"

namespace mb {

/// Whether a device that restarts answers again: asked every 500 ms, ten times. LinkLost. Engine thread.
[[nodiscard]] Task<bool> answersAgain(Device &device);

} // namespace mb
