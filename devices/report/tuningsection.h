// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/reportunit.h"

namespace mb {

/// One tuning in full: its verdict, the model with its ±, gains from and to, what was predicted and what was measured, the loop.
[[nodiscard]] QString tuningHtml(const KeptTuning &kept, const ReportUnit &unit, const Report &report);

} // namespace mb
