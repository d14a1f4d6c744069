// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/reportunit.h"

namespace mb {

/// The last service of a unit: result, firmware before and after, what the self-test measured, against its limits and against
/// the last visit that measured the same. Empty where it was never served.
[[nodiscard]] QString lastVisitHtml(const ReportUnit &unit, const Report &report);
/// Every service of it, newest first, one line each; empty for fewer than two.
[[nodiscard]] QString visitsHtml(const ReportUnit &unit, const Report &report);

/// PASS, FAIL, …, with its role.
[[nodiscard]] QString resultHtml(service::Outcome outcome);
/// "+38 %": how a value stands to an earlier one; empty where that cannot be said.
[[nodiscard]] QString changeText(std::optional<double> now, std::optional<double> before);

} // namespace mb
