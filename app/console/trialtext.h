// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/console.h"
#include "storage/trialbook.h"

namespace mb::console {

/// The last line of `step`, or the same for people.
void printTrial(Console &console, const tuning::Trial &trial, std::optional<std::int64_t> number);
/// What `trials` prints.
void printTrials(Console &console, const std::vector<KeptTrial> &trials);

} // namespace mb::console
