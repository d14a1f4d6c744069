// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/selection.h"
#include "widgets/control/arming.h"
#include "widgets/control/experimentplan.h"
#include "widgets/control/setpointpanel.h"
#include "widgets/control/statusline.h"
#include "widgets/parameters/editdesk.h"
#include "widgets/plots/displayunits.h"

#include <QTimer>
#include <QWidget>

#include <map>
#include <memory>
#include <set>

class QLabel;
class QStackedWidget;

namespace mb {

class AxesPanel;
class BatteryDialog;
class CommandButton;
class EmptyState;
class EnvelopePanel;
class GainsPanel;
struct KeptTrial;
class JogKeys;
class JogPanel;
class ModePanel;
class MovesPanel;
class PlotStack;
class ReportOrder;
class Segmented;
class StimulusBar;
class TrialsView;
class TuneFrame;
class TunePlot;

/// Tunes the loop of one motor by experiments: stimulus above, gains at the left, what the trials did at the right. Its live
/// view drives the motor by hand: mode, set-point, what happens now. Of a board with several axes it is about the selected
/// one; Run starts several at the same moment by hand, and tries them one after the other. Every motion goes through Arming; a change of device, mode, running slot or direction disarms. Gains are staged and
/// written as a set, in an order that is never livelier than before and after.
class TunePage : public QWidget {
    Q_OBJECT
public:
    TunePage(Workbench &workbench, Selection &selection, Arming &arming, const ThemeSource &theme, QWidget *parent);
    ~TunePage() override;

    [[nodiscard]] PageStatus status() const;

    /// As if the mode was chosen and the target typed, in units of docs/names.md#units.
    void choose(Mode mode, double target);
    /// The live view instead of the experiments.
    void showLive(bool live);
    [[nodiscard]] bool isLive() const;
    /// As if the stimulus was chosen.
    /// The units that each motor has until somebody chooses others for it here.
    void setRevolutions(bool on);
    void chooseStimulus(Mode mode, const StimulusChoice &stimulus);
    /// Writes what is staged for the running slot, then runs the experiment. In the live view starts, or applies what is
    /// chosen to a motor that moves.
    void run();
    /// The same with so many repeats; in the live view as run().
    void runRepeated(int repeats);
    /// Writes the gains that are staged; does not start anything.
    void write();
    void halt();
    /// Stops the motor and lets its position count from 0; Run starts it again.
    void zero();
    /// The last edit of the gains that are shown is taken back, or made again.
    void undo(bool again);
    /// Has the device blink, where it can; nothing moves.
    void identify();
    /// Opens the battery of steps up to the one that is chosen; F7 there runs it.
    void showBattery();
    /// Asks for a file, and writes trials A and B into it, or all of the unit where none is shown.
    void writeReport();
    /// The live view stands still, or goes on; nothing where the experiments are shown.
    void pauseLive();
    /// The plot that is in sight.
    [[nodiscard]] PlotStack &shownStack();
    /// Mode and set-point of the axis that is shown, for all that are to run together; a position as the same distance.
    void spread();

    [[nodiscard]] AxesPanel &axesPanel() { return *m_axes; }
    [[nodiscard]] ModePanel &modePanel() { return *m_modes; }
    [[nodiscard]] SetPointPanel &setPointPanel() { return *m_setPoint; }
    [[nodiscard]] GainsPanel &gainsPanel() { return *m_gains; }
    [[nodiscard]] MovesPanel &movesPanel() { return *m_moves; }
    [[nodiscard]] TunePlot &plot() { return *m_plot; }
    [[nodiscard]] TrialsView &trials() { return *m_trials; }
    [[nodiscard]] StimulusBar &stimulus() { return *m_stimulus; }
    [[nodiscard]] EnvelopePanel &envelope() { return *m_envelope; }
    [[nodiscard]] TuneFrame &frame() { return *m_frame; }

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    /// One motor: a device, or one of its axes (0 where it has one only).
    struct Place {
        DeviceId device;
        int axis = 0;
        friend auto operator<=>(const Place &, const Place &) = default;
    };
    /// What a person has chosen for one motor, and what was sent to it from here.
    struct Choice {
        Mode mode = Mode::Velocity;
        int editedSlot = 0;
        int runningSlot = 0;
        DisplayUnits units;
        double profiled = 0.0;        ///< counts per revolution that the device's profile had last
        StagedEdits *edits = nullptr; ///< of the device, shared with the other pages
        StimulusChoice stimulus;
        std::string unit;               ///< who it is in the notebook
        SetPointPanel::Entered entered; ///< of an axis that is not shown
        bool ours = false;              ///< the motion was started here
    };
    QWidget *buildWork();
    QWidget *buildLive();
    QWidget *buildCommands();
    QWidget *buildColumn();
    QWidget *buildWriteRow();
    void connectPanels();
    void foldCommands(bool folded);

    [[nodiscard]] const DeviceView *device() const;
    [[nodiscard]] Choice *choice();
    void selectionChanged();
    void follow();
    void wishRates(const DeviceView *view);
    void followDevice(const DeviceView &view);
    // tunepagetrials.cpp
    void followTrials(const DeviceView &view);
    [[nodiscard]] ExperimentWish wishOf(const DeviceView &view, int axis) const;
    [[nodiscard]] PageStatus trialStatus(const DeviceView &view, const QString &name) const;
    void checkKinds(const DeviceView &view, const Choice &chosen, Instant now);
    void viewChosen(int view);
    void stimulusChosen();
    void tryOut();
    void tryAxis(const DeviceView &view, int axis);
    void tried(const Result<tuning::Trial> &trial);
    void useGains(const KeptTrial &kept);
    void stageAdvice(const std::vector<std::pair<std::string, double>> &values);
    void followGains(const DeviceView &view);
    void followForeignRun(const DeviceView &view);
    [[nodiscard]] PageStatus liveStatus(const DeviceView &view, const QString &name) const;
    void showCommands();
    void showEmpty(const DeviceView *view);
    void readOnce(const DeviceView &view);
    void editsChanged();
    void disarmBecause(const QString &what);
    void modeChosen(Mode mode);
    void slotsChosen();
    void unitsChosen(const DisplayUnits &units);

    [[nodiscard]] SetPoint wanted() const;
    [[nodiscard]] std::optional<SetPoint> jogSetPoint(bool forwards) const;
    [[nodiscard]] std::optional<double> present(const DeviceView &view, Mode mode, int axis) const;
    [[nodiscard]] QString describe(const SetPoint &setPoint) const;
    void start();
    void startAxis(const DeviceView &view, int axis, bool several);
    [[nodiscard]] bool isAxisMoving(const DeviceView &view, int axis) const;
    void forgetMotion();
    void applyTarget();
    // tunepageaxes.cpp
    [[nodiscard]] Choice &choiceOf(const DeviceView &view, int axis);
    [[nodiscard]] int axisFor(const DeviceView &view);
    [[nodiscard]] std::vector<int> motorsOf(const DeviceView &view) const;
    void showMotor(const DeviceView &view, int axis);
    void followAxes(const DeviceView &view);
    void followFirstPower(const DeviceView &view);
    [[nodiscard]] SetPoint wantedOf(const DeviceView &view, int axis) const;
    [[nodiscard]] std::vector<int> beside() const;
    void copyGains(int from);
    [[nodiscard]] QString othersText(const DeviceView &view) const;
    void writeThen(std::function<void()> next);

    Workbench &m_workbench;
    EditDesk &m_desk;
    Selection &m_selection;
    Arming &m_arming;
    const ThemeSource &m_theme;
    bool m_revolutions = false;
    std::map<Place, Choice> m_choices;
    std::map<DeviceId, int> m_lastAxis;
    std::vector<int> m_toTry; ///< axes whose turn is still to come
    std::set<DeviceId> m_asked;
    DeviceId m_shown;
    int m_axis = 0;
    bool m_writing = false;
    std::uint64_t m_editRevision = 0;
    QString m_rowsShown;
    QStackedWidget *m_stack = nullptr;
    TuneFrame *m_frame = nullptr;
    EmptyState *m_empty = nullptr;
    StatusLine *m_status = nullptr;
    CommandButton *m_halt = nullptr;
    CommandButton *m_run = nullptr;
    AxesPanel *m_axes = nullptr;
    QWidget *m_axesLine = nullptr;
    ModePanel *m_modes = nullptr;
    JogKeys *m_jog = nullptr;
    JogPanel *m_jogPanel = nullptr;
    SetPointPanel *m_setPoint = nullptr;
    QLabel *m_firstPower = nullptr;
    MovesPanel *m_moves = nullptr;
    GainsPanel *m_gains = nullptr;
    CommandButton *m_write = nullptr;
    CommandButton *m_revert = nullptr;
    TunePlot *m_plot = nullptr;
    Segmented *m_view = nullptr;
    StimulusBar *m_stimulus = nullptr;
    BatteryDialog *m_battery = nullptr;
    ReportOrder *m_order = nullptr;
    EnvelopePanel *m_envelope = nullptr;
    QWidget *m_liveColumn = nullptr;
    QStackedWidget *m_work = nullptr;
    TrialsView *m_trials = nullptr;
};

} // namespace mb
