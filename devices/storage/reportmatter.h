// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/report.h"
#include "storage/trialbook.h"

#include <span>

namespace mb {

/// Out of the notebook, a unit after the other. Of trials: these in full, the tunings that they were part of, and the history of
/// their units; where a unit is named beside them, of its own only. Of a unit: the newest tuning of each loop in full, the newest
/// trial of each loop besides, and its history. Of both every service of the unit. A unit is known by its tag where it has one, and
/// described as its trials and tunings knew it. OutOfRange for a number that is not there, but where it only names a tuning, and where the
/// file cannot be read.
[[nodiscard]] Result<std::vector<ReportUnit>> reportUnits(
    TrialBook &book, std::span<const Family *const> families, const ReportWish &wish);

/// What a name of a unit and a selector tell of it.
[[nodiscard]] ReportUnit unitFrom(
    const std::string &unit, const std::string &selector, std::span<const Family *const> families);

} // namespace mb
