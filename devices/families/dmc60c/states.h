// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/dmc60c/codec.h"
#include "model/livestate.h"

namespace mb::dmc60c {

/// Limits, halt and pins that the status frames tell (README.md#status-frames).
[[nodiscard]] std::span<const StateRow> stateTable();

void takeStates(LiveStates &states, const StatusGeneral &status);
void takeStates(LiveStates &states, const StatusEncoder &status);

} // namespace mb::dmc60c
