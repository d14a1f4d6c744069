// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"
#include "widgets/common/paintbudget.h"
#include "widgets/plots/autorange.h"
#include "widgets/plots/plotdecor.h"
#include "widgets/plots/plotframe.h"
#include "widgets/plots/tracesource.h"

#include <QElapsedTimer>
#include <QPointer>
#include <QWidget>
#include <map>
#include <memory>

class QMenu;
class QRubberBand;

namespace mb {

class PlotCursors;
struct PlotCursorRow;

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
    bool tagUnit = true;     ///< with its unit, which also stands above the axis
    int decimals = -1;       ///< of the tag; -1: four significant digits
    bool secondAxis = false; ///< against the scale at the right
    bool aligned = false;    ///< its keys count from the left edge, or from the trigger: a kept reference
    /// Where another trace has the colour of the role already.
    std::optional<TraceRole> colour{};

    [[nodiscard]] TraceLook look() const { return {role, dash, marker, emphasis, colour}; }
};

/// A level that is watched for, in the strip of a trace.
struct PlotTrigger {
    int trace = 0;
    double level = 0.0; ///< in the unit that is shown
    QString text;
};

struct StripStyle {
    QString title;
    double stretch = 1.0;
    bool legend = true; ///< names and swatches above the strip; without them and a title it has a low head
};

/// Strips of traces above one time axis, in one QCustomPlot. Live, it follows the present; paused, it can be zoomed and
/// moved. Nothing is fetched or drawn while it cannot be seen. GUI thread. Keys are seconds on any one time line.
class PlotStack : public QWidget {
    Q_OBJECT
public:
    explicit PlotStack(const ThemeSource &theme, QWidget *parent = nullptr);
    ~PlotStack() override;

    void setStrip(int strip, const StripStyle &style);
    /// The number that the other functions take; never used twice.
    int addTrace(const TraceStyle &style, std::shared_ptr<const TraceSource> source);
    const TraceStyle *style(int trace) const;
    void setSource(int trace, std::shared_ptr<const TraceSource> source);
    void setTraceVisible(int trace, bool visible);
    void removeTrace(int trace);
    /// All traces and strips.
    void clear();
    int traceCount() const { return static_cast<int>(m_traces.size()); }

    /// Length of the time axis in seconds (1 ms … 1 day).
    void setWindow(double seconds);
    double window() const { return m_window; }
    void setLive(bool live);
    bool isLive() const { return m_live; }
    /// Shows this stretch of time and stops following.
    void setRange(double from, double to);
    std::pair<double, double> range() const;
    /// All data of all traces, when they are finite, and every value axis fitted anew. Key 0.
    void fit();
    /// While live, shows the window around this key instead of the present, `before` (0 … 1) of it earlier; empty
    /// follows the present again.
    void hold(std::optional<double> key, double before);
    std::optional<double> heldKey() const { return m_held; }
    /// A fixed value axis; empty returns to following the data.
    void setValueRange(int strip, std::optional<std::pair<double, double>> range);

    /// Time of day on the axis, given the Unix time of key 0; empty: seconds.
    void setClock(std::optional<double> unixAtZero);
    /// Left end of the foot line, for example "t = 0 at measured duty edge". Empty shows live or paused and the window.
    void setFootNote(const QString &text);
    /// "DEMO" behind every strip and in every export.
    void setWatermark(const QString &text);
    QString watermark() const { return m_watermark; }
    void setLimits(int strip, std::vector<PlotLimit> limits);
    void setBands(int strip, std::vector<PlotBand> bands);
    void setSpans(int strip, std::vector<PlotSpan> spans);
    void setNotes(int strip, std::vector<PlotNote> notes);
    /// Notes at a time, through all strips.
    void setMarks(std::vector<PlotMark> marks);
    /// The level that a trigger waits for; its handle can be dragged.
    void setTrigger(const std::optional<PlotTrigger> &trigger);
    /// Instead of "live" or "paused" in the foot line. Empty returns to them.
    void setStateText(const QString &text);
    /// Things of this MIME type can be dropped on a strip: see dropped().
    void acceptDrops(const QString &mimeType);

    /// Two lines A and B with the differences between them. Key L.
    void setCursorsShown(bool shown);
    bool cursorsShown() const;
    std::pair<double, double> cursorKeys() const;
    void setCursorKeys(double a, double b);
    /// Beside the cursors: both times, and the value of each trace at both, instead of the differences.
    void setCursorValues(bool both) { m_bothValues = both; }
    /// What the box beside the cursors says, a line each.
    [[nodiscard]] QStringList cursorWords() const;
    /// Of the samples between A and B.
    std::optional<TraceSource::Statistics> selection(int trace) const;
    /// Value of a trace at a key, from what is drawn; NaN outside and in a gap.
    double valueAt(int trace, double key) const;

    /// The middle of what is seen of a trace.
    std::optional<double> middleOf(int trace) const;
    /// Only the time goes on, nothing is fetched: while another view is shown instead.
    void follow(double now) { followPresent(now); }
    /// Of everything that is drawn around this stack: a tick that is not due is left out.
    [[nodiscard]] PaintBudget &budget() { return m_budget; }
    /// Call it on a 60 Hz tick. `now` is the present on the time line of the keys.
    void refresh(double now);

    /// Writes the picture, or the visible data as a table. The kind follows from the suffix: png, svg, pdf, csv.
    /// False when the file cannot be written or the suffix is another.
    Result<void> exportTo(const QString &path);
    /// The content of such a file of a picture: png, svg, pdf. Empty when it cannot be painted.
    [[nodiscard]] QByteArray pictureAs(const QString &kind);
    /// Adds the entries of the context menu.
    void fillMenu(QMenu &menu);
    /// Everything that is seen, in words: for a screen reader, for copying.
    QString summary() const;
    /// A and B (or both ends of what is seen), difference and statistics of every trace: a table with tabs.
    QString numbers() const;
    /// Whether the menu offers a table of what is seen; a page that exports more says no.
    void setOwnTable(bool own) { m_ownTable = own; }

    PlotFrame &plot() { return *m_plot; }

Q_SIGNALS:
    void liveChanged(bool live);
    void windowChanged(double seconds);
    void cursorsChanged();
    /// What was dropped, and on which strip; -1 below them.
    void dropped(const QByteArray &data, int strip);
    /// Somebody wants to write something at this time.
    void noteRequested(double key);
    void triggerLevelMoved(double level);
    /// A context menu is about to open over a strip (−1: none) at a time; a page adds its entries.
    void menuRequested(QMenu *menu, int strip, double key);
    /// Every chosen export ends in one of these.
    void exported(const QString &path);
    /// In words, with the cause.
    void exportFailed(const QString &cause);

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    void showEvent(QShowEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dragMoveEvent(QDragMoveEvent *event) override;
    void dropEvent(QDropEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    QSize sizeHint() const override;

private:
    struct Trace {
        TraceStyle style;
        std::shared_ptr<const TraceSource> source;
        TracePlottable *plottable = nullptr;
        bool visible = true;
    };
    struct Strip {
        StripStyle style;
        QCPAxisRect *rect = nullptr;
        AutoRange range;
        std::optional<std::pair<double, double>> fixed;
        AutoRange secondRange;
        std::optional<std::pair<double, double>> secondFixed;
        StripDecor decor;

        QCPAxis &axis(bool second) const { return *rect->axis(second ? QCPAxis::atRight : QCPAxis::atLeft); }
    };

    // plotstack.cpp
    void buildPlot();
    void ensureStrip(int strip);
    std::unique_ptr<Strip> makeStrip();
    void rebuildLayout();
    void restyle();
    void styleStrip(Strip &strip, bool last) const;
    void updateHeads();
    /// Something changed: draws soon, also when nobody ticks.
    void touch();
    // plotrefresh.cpp
    bool followPresent(double now);
    int plotWidth() const;
    /// What changes while only time goes on.
    QRegion movingPart() const;
    void fetch();
    void fetchTrace(Trace &trace, double from, double to, int pixels);
    void updateStrip(int index, double to);
    void updateAxis(Strip &strip, int index, bool second, double to);
    double origin() const { return m_held.value_or(m_from); }
    void updateTags(Strip &strip, int index);
    void updateFoot();
    void updateCursorRows();
    void addStatistics(std::vector<PlotCursorRow> &rows, int id) const;
    QString valueText(const TraceStyle &style, double value) const;
    QString tagText(const TraceStyle &style, double value) const;
    int tagMargin() const;
    // plotinteraction.cpp
    void connectMouse();
    void wheel(QWheelEvent *event);
    void mousePress(QMouseEvent *event);
    void mouseMove(QMouseEvent *event);
    void mouseRelease(QMouseEvent *event);
    void zoomTime(double factor, std::optional<double> around);
    void zoomValue(int strip, double factor, double aroundPixel);
    void pan(double seconds);
    bool cursorKey(QKeyEvent &event);
    // plotzoom.cpp
    void beginBox(const QPoint &at);
    void endBox(const QPoint &at);
    bool overTrigger(const QPoint &at) const;
    void dragTrigger(const QPoint &at);
    bool valueKey(int key);
    void zoomValues(double factor);
    bool timeKey(int key);
    void backToLive();
    int stripAt(const QPoint &position) const;
    double keyAt(int x) const;
    // plotexport.cpp
    [[nodiscard]] QByteArray table() const;
    void chooseExport(const QString &suffix, const QString &filter);
    void announce();

    const ThemeSource &m_theme;
    PlotFrame *m_plot = nullptr;
    QCPMarginGroup *m_margins = nullptr;
    QPointer<PlotFoot> m_foot;
    QSharedPointer<TimeTicker> m_timeTicker;
    std::optional<double> m_unixAtZero;
    PlotCursors *m_cursors = nullptr;
    std::vector<std::unique_ptr<Strip>> m_strips;
    std::map<int, Trace> m_traces;
    int m_nextTrace = 0;
    double m_window = 12.0;
    double m_from = 0.0;
    double m_to = 12.0;
    double m_now = 0.0;
    bool m_live = true;
    bool m_dirty = true;
    bool m_scaled = false; ///< a value axis has changed
    bool m_pending = false;
    QElapsedTimer m_wordsSince;
    PaintBudget m_budget;
    std::vector<PlotPoint> m_scratch;
    QString m_footNote;
    QString m_watermark;
    std::optional<QPoint> m_drag;
    std::optional<bool> m_draggedCursor; ///< true: B
    bool m_lastCursor = true;            ///< which one the arrow keys move
    bool m_draggedTrigger = false;
    QPoint m_boxStart;
    QRubberBand *m_box = nullptr;
    std::optional<double> m_held; ///< key of a trigger
    double m_heldBefore = 0.5;
    std::optional<PlotTrigger> m_trigger;
    std::vector<PlotMark> m_marks;
    QString m_stateText;
    QString m_dropType;
    bool m_ownTable = true;
    bool m_bothValues = false;
};

} // namespace mb
