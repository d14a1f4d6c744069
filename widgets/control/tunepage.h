// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/selection.h"
#include "widgets/common/stateglyph.h"
#include "widgets/control/arming.h"
#include "widgets/control/setpointslew.h"
#include "widgets/control/steplog.h"
#include "widgets/parameters/stagededits.h"
#include "widgets/plots/displayunits.h"

#include <QTimer>
#include <QWidget>

#include <map>
#include <memory>
#include <set>

class QLabel;
class QStackedWidget;

namespace mb {

class CommandButton;
class ElidedLabel;
class EmptyState;
class GainsPanel;
class ModePanel;
class MovesPanel;
class SetPointPanel;
class StateGlyph;
class StepTable;
class TunePlot;

/// Moves one motor and tunes its loop: mode, set-point and gains at the left, what happens at the right. Every motion goes
/// through Arming; a change of device, mode, running slot or direction disarms (tuning.md 5.1). Gains are staged and
/// written as a set, in an order that is never livelier than before and after.
class TunePage : public QWidget {
    Q_OBJECT
public:
    TunePage(Workbench &workbench, Selection &selection, Arming &arming, const ThemeSource &theme, QWidget *parent);
    ~TunePage() override;

    /// What the page says above everything else, and whether Run does something now.
    struct Status {
        GlyphState glyph = GlyphState::Gone;
        QString cause;
        QString remedy;
        bool mayRun = false;
    };
    [[nodiscard]] Status status() const;

    /// Writes what is staged for the running slot, then starts, or applies what is chosen to a motor that moves.
    void run();
    /// Writes the gains that are staged; does not start anything.
    void write();
    void halt();
    /// Stops the motor and lets its position count from 0; Run starts it again.
    void zero();

    [[nodiscard]] ModePanel &modePanel() { return *m_modes; }
    [[nodiscard]] SetPointPanel &setPointPanel() { return *m_setPoint; }
    [[nodiscard]] GainsPanel &gainsPanel() { return *m_gains; }
    [[nodiscard]] MovesPanel &movesPanel() { return *m_moves; }
    [[nodiscard]] TunePlot &plot() { return *m_plot; }

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    /// What a person has chosen for one device.
    struct Choice {
        Mode mode = Mode::Velocity;
        int editedSlot = 0;
        int runningSlot = 0;
        DisplayUnits units;
        double profiled = 0.0; ///< counts per revolution that the device's profile had last
        std::unique_ptr<StagedEdits> edits;
        StepLog steps;
    };
    QWidget *buildLive();
    QWidget *buildCommands();
    QWidget *buildColumn();
    QWidget *buildWriteRow();
    void connectPanels();
    void buildKeys();

    [[nodiscard]] const DeviceView *device() const;
    [[nodiscard]] Choice *choice();
    void selectionChanged();
    void follow();
    void wishRates(const DeviceView *view);
    void followDevice(const DeviceView &view);
    void followSteps(const DeviceView &view, bool anyway);
    void useGains(const StepRecord &record);
    void followGains(const DeviceView &view);
    void followForeignRun(const DeviceView &view);
    [[nodiscard]] Status liveStatus(const DeviceView &view, const QString &name) const;
    void showCommands();
    void showEmpty(const DeviceView *view);
    void readOnce(const DeviceView &view);
    void disarmBecause(const QString &what);
    void modeChosen(Mode mode);
    void slotsChosen();
    void unitsChosen(const DisplayUnits &units);

    [[nodiscard]] SetPoint wanted() const;
    [[nodiscard]] std::optional<double> present(const DeviceView &view) const;
    [[nodiscard]] QString describe(const SetPoint &setPoint) const;
    void start();
    [[nodiscard]] double whereItIs(const DeviceView &view) const;
    void applyTarget();
    void slewTick();
    void send(double target);
    void writeThen(std::function<void()> next);

    Workbench &m_workbench;
    Selection &m_selection;
    Arming &m_arming;
    const ThemeSource &m_theme;
    std::map<DeviceId, Choice> m_choices;
    std::set<DeviceId> m_asked;
    DeviceId m_shown;
    bool m_ours = false; ///< the motion was started here
    bool m_writing = false;
    std::uint64_t m_editRevision = 0;
    QString m_rowsShown;
    SetPoint m_base; ///< what was sent last
    SetPointSlew m_slew;
    QTimer m_slewTimer;
    QStackedWidget *m_stack = nullptr;
    EmptyState *m_empty = nullptr;
    StateGlyph *m_glyph = nullptr;
    QLabel *m_cause = nullptr;
    ElidedLabel *m_remedy = nullptr;
    CommandButton *m_halt = nullptr;
    CommandButton *m_run = nullptr;
    ModePanel *m_modes = nullptr;
    SetPointPanel *m_setPoint = nullptr;
    MovesPanel *m_moves = nullptr;
    GainsPanel *m_gains = nullptr;
    CommandButton *m_write = nullptr;
    CommandButton *m_revert = nullptr;
    TunePlot *m_plot = nullptr;
    StepTable *m_steps = nullptr;
};

} // namespace mb
