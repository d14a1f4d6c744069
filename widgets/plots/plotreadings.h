// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plots/plotcursors.h"
#include "widgets/plots/plotstrips.h"
#include "widgets/plots/plotview.h"

#include <QCoreApplication>

namespace mb {

/// Where something is missing in a trace up to a key. A line that a device began anew, such as with another period, is
/// broken there and nothing more.
[[nodiscard]] std::vector<std::pair<double, double>> missingIn(const PlotTrace &trace, double origin, double to);
/// Takes such breaks out of points that the source has drawn, for who keeps them without it: nobody could tell afterwards that
/// nothing is missing there.
void joinUnlost(std::vector<PlotPoint> &points, const TraceSource &source);

/// What can be read off a stack of plots: values, statistics between the cursors, words and tables of them. GUI thread.
class PlotReadings {
    Q_DECLARE_TR_FUNCTIONS(PlotReadings)
public:
    PlotReadings(const PlotStrips &strips, const PlotView &view)
        : m_strips(strips)
        , m_view(view)
    {
    }

    /// Value of a trace at a key, between its samples (TraceSource::valueAt), else from what is drawn; NaN outside and in a gap.
    [[nodiscard]] double valueAt(int trace, double key) const;
    /// The middle of what is seen of a trace.
    [[nodiscard]] std::optional<double> middleOf(int trace) const;
    /// Of the samples between A and B; empty while the cursors are hidden.
    [[nodiscard]] std::optional<TraceSource::Statistics> selection(int trace) const;
    /// With the decimals of its axis, and its unit.
    [[nodiscard]] QString valueText(const TraceStyle &style, double value) const;

    /// Beside the cursors: both times, and the value of each trace at both, instead of the differences.
    void setCursorValues(bool both) { m_bothValues = both; }
    [[nodiscard]] std::vector<PlotCursorRow> cursorRows() const;
    /// What the box beside the cursors says, a line each.
    [[nodiscard]] QStringList cursorWords() const;

    /// Everything that is seen, in words: for a screen reader, for copying.
    [[nodiscard]] QString summary() const;
    /// A and B (or both ends of what is seen), difference and statistics of every trace: a table with tabs.
    [[nodiscard]] QString numbers() const;
    /// Every sample of what is seen, as CSV. Where the axis has the time of day, that of `time_s` 0 stands before it, and what is known
    /// missing of each trace.
    [[nodiscard]] QByteArray table() const;

private:
    [[nodiscard]] QString tableHead(double from, double to) const;
    void addStatistics(std::vector<PlotCursorRow> &rows, int id) const;
    [[nodiscard]] QString summaryOf(const PlotTrace &trace) const;
    [[nodiscard]] std::pair<double, double> cursorKeys() const;

    const PlotStrips &m_strips;
    const PlotView &m_view;
    bool m_bothValues = false;
};

} // namespace mb
