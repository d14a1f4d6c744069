// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/trial.h"

#include <QString>

namespace mb {

/// A row of a table of metrics: its name and unit, and how a value is written.
struct MetricWords {
    QString name;
    double scale = 1.0;
    int decimals = 1;
    QString unit;
};
/// In the order of tuning::metricKeys().
[[nodiscard]] MetricWords metricWords(std::string_view key);
/// "524 ms", "–".
[[nodiscard]] QString metricText(std::string_view key, const std::optional<double> &value);

[[nodiscard]] QString modeWord(Mode mode);
/// "0 ▸ 60 000 counts/s, 2 times", with the name of the profile where it is no step.
[[nodiscard]] QString stimulusWords(const tuning::Trial &trial);
/// Why a trial has ended: its reason, or that nobody saw it.
[[nodiscard]] QString endingWords(const tuning::Trial &trial);

} // namespace mb
