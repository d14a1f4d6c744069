// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/console.h"
#include "tuning/autotune.h"

#include <QJsonObject>

namespace mb::console {

/// The last line of `tune`.
[[nodiscard]] QJsonObject toJson(const tuning::TuneReport &report);
/// The same, or for people.
void printTuning(Console &console, const tuning::TuneReport &report);
/// As a JSON file; written whole or not at all.
[[nodiscard]] Result<void> saveTuning(const std::string &path, const tuning::TuneReport &report);

} // namespace mb::console
