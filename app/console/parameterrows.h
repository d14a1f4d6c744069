// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/console.h"
#include "model/parameterfile.h"

#include <string>
#include <string_view>
#include <vector>

namespace mb::console {

/// A key of the family's table; OutOfRange with the nearest key.
[[nodiscard]] Result<ParameterIndex> parseKey(const Family &family, std::string_view key);
/// Values with unit and state, for people.
void printParameters(Console &console, const Device &device, const std::vector<ParameterIndex> &indices);
/// "1.5 A", "on", "unknown".
[[nodiscard]] std::string shownValue(const Parameter &parameter, std::optional<std::int64_t> raw);
/// The first error of a transfer, with its key in the detail.
[[nodiscard]] std::optional<Error> firstError(const Device &device, const std::vector<TransferOutcome> &outcomes);

} // namespace mb::console
