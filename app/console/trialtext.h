// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/console.h"
#include "storage/trialbook.h"

#include <QJsonObject>

namespace mb::console {

/// The last line of `step`, or the same for people.
void printTrial(Console &console, const tuning::Trial &trial, std::optional<std::int64_t> number);
/// Into a file: the last line of `step` with its signals as JSON, or the samples alone where its name ends with .csv.
[[nodiscard]] Result<void> saveTrial(
    const std::string &path, const tuning::Trial &trial, std::optional<std::int64_t> number);

/// A row of `trials`.
[[nodiscard]] QJsonObject trialRow(const KeptTrial &kept);
/// What `trials` prints.
void printTrials(Console &console, const std::vector<KeptTrial> &trials);
/// The rows as JSON, or as a table where the name ends with .csv.
[[nodiscard]] Result<void> exportTrials(const std::string &path, const std::vector<KeptTrial> &trials);

} // namespace mb::console
