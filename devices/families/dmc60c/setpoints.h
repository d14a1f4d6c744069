// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/dmc60c/codec.h"
#include "model/setpoint.h"

namespace mb::dmc60c {

/// The control frame for a set-point in the units of docs/names.md#units. OutOfRange when a target is no number or outside
/// of what the mode allows (current ±100 A and voltage ±28 V, the ratings; a follower cannot follow itself),
/// Unsupported for a mode, axis or slot that the device does not have. `device` is the number the frame is for.
[[nodiscard]] Result<Control> controlFor(const SetPoint &setPoint, int device);

/// The mode that the device reports; nothing for a reserved code.
[[nodiscard]] std::optional<Mode> modeOf(ControlMode mode);

} // namespace mb::dmc60c
