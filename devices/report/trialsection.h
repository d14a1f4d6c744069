// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/reportunit.h"

namespace mb {

/// One trial in full: what was asked, its curves, metrics and gains.
[[nodiscard]] QString trialHtml(const KeptTrial &kept, const ReportUnit &unit, const Report &report);
/// One step in short: what was asked, its curves, its metrics in one row.
[[nodiscard]] QString stepHtml(const KeptTrial &kept);
/// Every trial of a unit, one line each, the newest first.
[[nodiscard]] QString historyHtml(const ReportUnit &unit);

/// The label of a parameter by its key; the key itself where the family does not know it.
[[nodiscard]] QString gainLabel(const ReportUnit &unit, const std::string &key, const Report &report);

constexpr int historyRows = 60; ///< of them, at most

} // namespace mb
