// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/reportunit.h"

namespace mb {

/// One number of a model, as reports and the window name it.
struct ModelFigure {
    QString name;
    QString symbol; ///< for where there is no room for a name; empty: it has none
    double value = 0.0;
    std::optional<double> error; ///< its ±; nothing: none is known
    int digits = 4;              ///< significant ones that it is told with
    QString unit;
};

/// Gain, lag, dead time and friction of the loop that a tuning stands on; then, as far as it has seen them, the breakaway of each direction,
/// the load that pulls one way, the gain of each direction, the noise at rest and the time from an order to its motion. `phrase` as in Report.
[[nodiscard]] std::vector<ModelFigure> modelFigures(
    const tuning::TuneReport &report, const std::function<QString(const Message &)> &phrase);

/// The length of a window is worded by the caller.
[[nodiscard]] QString filterWords(tuning::VelocityFilter::Kind kind, const QString &window);
/// What set-points may ask for; both with their units.
[[nodiscard]] QString profileWords(const QString &speed, const QString &acceleration);

} // namespace mb
