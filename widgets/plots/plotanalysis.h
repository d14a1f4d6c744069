// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plots/curveplot.h"
#include "widgets/plots/telemetrysource.h"

namespace mb {

/// A trace as the views beside the time plot take it.
struct AnalysedTrace {
    std::shared_ptr<const TelemetrySource> source;
    QString name;
    QString unit;
    TraceLook look;
};

struct Analysis {
    std::vector<Curve> curves;
    QString note; ///< what was taken, and what was found
};

/// Amplitude against frequency of each trace between two keys, at most `most` of its newest samples.
[[nodiscard]] Analysis spectra(const std::vector<AnalysedTrace> &traces, double from, double to, std::size_t most);
/// One trace against another: a point for each sample of `y`, `x` on the line between its samples.
[[nodiscard]] Analysis against(const AnalysedTrace &x, const AnalysedTrace &y, double from, double to);

} // namespace mb
