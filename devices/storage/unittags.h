// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "storage/sqlconnection.h"

#include <string>

namespace mb {

/// The key of a unit (unitKeyOf()) as the notebook has it: that of its tag where its place has one.
[[nodiscard]] std::string resolvedUnit(SqlConnection &sql, const std::string &unit);

} // namespace mb
