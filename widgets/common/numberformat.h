// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

namespace mb {

/// Stands for a value that is not known. Never 0.
inline constexpr QChar UnknownMark{0x2013};
inline constexpr QChar MinusSign{0x2212};
/// Groups thousands in read-only values; narrow and unbreakable.
inline constexpr QChar ThinSpace{0x202F};

/// Of the language of the program (QLocale()): a dot or a comma. Only on screen: files, the clipboard and JSON have a dot. The examples
/// below have a dot.
QChar decimalSign();
/// The one of both that decimalSign() is not; it is understood as well.
QChar foreignSign();
/// A number that is written as a file has it, with the sign of the program and nothing else changed.
QString localNumber(QString plain);
/// Read-only number with U+2212 and grouped thousands: "−20 480". NaN and infinity give "–".
QString formatNumber(double value, int decimals = 0);
QString formatCount(qint64 value);
/// The same of one that is written as a file has it: "-20480.5", "1e-07".
QString formatWritten(const QString &plain);
/// So many significant digits, no exponent between 1e-4 and 1e9, trailing zeros kept: "0.003464".
QString formatSignificant(double value, int digits);
/// Number, no-break space, unit: "12.43 V". Without a unit only the number; unknown stays "–" without unit.
QString formatValue(double value, int decimals, const QString &unit);
/// With a leading "+" where positive, for differences: "+55", "−18.2", "0".
QString formatDifference(double value, int decimals);
/// "420 ms", "12.4 s", "4:32", "1:02:03" for lengths of time; NaN gives "–".
QString formatDuration(double seconds);
/// "0:07", "4:32", "1:02:03": a time that runs, never shorter than minutes and seconds.
QString formatClock(qint64 seconds);
/// "512 B", "38 kB", "1.2 MB" (powers of 1000).
QString formatBytes(qint64 bytes);

/// Text for an input field: a plain "-", never grouped, shortest form that reads back equal.
QString editText(double value);
QString editText(double value, int decimals);

/// What a user typed. Accepts "," or "." as the decimal sign, "-" or "−", an exponent, and blanks around; refuses
/// grouping ("1,000.5", "1 000"), two signs, hex and any rest. A trailing "%" is understood when `fullScale` is
/// given: "55 %" is 0.55 × fullScale. Empty when it is not a finite number.
std::optional<double> parseNumber(const QString &text, std::optional<double> fullScale = {});
/// "= 1.5" for "1,5", "= 31" for "0x1F": what is understood of a text that is not written as the program writes numbers. Empty where
/// there is nothing to add. "1,500" is 1.5: comma and dot are decimal signs, never of a group of thousands.
QString understoodText(const QString &typed);
/// The same number with the decimal sign of the program, where it was typed with the other; anything else as it is.
QString asWritten(const QString &typed);
/// As parseNumber, but only whole numbers; also "0x1A".
std::optional<qint64> parseInteger(const QString &text);

} // namespace mb
