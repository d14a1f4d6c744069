// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"
#include "experiment/kepttrial.h"

#include <QJsonArray>
#include <QJsonObject>

#include <optional>
#include <string>
#include <vector>

namespace mb {

/// When it was made, of the computer's time zone: "2026-11-28T20:15:00".
[[nodiscard]] std::string timeOf(const KeptTrial &kept);
/// "saturated, did-not-move".
[[nodiscard]] std::string flagsOf(const tuning::Trial &trial);
/// A row of `trials`: every key of the last line of `step`, and what the notebook adds.
[[nodiscard]] QJsonObject trialRow(const KeptTrial &kept);
[[nodiscard]] QJsonArray trialRows(const std::vector<KeptTrial> &trials);
/// The rows into a file as JSON, or as a table where the name ends with .csv. OutOfRange when nothing can be written there, NotKept when that fails.
[[nodiscard]] Result<void> exportTrials(const std::string &path, const std::vector<KeptTrial> &trials);
/// One trial into a file: the last line of `step` with its signals as JSON, or the samples alone where it ends with .csv.
[[nodiscard]] Result<void> saveTrial(
    const std::string &path, const tuning::Trial &trial, std::optional<std::int64_t> number);

} // namespace mb
