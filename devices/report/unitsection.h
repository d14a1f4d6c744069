// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/reportunit.h"

namespace mb {

/// Who the unit is.
[[nodiscard]] QString identityHtml(const ReportUnit &unit, const Report &report);
/// Every parameter that was read, beside its default; what differs stands out. Empty where nobody has read them.
[[nodiscard]] QString parametersHtml(const ReportUnit &unit, const Report &report);
/// The settings that differ from their default, as many as a card has room for, and how many more there are. Empty where none does.
[[nodiscard]] QString changedParametersHtml(const ReportUnit &unit, const Report &report);
/// "DMC60C 7", as a heading names it.
[[nodiscard]] QString nameOf(const ReportUnit &unit);

} // namespace mb
