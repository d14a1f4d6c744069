// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"

namespace mb::supermodified {

/// Digital inputs (6D). What else a node says of itself are errors, in place of an answer.
[[nodiscard]] std::span<const StateRow> stateTable();

/// Error codes that a node reports, as faults.
[[nodiscard]] std::span<const FaultRow> faultTable();

/// Bit 0 is DIO1; an input with nothing on it is high.
[[nodiscard]] LiveStates statesOf(std::uint8_t inputs);

} // namespace mb::supermodified
