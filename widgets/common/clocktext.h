// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

#include <QDateTime>
#include <QLocale>

namespace mb {

class Workbench;

/// How finely a time of day is told.
enum class ClockPart { Minutes, Seconds, Milliseconds };

/// A time since 1970, in s, as the wall clock here has it.
[[nodiscard]] QDateTime momentOf(double unixTime);
/// A time stamp of the workbench.
[[nodiscard]] QDateTime momentOf(Workbench &workbench, Instant time);

/// The time of day, from 0 to 23 hours in every language, so that pages, logs and files can be compared: "18:21:28".
[[nodiscard]] QString clockText(const QDateTime &moment, ClockPart part = ClockPart::Seconds);
/// Day and month in the language's own order and words, the year where it is not this one: "28 November", "11月28日".
[[nodiscard]] QString dayText(const QDate &day, const QLocale &locale = QLocale());
/// The date as the language writes it in short, and the time to the minute.
[[nodiscard]] QString dateAndClockText(const QDateTime &moment);

} // namespace mb
