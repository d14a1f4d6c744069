// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/identity.h"
#include "storage/sqlconnection.h"

#include <set>
#include <string>

namespace mb {

/// The key of a unit (unitKeyOf()) as the notebook has it: that of its tag where its place has one, or where it is to be after its
/// restart and nobody else has the place.
[[nodiscard]] std::string resolvedUnit(SqlConnection &sql, const std::string &unit);
/// A unit is at this place now: one that was to go there (SettingsLog::moves()) has come. What a disk does not take waits for the
/// next time.
void meetAt(SqlConnection &sql, const std::string &place);
/// What is owed to a unit goes with it to its new name; not to one that is known elsewhere, nor from one that still is.
[[nodiscard]] Result<void> moveDebts(SqlConnection &sql, const std::string &before, const std::string &after);
/// The units of which something was kept at a place, whatever the options of its link were, those that were given its number, and
/// the one that is known by the place, or by the tag of it: as far as the notebook tells without the device.
[[nodiscard]] std::set<std::string> unitsAt(SqlConnection &sql, const DeviceSelector &place);

} // namespace mb
