// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/trial.h"
#include "widgets/common/displayunits.h"

#include <QString>

namespace mb {

/// What a trial is called in front of people.
[[nodiscard]] QString profileText(tuning::Profile profile);
/// Of Trial::reason: a guard, "interrupted" …
[[nodiscard]] QString guardText(tuning::EndReason reason);
/// Of a flag, with its number where the trial has one: "saturated 95 ms".
[[nodiscard]] QString flagText(const std::string &flag, const tuning::Trial &trial);
/// "0 ▸ 1500 ×4" in the unit that is shown, with the name of the profile where it is no step.
[[nodiscard]] QString stimulusText(const tuning::Trial &trial, const DisplayUnits &units);

/// A metric as it stands in table and list.
struct MetricWord {
    QString name;
    double scale = 1.0;
    int decimals = 1;
    QString unit;
    bool smallerIsBetter = true;
    double same = 0.0; ///< a difference below it, as shown, is none
    QString less;      ///< the word for a smaller value, for a larger one
    QString more;
};
/// In the order of tuning::metricKeys(), with the same keys.
[[nodiscard]] MetricWord metricWord(std::string_view key);

} // namespace mb
