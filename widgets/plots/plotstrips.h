// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plots/plotfoot.h"
#include "widgets/plots/plotstrip.h"
#include "widgets/plots/tracesource.h"

#include <QPointer>
#include <map>
#include <memory>

namespace mb {

class PlotCursors;

/// A trace of a stack. Strips count from 0 at the top and appear with their first trace.
struct TraceStyle {
    QString name;
    QString unit;
    TraceRole role = TraceRole::Neutral;
    int strip = 0;
    TraceDash dash = TraceDash::Automatic;
    TraceMarker marker = TraceMarker::Automatic;
    bool emphasis = false;   ///< heavier; only for traces that stand still
    bool valueTag = true;    ///< newest value at the right edge (never for set-points)
    int decimals = -1;       ///< of the tag; -1: what its axis tells apart …
    int mostDecimals = 6;    ///< … but no more than mean something of its quantity
    bool secondAxis = false; ///< against the scale at the right
    bool aligned = false;    ///< its keys count from the left edge, or from the trigger: a kept reference
    /// Where another trace has the colour of the role already.
    std::optional<TraceRole> colour{};

    [[nodiscard]] TraceLook look() const { return {role, dash, marker, emphasis, colour}; }
};

/// A trace as it stands in a stack.
struct PlotTrace {
    TraceStyle style;
    std::shared_ptr<const TraceSource> source;
    TracePlottable *plottable = nullptr; ///< belongs to the plot
    bool visible = true;

    /// What is to be added to its own keys; see PlotView::origin().
    [[nodiscard]] double shift(double origin) const { return style.aligned ? origin : 0.0; }
    /// In this strip, against this axis, and seen.
    [[nodiscard]] bool isSeenIn(int strip, bool second) const
    {
        return visible && style.strip == strip && style.secondAxis == second;
    }
};

/// A level that is watched for, in the strip of a trace.
struct PlotTrigger {
    int trace = 0;
    double level = 0.0; ///< in the unit that is shown
    QString text;
};

/// The strips of a stack, one below the other in one QCustomPlot, with their traces and all words and lines around these.
/// Fetches nothing: see PlotFeed. GUI thread.
class PlotStrips : public QObject {
    Q_OBJECT
public:
    PlotStrips(PlotFrame &plot, const ThemeSource &theme);

    void setStrip(int strip, const StripStyle &style);
    /// The number that the other functions take; never used twice.
    int addTrace(const TraceStyle &style, std::shared_ptr<const TraceSource> source);
    void setSource(int trace, std::shared_ptr<const TraceSource> source);
    void setTraceVisible(int trace, bool visible);
    void removeTrace(int trace);
    /// All traces and strips.
    void clear();
    /// Null for a number that is not there.
    [[nodiscard]] const PlotTrace *trace(int trace) const;
    [[nodiscard]] const std::map<int, PlotTrace> &traces() const { return m_traces; }
    [[nodiscard]] int traceCount() const { return static_cast<int>(m_traces.size()); }

    /// A fixed value axis; empty returns to following the data.
    void setValueRange(int strip, std::optional<std::pair<double, double>> range);
    /// What the time axis says: the time of day, or seconds.
    [[nodiscard]] TimeTicker &times() { return *m_timeTicker; }
    [[nodiscard]] const std::optional<WallClock> &clock() const { return m_timeTicker->clock(); }
    /// "DEMO" behind every strip and in every export.
    void setWatermark(const QString &text);
    [[nodiscard]] QString watermark() const { return m_watermark; }
    /// Puts these in the place of all of their kind in a strip: PlotLimit, PlotBand, PlotSpan or PlotNote.
    template <typename Annotation> void annotate(int strip, std::vector<Annotation> all)
    {
        ensure(strip);
        at(strip).decor.all<Annotation>() = std::move(all);
        updateHeads();
    }
    /// Notes at a time, through all strips.
    void setMarks(std::vector<PlotMark> marks);
    /// The level that a trigger waits for; its handle can be dragged.
    void setTrigger(const std::optional<PlotTrigger> &trigger);
    [[nodiscard]] const std::optional<PlotTrigger> &trigger() const { return m_trigger; }

    [[nodiscard]] const std::vector<std::unique_ptr<PlotStrip>> &all() const { return m_strips; }
    [[nodiscard]] PlotStrip &at(int strip) const { return *m_strips.at(static_cast<std::size_t>(strip)); }
    /// Of the axes, in pixels; 0 without a strip.
    [[nodiscard]] int width() const { return m_strips.empty() ? 0 : m_strips.front()->rect().width(); }
    /// Which strip lies at a point of the plot; -1 below them.
    [[nodiscard]] int stripAt(const QPoint &position) const;
    [[nodiscard]] double keyAt(int x) const
    {
        return m_strips.empty() ? 0.0 : m_strips.front()->keys().pixelToCoord(x);
    }
    [[nodiscard]] PlotCursors &cursors() const { return *m_cursors; }
    [[nodiscard]] PlotFoot *foot() const { return m_foot; }

Q_SIGNALS:
    /// Something else is to be drawn.
    void changed();

private:
    void ensure(int strip);
    void rebuildLayout();
    void restyle();
    /// Also says that something changed.
    void updateHeads();

    PlotFrame &m_plot;
    const ThemeSource &m_theme;
    QCPMarginGroup *m_margins = nullptr;
    QSharedPointer<TimeTicker> m_timeTicker;
    QPointer<PlotFoot> m_foot;
    PlotCursors *m_cursors = nullptr;
    std::vector<std::unique_ptr<PlotStrip>> m_strips;
    std::map<int, PlotTrace> m_traces;
    int m_nextTrace = 0;
    QString m_watermark;
    std::vector<PlotMark> m_marks;
    std::optional<PlotTrigger> m_trigger;
};

} // namespace mb
