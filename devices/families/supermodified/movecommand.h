// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"
#include "families/supermodified/protocol.h"
#include "model/setpoint.h"

namespace mb::supermodified {

[[nodiscard]] bool isPosition(Mode mode);
[[nodiscard]] bool isProfiled(Mode mode);
/// The command that carries a set-point; Unsupported for a mode that the firmware does not have.
[[nodiscard]] Result<Command> commandFor(const SetPoint &setPoint);
/// A relative move by nothing: the motor is held where it is.
[[nodiscard]] bool isHold(const SetPoint &setPoint);

} // namespace mb::supermodified
