// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/experimentjournal.h"
#include "model/device.h"
#include "model/family.h"
#include "service/recipematter.h"

namespace mb::service {

/// What can be said against this unit before anything is done to it: duplicate, wrong hardware, an image that does not fit, gains
/// that an experiment left on trial, as far as `trials` (may be nullptr) tells of one. Reads only. The error is the cause for its row.
[[nodiscard]] Task<void> preflight(
    Device &device, const RecipeMatter &matter, tuning::ExperimentJournal *trials, Progress &progress);

/// Refused where this unit, as it is now, does not have a setting of the recipe: it names the first.
[[nodiscard]] Result<void> checkOffered(const Device &device, const RecipeMatter &matter);

/// What an update by this rule is told.
[[nodiscard]] UpdateOptions updateOptionsOf(const FirmwareRule &rule);

} // namespace mb::service
