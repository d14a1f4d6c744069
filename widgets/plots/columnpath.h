// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plots/tracesource.h"

#include <QLineF>
#include <QPolygonF>
#include <QVector>
#include <algorithm>
#include <utility>

namespace mb {

/// Seconds and units to pixels: x = key · keyScale + keyOffset. `columnWidth` is 1 / device pixel ratio.
struct PixelMap {
    double keyScale = 1.0;
    double keyOffset = 0.0;
    double valueScale = 1.0;
    double valueOffset = 0.0;
    double columnWidth = 1.0;

    double x(double key) const { return key * keyScale + keyOffset; }
    /// Kept within what the painter can clip without loss of speed.
    double y(double value) const { return std::clamp(value * valueScale + valueOffset, -16000.0, 16000.0); }
};

/// What to draw for a trace: lines where points are sparse, one vertical span for each column where they are dense.
/// Neighbouring spans overlap, so that the trace has no holes.
struct ColumnPath {
    QVector<QPolygonF> lines;
    QVector<QLineF> spans;

    bool isEmpty() const { return lines.isEmpty() && spans.isEmpty(); }
};

ColumnPath columnPath(const std::vector<PlotPoint> &points, const PixelMap &map);

/// The gaps as intervals of keys; one that is still open ends at `to`.
std::vector<std::pair<double, double>> gapsOf(const std::vector<PlotPoint> &points, double to);

/// The value at a key: on the line between its neighbours; NaN outside and in a gap.
double valueAt(const std::vector<PlotPoint> &points, double key);

/// Smallest and largest finite value between two keys; empty when there is none.
std::optional<std::pair<double, double>> valueRange(const std::vector<PlotPoint> &points, double from, double to);

} // namespace mb
