// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/livestate.h"

namespace mb::quadquad2drv {

/// The input of each axis (README.md#inputs): on while it is active, or was since the motion data before.
[[nodiscard]] std::span<const StateRow> stateTable();

/// Of an axis (0…3), by its status byte.
void takeStates(LiveStates &states, int axis, std::uint8_t status);

} // namespace mb::quadquad2drv
