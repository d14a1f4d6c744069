// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/selection.h"
#include "widgets/common/workbench.h"
#include "widgets/plots/plotboard.h"
#include "widgets/plots/plotlayout.h"
#include "widgets/plots/plotstack.h"
#include "widgets/plots/signallist.h"
#include "widgets/plots/triggerwatch.h"

#include <QTimer>
#include <QWidget>

class QComboBox;
class QHBoxLayout;
class QLabel;
class QProgressBar;
class QStackedWidget;

namespace mb {

class CommandButton;
class CurvePlot;
class EmptyState;
class ExportJob;
class IconButton;
class PlotScrubber;
class Recorder;
class ReplayBar;
class Segmented;
class TraceList;
class TriggerBar;
struct ExportChoice;

/// Signals of any devices against time, against frequency, or against each other, live: what is plotted and what could be
/// at the right, the whole session below. Starts with position, velocity, current and duty of the selected device, or
/// with what its family's layout says. Fetches and draws only while it is visible and something is new.
class PlotsPage : public QWidget {
    Q_OBJECT
public:
    enum class View { Time, Against, Spectrum };

    PlotsPage(Workbench &workbench, Selection &selection, const ThemeSource &theme, QWidget *parent);
    ~PlotsPage() override;

    void addSignal(const Signal &signal);
    /// Each in the pane of its unit; what is there already stays.
    void addSignals(const std::vector<Signal> &wanted);
    void removeSignal(const Signal &signal);
    [[nodiscard]] std::size_t traceCount() const { return m_board->traces().size(); }
    [[nodiscard]] PlotStack &stack() { return *m_stack; }
    [[nodiscard]] PlotBoard &board() { return *m_board; }
    [[nodiscard]] SignalList &signalList() { return *m_signals; }
    [[nodiscard]] TriggerWatch &trigger() { return m_trigger; }
    [[nodiscard]] TriggerBar &triggerBar() { return *m_triggerBar; }
    [[nodiscard]] CurvePlot &curves(View view);

    void showView(View view);
    /// Shows the trigger's line and arms it on a trace; the level is the middle of what is seen unless one was typed.
    void triggerOn(int id);
    void triggerOff();
    /// Writes samples; progress and end are shown in the bar.
    void exportSamples(const ExportChoice &choice);
    /// Where layouts are kept, and what was there at the end of the last run comes back. Without it nothing is remembered.
    void setLayoutFolder(const QString &folder);
    [[nodiscard]] const PlotLayouts &layouts() const { return m_layouts; }
    [[nodiscard]] PlotLayout currentLayout() const;
    /// Traces of devices that are not there yet follow when they come.
    void applyLayout(const PlotLayout &layout);
    void resetLayout();
    /// The recording that runs; the button and R appear with it.
    void setRecorder(Recorder *recorder, const QString &folder);

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    /// Signals that are dropped where no strip is.
    bool eventFilter(QObject *watched, QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    // plotspage.cpp, plotspagebars.cpp
    QWidget *buildBar();
    void buildView(QHBoxLayout &row);
    void buildTools(QHBoxLayout &row);
    void buildRecord(QHBoxLayout &row);
    QWidget *buildPlots();
    void connectStack();
    QWidget *buildJob();
    QWidget *buildSide();
    void buildLists(QWidget &side);
    void addKeys();
    // plotspagedata.cpp
    void follow();
    void takeDefaults();
    void boardChanged();
    void showRows();
    void wishRates();
    [[nodiscard]] QString statisticsOf(const PlotBoard::Trace &trace, int decimals) const;
    void tick();
    void draw();
    void followSession(double now);
    // plotspageviews.cpp
    void buildAgainst(QWidget &parent);
    void refreshView(double now);
    void refreshSpectrum();
    void refreshAgainst();
    void fillAgainst();
    void arm();
    void showTrigger();
    void showRowMenu(int id, const QPoint &at);
    void addMenuEntries(QMenu &menu, double key);
    void newDerived();
    void newNote(double key);
    // plotspageorders.cpp
    void fillExportMenu(QMenu &menu);
    void exportView(const QString &suffix, const QString &filter);
    void fillLayoutMenu(QMenu &menu);
    void rememberLayout();
    void applyWaiting(bool first);
    [[nodiscard]] std::vector<PlotBoard::Trace> tracesOf(const PlotLayout &layout, DeviceId standIn) const;
    void followWidth();
    void toggleRecording();
    void showRecording();
    void finished(const QString &path, const Result<ExportReport> &report);

    Workbench &m_workbench;
    Selection &m_selection;
    const ThemeSource &m_theme;
    DeviceId m_defaultsOf;
    int m_defaultsOfAxis = 0;
    std::uint64_t m_drawn = 0;
    double m_drawnAt = 0.0;
    double m_analysedAt = -1.0;
    QTimer m_tick;
    QTimer m_remember;
    QStackedWidget *m_pages = nullptr;
    EmptyState *m_empty = nullptr;
    QStackedWidget *m_plots = nullptr;
    PlotStack *m_stack = nullptr;
    PlotBoard *m_board = nullptr;
    PlotScrubber *m_scrubber = nullptr;
    CurvePlot *m_spectrum = nullptr;
    QWidget *m_againstPage = nullptr;
    CurvePlot *m_against = nullptr;
    QComboBox *m_againstX = nullptr;
    QComboBox *m_againstY = nullptr;
    TriggerBar *m_triggerBar = nullptr;
    TriggerWatch m_trigger;
    Segmented *m_view = nullptr;
    QComboBox *m_window = nullptr;
    CommandButton *m_pause = nullptr;
    CommandButton *m_record = nullptr;
    QLabel *m_recordText = nullptr;
    IconButton *m_triggerButton = nullptr;
    TraceList *m_list = nullptr;
    SignalList *m_signals = nullptr;
    ExportJob *m_job = nullptr;
    QWidget *m_jobBar = nullptr;
    QProgressBar *m_progress = nullptr;
    ReplayBar *m_replay = nullptr;
    Recorder *m_recorder = nullptr;
    QString m_recordFolder;
    double m_recordedFrom = 0.0;
    PlotLayouts m_layouts;
    std::optional<PlotLayout> m_waiting; ///< traces of devices that have not come yet
};

} // namespace mb
