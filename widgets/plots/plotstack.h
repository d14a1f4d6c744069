// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/paintbudget.h"
#include "widgets/plots/plotexport.h"
#include "widgets/plots/plotfeed.h"
#include "widgets/plots/plotinput.h"

#include <QElapsedTimer>
#include <QWidget>

namespace mb {

/// Strips of traces above one time axis, in one QCustomPlot. Live, it follows the present; paused, it can be zoomed and
/// moved. Nothing is fetched or drawn while it cannot be seen. GUI thread. Keys are seconds on any one time line.
class PlotStack : public QWidget {
    Q_OBJECT
public:
    explicit PlotStack(const ThemeSource &theme, QWidget *parent = nullptr);

    [[nodiscard]] PlotStrips &strips() { return *m_strips; }
    [[nodiscard]] const PlotStrips &strips() const { return *m_strips; }
    [[nodiscard]] PlotView &view() { return *m_view; }
    [[nodiscard]] const PlotView &view() const { return *m_view; }
    [[nodiscard]] PlotReadings &readings() { return m_readings; }
    [[nodiscard]] const PlotReadings &readings() const { return m_readings; }
    [[nodiscard]] PlotExport &exporter() { return *m_exporter; }
    [[nodiscard]] PlotInput &input() { return *m_input; }
    [[nodiscard]] PlotFrame &plot() { return *m_plot; }

    /// All data of all traces, when they are finite, and every value axis fitted anew. Key 0.
    void fit();
    /// Left end of the foot line, for example "t = 0 at measured duty edge". Empty shows live or paused and the window.
    void setFootNote(const QString &text);
    /// Instead of "live" or "paused" in the foot line. Empty returns to them.
    void setStateText(const QString &text);

    /// Two lines A and B with the differences between them. Key L.
    void setCursorsShown(bool shown);
    [[nodiscard]] bool cursorsShown() const;
    [[nodiscard]] std::pair<double, double> cursorKeys() const;
    void setCursorKeys(double a, double b);

    /// Only the time goes on, nothing is fetched: while another view is shown instead.
    void follow(double now) { m_view->follow(now, m_strips->width()); }
    /// Of everything that is drawn around this stack: a tick that is not due is left out.
    [[nodiscard]] PaintBudget &budget() { return m_budget; }
    /// Call it on a 60 Hz tick. `now` is the present on the time line of the keys.
    void refresh(double now);
    /// Adds the entries of the context menu.
    void fillMenu(QMenu &menu);

Q_SIGNALS:
    void cursorsChanged();
    /// The tags say the newest values now: what repeats them elsewhere follows, so that both agree.
    void wordsUpdated();
    /// A context menu is about to open over a strip (−1: none) at a time; a page adds its entries.
    void menuRequested(QMenu *menu, int strip, double key);

protected:
    bool event(QEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    [[nodiscard]] QSize sizeHint() const override;

private:
    void connectParts();
    /// Something changed: draws soon, also when nobody ticks.
    void touch();
    void announce();

    const ThemeSource &m_theme;
    PlotFrame *m_plot;
    PlotStrips *m_strips;
    PlotView *m_view;
    PlotReadings m_readings;
    PlotFeed m_feed;
    PlotExport *m_exporter;
    PlotInput *m_input;
    bool m_dirty = true;
    bool m_pending = false;
    QElapsedTimer m_wordsSince;
    PaintBudget m_budget;
};

} // namespace mb
