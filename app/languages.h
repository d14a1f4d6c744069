// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QStringList>

#include <vector>

namespace mb {

/// A language that the window speaks: what is compiled into :/translations, which is the only list there is.
struct Language {
    QString code; ///< "de"
    QString name; ///< in itself: "Deutsch"
};

/// By code: "de", "en", … English is among them.
[[nodiscard]] QStringList spokenCodes();
/// The same with their names, for which each is opened.
[[nodiscard]] std::vector<Language> languages();
/// The font whose glyphs its readers expect, because one code point has several shapes: "Noto Sans CJK SC"; empty: any.
[[nodiscard]] QString glyphsOf(const QLocale &locale);

} // namespace mb
