// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/control/arming.h"
#include "widgets/control/statusline.h"
#include "widgets/design/designbook.h"

#include <QWidget>

class QStackedWidget;

namespace mb {

class DesignColumn;
class DesignCourse;
class DesignOrders;
class DesignPlots;
class EmptyState;
class EnvelopePanel;
class ModelPanel;
class ProposalList;
class ReportOrder;
class SweepPanel;

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
    [[nodiscard]] const tuning::TuneReport *report() const { return m_book.report(); }
    /// What Write and prove would write; nullptr: there is nothing yet.
    [[nodiscard]] const tuning::Proposal *chosen() const;

protected:
    void showEvent(QShowEvent *) override { follow(); }

private:
    void buildContent(const ThemeSource &theme);
    QWidget *buildColumn(const ThemeSource &theme);
    void connectOrders();
    void buildKeys();

    void run(tuning::TunePlan plan);
    void ended(const DesignPlace &place, const Result<tuning::TuneReport> &report);
    void follow();
    void followDevice(const DeviceView &view, const QString &whyNot);
    void followLimits(const DeviceView &view);
    void showReport();

    /// Whose report, and the turn of the shaft that its gains are shown in.
    struct Shown {
        DesignPlace place;
        double countsPerRevolution = 0.0;
        friend bool operator==(const Shown &, const Shown &) = default;
    };

    Workbench &m_workbench;
    Arming &m_arming;
    DesignBook m_book;
    Envelope m_inForce;           ///< what the step may use
    DeviceId m_limitsOf;          ///< whose limits stand in the panel
    std::uint64_t m_revision = 0; ///< of its parameters, that the comparison stands on
    std::optional<Shown> m_shown; ///< what is on the page
    QStackedWidget *m_stack = nullptr;
    EmptyState *m_empty = nullptr;
    DesignOrders *m_orders = nullptr;
    StatusLine *m_status = nullptr;
    DesignPlots *m_plots = nullptr;
    DesignColumn *m_column = nullptr;
    ModelPanel *m_model = nullptr;
    EnvelopePanel *m_envelope = nullptr;
    DesignCourse *m_course = nullptr;
    ProposalList *m_proposals = nullptr;
    SweepPanel *m_sweep = nullptr;
    ReportOrder *m_report = nullptr;
};

} // namespace mb
