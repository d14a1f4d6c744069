// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace mb {

/// Where the help keeps its pages, as resource paths: ":/help/tuning.md" in English, ":/help/de/tuning.md" where somebody has
/// translated it. The language is the one that the window speaks now.
[[nodiscard]] QString helpFile(const QString &topic);
/// The page that stands there, whatever its language: "hardware/dmc60c" of ":/help/de/hardware/dmc60c.md".
[[nodiscard]] QString helpTopicOf(const QString &file);
/// The code of the language in which tr() speaks now, "de"; "en" where nothing is translated.
[[nodiscard]] QString spokenCode();

} // namespace mb
