// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <limits>
#include <optional>
#include <vector>

namespace mb {

/// One point of a trace. `key` is in seconds on the time line of the plot; a `value` that is NaN ends the line: a gap
/// begins at its key and lasts until the key of the next finite point.
struct PlotPoint {
    double key = 0.0;
    double value = std::numeric_limits<double>::quiet_NaN();

    static PlotPoint gap(double key) { return {key, std::numeric_limits<double>::quiet_NaN()}; }
};

/// Where a trace comes from. Called on the GUI thread only, while the plot is visible.
class TraceSource {
public:
    virtual ~TraceSource() = default;
    /// Replaces `points` with what lies in from … to, in order of time, at most four points (first, smallest, largest,
    /// last, in their order) for each of the `pixels` columns, plus the nearest point on either side where there is
    /// one. The columns start at `from`, which the plot anchors to absolute time.
    virtual void columns(double from, double to, int pixels, std::vector<PlotPoint> &points) const = 0;
    /// The newest value, for the label at the right edge; empty when it is not known any more.
    virtual std::optional<double> latest() const = 0;
    /// Rate and loss, translated: "100 Hz, 0 of 6400 lost". Empty shows nothing.
    virtual QString foot() const = 0;
    /// Of the samples between two keys, in the unit that is shown; empty when there are none, or where the source keeps
    /// only what it draws.
    struct Statistics {
        std::size_t count = 0;
        std::uint64_t lost = 0;
        double mean = 0.0;
        double deviation = 0.0;
        double rms = 0.0;
        double low = 0.0;
        double high = 0.0;
    };
    virtual std::optional<Statistics> statistics(double, double) const { return {}; }
    /// On the line between the samples on either side of a key: not a number in a gap and beyond both ends. Nothing where the
    /// source keeps only what it draws.
    virtual std::optional<double> valueAt(double) const { return {}; }
    /// Samples are missing: the foot line turns to caution.
    virtual bool lossy() const { return false; }
};

} // namespace mb
