// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/parameter.h"
#include "model/trialtraits.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mb {

struct Family;

/// Which parameters make a loop, and what each of them is: by its Role, whatever its family calls it. Axes count from 1; where a family
/// has one only, any number is it.

/// The loop of a mode; nullptr where the family has none that can be tried.
[[nodiscard]] const LoopGains *loopOf(const Family &family, Mode mode);

/// Key of a parameter of a family's traits, for this axis and slot.
[[nodiscard]] std::string gainKey(const Family &family, std::string_view pattern, int axis, int slot);

/// The parameters of a loop, in the family's order.
[[nodiscard]] std::vector<ParameterIndex> loopParameters(
    const Family &family, const LoopGains &loop, int axis, int slot);

/// The first of a loop with this role; nothing where the family has no such loop or the loop no such parameter.
[[nodiscard]] std::optional<ParameterIndex> parameterOf(const Family &family, Mode loop, int axis, int slot, Role role);
/// The first with this role that belongs to an axis, whatever its loops are.
[[nodiscard]] std::optional<ParameterIndex> parameterOfAxis(const Family &family, int axis, Role role);

/// Of the parameter with this key, such as a trial keeps; None where the family has none.
[[nodiscard]] Role roleOf(const Family &family, std::string_view key);
/// "P", "I", "D", "F"; empty for what is no gain.
[[nodiscard]] std::string_view gainLetter(Role role);

} // namespace mb
