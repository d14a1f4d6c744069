// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/trace.h"

#include <QString>

#include <vector>

namespace mb {

/// A curve of a drawing.
struct SvgCurve {
    QString name; ///< in the legend; empty: it has no entry there
    QString colour;
    QString dash; ///< as stroke-dasharray; empty: solid
    tuning::Trace trace;
};

/// One axis of values over the common axis at the bottom.
struct SvgPane {
    QString label;
    std::vector<SvgCurve> curves;
    int height = 150; ///< px of the curves
};

struct SvgPlot {
    std::vector<SvgPane> panes;
    QString label;            ///< of the common axis
    bool logarithmic = false; ///< the common axis
    QString mark;             ///< across each pane, pale
    QString description;      ///< for those who do not see it
};

constexpr int svgWidth = 656; ///< px: a page of A4 at 96 dpi between its margins

/// One `<svg>` element of SVG Tiny, lines and words only. Curves are thinned out to two points a pixel; what lies outside their
/// pane is cut off. Empty where no pane has two points.
[[nodiscard]] QString svgOf(const SvgPlot &plot);

} // namespace mb
