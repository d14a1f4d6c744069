// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/setpoint.h"
#include "telemetry/channel.h"
#include "widgets/common/theme.h"

#include <QString>

namespace mb {

/// A unit as it is shown: value in the units of docs/names.md#units × `scale` = what stands on the screen.
struct ShownUnit {
    double scale = 1.0;
    QString text;
    int decimals = 0; ///< that mean something to a person
};

/// How a person wants to see counts. Everything behind the screen stays in the units of docs/names.md#units.
struct DisplayUnits {
    double countsPerRevolution = 4096.0;
    bool revolutions = false; ///< rpm and degrees instead of counts/s and counts

    friend bool operator==(const DisplayUnits &, const DisplayUnits &) = default;
};

[[nodiscard]] ShownUnit shownUnit(Quantity quantity, std::string_view unit, const DisplayUnits &units);
[[nodiscard]] ShownUnit shownUnit(const Channel &row, const DisplayUnits &units);
/// Of the target of a mode.
[[nodiscard]] ShownUnit shownUnit(Mode mode, const DisplayUnits &units);
/// The quantity that a mode commands; Other where there is none.
[[nodiscard]] Quantity quantityOf(Mode mode);
[[nodiscard]] TraceRole roleOf(Quantity quantity);
/// Decimals of a value of this quantity beyond which nothing is meant, however near somebody looks.
[[nodiscard]] int mostDecimals(Quantity quantity, const ShownUnit &unit);

} // namespace mb
