// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/proposals.h"
#include "widgets/common/selection.h"
#include "widgets/control/arming.h"
#include "widgets/control/statusline.h"

#include <QWidget>

#include <map>

class QStackedWidget;
class QVBoxLayout;

namespace mb {

class CommandButton;
class DesignPlots;
class EmptyState;
class EnvelopePanel;
class ModelPanel;
class OwnProposal;
class ProposalCard;
class ReportOrder;
class Segmented;
class SweepPanel;
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
    /// The set of the two sliders instead: response in s, largest sensitivity. Designed on the model that is known; nothing moves.
    void chooseOwn(double response, double ms);
    /// The slot that the result belongs to, where the family has several.
    void chooseSlot(int slot);
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
    /// What Write and prove would write; nullptr: there is nothing yet.
    [[nodiscard]] const tuning::Proposal *chosen() const;

protected:
    void showEvent(QShowEvent *event) override;

private:
    struct Place {
        DeviceId device;
        int axis = 1;
        Mode loop = Mode::Velocity;
        friend auto operator<=>(const Place &, const Place &) = default;
    };
    /// What a person has chosen for one of them.
    struct Choice {
        tuning::Aim aim = tuning::Aim::Normal;
        bool own = false;      ///< the two sliders instead of the aim
        double response = 0.0; ///< s; 0: nobody has moved them yet
        double ms = 0.0;
        int slot = 0;
    };
    QWidget *buildOrders();
    QWidget *buildColumn();
    QWidget *buildSide();
    void buildKeys();

    [[nodiscard]] const DeviceView *device() const;
    [[nodiscard]] Place place() const;
    [[nodiscard]] Choice choice() const;
    [[nodiscard]] QString whyNot(const DeviceView &view) const;
    [[nodiscard]] tuning::TunePlan plan() const;
    [[nodiscard]] tuning::ProposalBasis basisOf(const DeviceView &view) const;
    void run(tuning::TunePlan plan);
    void ended(const Place &place, const Result<tuning::TuneReport> &report);
    void follow();
    void followDevice(const DeviceView &view, const QString &whyNot);
    void followLimits(const DeviceView &view);
    void showReport();
    void showCards(const DeviceView &view);
    void designAll(const DeviceView &view);
    void designOwn();
    void ownWished();
    void showChosen();

    Workbench &m_workbench;
    Selection &m_selection;
    Arming &m_arming;
    const ThemeSource &m_theme;
    std::map<Place, tuning::TuneReport> m_reports;
    std::map<Place, Choice> m_choices;
    std::map<std::pair<DeviceId, int>, tuning::FrequencyResponse>
        m_responses;                               ///< of a device and axis, whatever the loop
    std::vector<tuning::Proposal> m_designed;      ///< of the report and slot that are shown
    std::optional<tuning::Proposal> m_ownDesigned; ///< of the sliders
    Envelope m_inForce;                            ///< what the step may use
    Mode m_loop = Mode::Velocity;
    DeviceId m_limitsOf;          ///< whose limits stand in the panel
    std::optional<Place> m_shown; ///< whose report is on the page
    QStackedWidget *m_stack = nullptr;
    EmptyState *m_empty = nullptr;
    StatusLine *m_status = nullptr;
    Segmented *m_loops = nullptr;
    Segmented *m_slots = nullptr;
    CommandButton *m_identify = nullptr;
    CommandButton *m_autotune = nullptr;
    CommandButton *m_prove = nullptr;
    ModelPanel *m_model = nullptr;
    SweepPanel *m_sweep = nullptr;
    EnvelopePanel *m_envelope = nullptr;
    QVBoxLayout *m_cards = nullptr;
    std::vector<ProposalCard *> m_proposals;
    OwnProposal *m_own = nullptr;
    DesignPlots *m_plots = nullptr;
    TuningSteps *m_steps = nullptr;
    ReportOrder *m_order = nullptr;
};

} // namespace mb
