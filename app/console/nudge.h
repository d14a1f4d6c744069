// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/console.h"

namespace mb::console {

/// Turns the shaft of a device that cannot blink a little to and fro, twice, and yields how far it went, in counts. Pushes harder
/// until it moves, at most with 30 % of full duty; without a duty command it is sent a short way. Refused when it did not move.
/// A signal stops it and ends this (Cancelled, once the motor is seen to stand). The motor is off before and after.
[[nodiscard]] Task<double> nudge(Console &console, Device &device, int axis);

} // namespace mb::console
