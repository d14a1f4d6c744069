// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/parameter.h"

#include <QString>

#include <optional>

namespace mb {

/// Texts of parameter values for people, and back. Screen texts have U+2212, texts for fields have "-", both the decimal
/// sign of the program. Never grouped: a value can be copied from the table into a field. A gain has four digits at least.

[[nodiscard]] QString valueText(const Parameter &parameter, std::int64_t raw);
[[nodiscard]] QString fieldText(const Parameter &parameter, std::int64_t raw);
/// "0x1F"; a negative number in two's complement of its wire type.
[[nodiscard]] QString rawText(const Parameter &parameter, std::int64_t raw);
/// "0 … 32767 throttle"
[[nodiscard]] QString rangeText(const Parameter &parameter);
/// "40 A", "−32767", "on": with its unit where that is a symbol.
[[nodiscard]] QString valueWithUnit(const Parameter &parameter, std::int64_t raw);
/// The data sheet's default as it travels.
[[nodiscard]] std::int64_t defaultRaw(const Parameter &parameter);
/// The value that is 100 %, where a percentage means something: outputs of the drive.
[[nodiscard]] std::optional<double> fullScale(const Parameter &parameter);

/// A field takes text for it: it can be written, and is no counter, which writing would clear.
[[nodiscard]] bool isEditable(const Parameter &parameter);

/// What a user typed.
struct ParsedValue {
    std::optional<std::int64_t> raw;     ///< nothing when it is not legal
    QString fault;                       ///< "40000 is above 32767 (100 %)."
    QString remedy;                      ///< "Enter 0 … 32767, or a percentage such as 55 %."
    std::optional<std::int64_t> nearest; ///< the legal value that was meant, where one is near
};
/// "= 1.1649" where that is what will be written and something else was typed; empty where there is nothing to add.
[[nodiscard]] QString understoodValue(const Parameter &parameter, const QString &text);
[[nodiscard]] ParsedValue parseValue(const Parameter &parameter, const QString &text);

} // namespace mb
