// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/autotune.h"

#include <QJsonObject>

namespace mb {

/// A tuning as the notebook keeps it: everything but what has a column of its own; trials by their numbers, predictions thinned out
/// to `tuningPoints`. What is not known is null.
[[nodiscard]] QJsonObject toJson(const tuning::TuneReport &report);
/// The same back; what is missing or foreign stays as it is. The trials of the proof have their numbers only.
void readTuning(const QJsonObject &object, tuning::TuneReport &report);

constexpr int tuningPoints = 400; ///< of a predicted curve

} // namespace mb
