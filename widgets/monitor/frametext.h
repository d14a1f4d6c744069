// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"
#include "traffic/trafficlog.h"

#include <QString>

#include <optional>

namespace mb {

/// "02061405" with 29 bits, "123" with 11.
[[nodiscard]] QString hexId(const CanFrame &frame);
/// "81 25 11"; of a remote frame the word.
[[nodiscard]] QString hexBytes(const CanFrame &frame);
[[nodiscard]] QString hexBytes(std::span<const std::uint8_t> bytes);
/// What an error frame reports: "nobody acknowledged, error-passive".
[[nodiscard]] QString errorFrameText(const CanFrame &frame);

/// The number that a unit "1/32767" or "1/32767 per 0.5 ms" divides by; nothing for other units.
[[nodiscard]] std::optional<double> fullScale(std::string_view unit);
/// "29.4 %" for a fraction, "velocity" for a mode, "12.41 V", "10 236 counts"; for people, rounded to five digits.
[[nodiscard]] QString fieldValue(const DecodedField &field);
/// The value as the wire has it, unrounded: "9633", with its unit where that is one.
[[nodiscard]] QString wireValue(const DecodedField &field);
/// A flag: nothing to plot, and when off nothing to say in a line.
[[nodiscard]] bool isFlag(const DecodedField &field);
/// A short word: "duty" of dtcApplied, "fwd limit pin" of fFwdLimitPin. In English, as the names are.
[[nodiscard]] QString fieldName(const DecodedField &field);
/// "mode=velocity  target=1 200 counts": the fields in one line, what tells most first, without flags that are off.
[[nodiscard]] QString fieldsLine(const DecodedFrame &frame);
/// "modeSelect=1  trgt=1200 counts": all of them with the names that a filter takes.
[[nodiscard]] QString wireLine(const DecodedFrame &frame);
/// "5"; "–" where the frame does not tell whom it is from or for.
[[nodiscard]] QString addressText(const DecodedFrame &frame);
/// The field that a small line shows unless the user names another: the first that has a unit, otherwise the first. Nothing when there are none.
[[nodiscard]] std::optional<std::size_t> tellingField(const DecodedFrame &frame);

} // namespace mb
