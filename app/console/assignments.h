// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"
#include "model/parameterstore.h"

#include <string>
#include <vector>

namespace mb::console {

/// KEY=VALUE of a family's table, each key once. OutOfRange for what does not parse, is read-only or out of range.
[[nodiscard]] Result<std::vector<ParameterChange>> parseAssignments(
    const Family &family, const std::vector<std::string> &texts);

} // namespace mb::console
