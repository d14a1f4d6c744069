// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/identity.h"
#include "storage/sqlconnection.h"

#include <set>
#include <string>

namespace mb {

/// The key of a unit (unitKeyOf()) as the notebook has it: that of its tag where its place has one.
[[nodiscard]] std::string resolvedUnit(SqlConnection &sql, const std::string &unit);
/// The units of which something was kept at a place, whatever the options of its link were, those that were given its number, and
/// the one that is known by the place, or by the tag of it: as far as the notebook tells without the device.
[[nodiscard]] std::set<std::string> unitsAt(SqlConnection &sql, const DeviceSelector &place);

} // namespace mb
