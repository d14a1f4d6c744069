// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/autotune.h"
#include "widgets/common/selection.h"
#include "widgets/control/arming.h"
#include "widgets/control/statusline.h"

#include <QWidget>

#include <map>

class QStackedWidget;
class QVBoxLayout;

namespace mb {

class BodePlot;
class CommandButton;
class CurvePlot;
class EmptyState;
class EnvelopePanel;
class ModelPanel;
class ProposalCard;
class ReportOrder;
class Segmented;
class TuningSteps;

/// From an unknown motor to proven gains: the model of the selected motor, three sets of gains that it may have, what each will
/// do, and the order that writes one of them and proves it. Every motion goes through Arming.
class DesignPage : public QWidget {
    Q_OBJECT
public:
    DesignPage(Workbench &workbench, Selection &selection, Arming &arming, const ThemeSource &theme, QWidget *parent);

    [[nodiscard]] PageStatus status() const;

    void chooseLoop(Mode loop);
    void chooseAim(tuning::Aim aim);
    /// Pushes the motor and makes the model; writes nothing.
    void identify();
    /// Writes the chosen proposal, runs its steps, keeps it or puts back what was there.
    void prove();
    /// Both, with the chosen aim.
    void autotune();

    /// Asks for a file, and writes what is shown into it: the tuning, or all of the unit where there is none yet.
    void writeReport();

    [[nodiscard]] EnvelopePanel &envelope() { return *m_envelope; }
    /// Of the motor and loop that are shown; nullptr: nothing is known yet.
    [[nodiscard]] const tuning::TuneReport *report() const;

protected:
    void showEvent(QShowEvent *event) override;

private:
    struct Place {
        DeviceId device;
        int axis = 1;
        Mode loop = Mode::Velocity;
        friend auto operator<=>(const Place &, const Place &) = default;
    };
    QWidget *buildCommands();
    QWidget *buildColumn();
    QWidget *buildPlots();
    void buildKeys();

    [[nodiscard]] const DeviceView *device() const;
    [[nodiscard]] Place place() const;
    [[nodiscard]] tuning::Aim aim() const;
    [[nodiscard]] QString whyNot(const DeviceView &view) const;
    [[nodiscard]] tuning::TunePlan plan() const;
    [[nodiscard]] const tuning::Proposal *chosen() const;
    void run(tuning::TunePlan plan);
    void ended(const Place &place, const Result<tuning::TuneReport> &report);
    void follow();
    void followDevice(const DeviceView &view, const QString &whyNot);
    void followLimits(const DeviceView &view);
    void showReport();
    void showChosen();
    void showStep(const tuning::Proposal &proposal);

    Workbench &m_workbench;
    Selection &m_selection;
    Arming &m_arming;
    const ThemeSource &m_theme;
    std::map<Place, tuning::TuneReport> m_reports;
    std::map<Place, tuning::Aim> m_aims;
    Mode m_loop = Mode::Velocity;
    DeviceId m_limitsOf;          ///< whose limits stand in the panel
    std::optional<Place> m_shown; ///< whose report is on the page
    QStackedWidget *m_stack = nullptr;
    EmptyState *m_empty = nullptr;
    StatusLine *m_status = nullptr;
    Segmented *m_loops = nullptr;
    CommandButton *m_identify = nullptr;
    CommandButton *m_autotune = nullptr;
    CommandButton *m_prove = nullptr;
    ModelPanel *m_model = nullptr;
    EnvelopePanel *m_envelope = nullptr;
    QVBoxLayout *m_cards = nullptr;
    std::vector<ProposalCard *> m_proposals;
    BodePlot *m_bode = nullptr;
    CurvePlot *m_step = nullptr;
    TuningSteps *m_steps = nullptr;
    ReportOrder *m_order = nullptr;
};

} // namespace mb
