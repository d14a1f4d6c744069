// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/parameter.h"

#include <span>

namespace mb::dmc60c {

/// The 55 parameters of README.md#parameters, in the order of their wire numbers.
[[nodiscard]] std::span<const Parameter> parameterTable();
/// The row with this number on the wire.
[[nodiscard]] std::optional<ParameterIndex> parameterWithId(std::uint8_t wireNumber);

} // namespace mb::dmc60c
