// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/pagerates.h"
#include "widgets/plots/plotlayoutbook.h"
#include "widgets/plots/triggercontrol.h"

class QStackedWidget;

namespace mb {

class AgainstView;
class CurvePlot;
class ExportBar;
class PlotScrubber;
class PlotsBar;
class Recorder;
class ReplayBar;
class SpectrumView;
class TracePanel;

/// Signals of any devices against time, against frequency, or against each other, live: what is plotted and what could be
/// at the right, the whole session below. Puts its parts together, and fetches and draws only while it is visible and
/// something is new. GUI thread.
class PlotsPage : public QWidget {
    Q_OBJECT
public:
    enum class View { Time, Against, Spectrum };

    PlotsPage(Workbench &workbench, Selection &selection, const ThemeSource &theme, QWidget *parent);

    /// Each in the pane of its unit; what is there already stays.
    void addSignals(const std::vector<Signal> &wanted);
    void addSignal(const Signal &signal) { m_board->choose(signal, true); }
    void removeSignal(const Signal &signal) { m_board->choose(signal, false); }
    [[nodiscard]] std::size_t traceCount() const { return m_board->traces().size(); }
    [[nodiscard]] PlotStack &stack() { return *m_stack; }
    [[nodiscard]] PlotBoard &board() { return *m_board; }
    [[nodiscard]] TracePanel &panel() { return *m_panel; }
    [[nodiscard]] TriggerControl &trigger() { return *m_trigger; }
    [[nodiscard]] PlotLayoutBook &layoutBook() { return m_layoutBook; }
    [[nodiscard]] ExportBar &exportBar() { return *m_exportBar; }
    [[nodiscard]] CurvePlot &curves(View view);

    void showView(View view);
    /// What its button Export offers.
    void fillExportMenu(QMenu &menu);
    /// Where layouts are kept; see PlotLayoutBook::setFolder().
    void setLayoutFolder(const QString &folder);
    /// The recording that runs; the button and R appear with it.
    void setRecorder(Recorder *recorder, const QString &folder);

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    /// Signals that are dropped where no strip is.
    bool eventFilter(QObject *watched, QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    struct Drawn {
        std::uint64_t revision = 0; ///< of the board
        double at = 0.0;            ///< s
    };

    QWidget *buildContent();
    QWidget *buildPlots();
    void connectParts();
    void addKeys();
    void addMenuEntries(QMenu &menu, double key);
    void newDerived();
    void newNote(double key);
    void follow();
    void boardChanged();
    void draw();
    void refreshView(double now);

    Workbench &m_workbench;
    PageRates m_rates{m_workbench};
    const ThemeSource &m_theme;
    Drawn m_drawn;
    double m_analysedAt = -1.0;
    QTimer m_tick;
    PlotStack *m_stack;
    PlotBoard *m_board;
    PlotLayoutBook m_layoutBook;
    TriggerControl *m_trigger = nullptr;
    QStackedWidget *m_pages = nullptr;
    QStackedWidget *m_plots = nullptr;
    PlotsBar *m_bar = nullptr;
    ExportBar *m_exportBar = nullptr;
    AgainstView *m_against = nullptr;
    SpectrumView *m_spectrum = nullptr;
    PlotScrubber *m_scrubber = nullptr;
    TracePanel *m_panel = nullptr;
    ReplayBar *m_replay = nullptr;
};

} // namespace mb
