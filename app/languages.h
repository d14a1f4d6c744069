// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>

#include <vector>

namespace mb {

/// A language that the window speaks: what is compiled into :/translations, which is the only list there is.
struct Language {
    QString code; ///< "de"
    QString name; ///< in itself: "Deutsch"
};

/// By code. English is among them.
[[nodiscard]] std::vector<Language> languages();
[[nodiscard]] bool isSpoken(const QString &code);
/// The font whose glyphs its readers expect, because one code point has several shapes: "Noto Sans CJK SC"; empty: any.
[[nodiscard]] QString glyphsOf(const QLocale &locale);
/// "de, en, es, fr, ja, zh": for a sentence that says what there is.
[[nodiscard]] QString spokenCodes();

} // namespace mb
