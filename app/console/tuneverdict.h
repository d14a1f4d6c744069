// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/tunereport.h"

namespace mb::console {

/// What `tune` ends with (docs/names.md#exit-statuses), whatever came of it.
[[nodiscard]] Result<int> verdictOf(const tuning::TuneReport &report);

} // namespace mb::console
