// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/frequencyresponse.h"
#include "tuning/proposals.h"
#include "widgets/common/selection.h"
#include "widgets/common/workbench.h"

#include <QCoreApplication>

#include <map>

namespace mb {

/// One loop of one motor: what a tuning is about.
struct DesignPlace {
    DeviceId device;
    int axis = 1;
    Mode loop = Mode::Velocity;
    friend auto operator<=>(const DesignPlace &, const DesignPlace &) = default;
};

/// What a person has chosen for one of them.
struct DesignChoice {
    tuning::Aim aim = tuning::Aim::Normal;
    bool own = false;      ///< the two sliders instead of the aim
    double response = 0.0; ///< s; 0: nobody has moved them yet
    double ms = 0.0;       ///< largest sensitivity; 0: likewise
    int slot = 0;          ///< that the gains belong to, where the family has several
};

/// What a Design page knows of each motor and loop, what is chosen for it, and which of them it shows; the workbench keeps it for the next
/// one. Draws nothing and sends nothing. GUI thread.
class DesignBook {
    Q_DECLARE_TR_FUNCTIONS(mb::DesignBook)
public:
    DesignBook(Workbench &workbench, const Selection &selection)
        : m_workbench(workbench)
        , m_selection(selection)
        , m_kept(workbench.kept<Kept>())
    {
    }

    /// The device that is selected; nullptr: none, or it is gone.
    [[nodiscard]] const DeviceView *device() const { return m_workbench.snapshot().device(m_selection.device()); }
    /// What is shown: of the motor that is selected, the loop that is chosen.
    [[nodiscard]] DesignPlace place() const;
    [[nodiscard]] Mode loop() const { return m_kept.loop; }
    void setLoop(Mode loop) { m_kept.loop = loop; }
    [[nodiscard]] DesignChoice choice() const;
    /// To be changed.
    [[nodiscard]] DesignChoice &choose() { return m_kept.choices[place()]; }

    /// nullptr: nothing is known yet.
    [[nodiscard]] const tuning::TuneReport *report() const;
    /// A report that brings no model of its own leaves the one that is known.
    void keep(const DesignPlace &place, tuning::TuneReport report);
    /// Of the motor, whatever the loop; empty: none was measured.
    [[nodiscard]] std::vector<tuning::FrequencyPoint> response() const;
    void keepResponse(const DesignPlace &place, const tuning::FrequencyResponse &response);

    /// Why the loop cannot be tuned, which may be one that this family has not; empty: it can.
    [[nodiscard]] QString whyNot(const DeviceView &view) const;
    /// Of the motor; gains are shown in turns of its shaft, as on Tune.
    [[nodiscard]] double countsPerRevolution(const DeviceView &view) const;
    /// From the beginning, as it is chosen.
    [[nodiscard]] tuning::TunePlan plan() const;
    /// What a proposal for this device stands on. There is a report.
    [[nodiscard]] tuning::ProposalBasis basisOf(const DeviceView &view, const Envelope &inForce) const;

private:
    struct Kept {
        Mode loop = Mode::Velocity;
        std::map<DesignPlace, tuning::TuneReport> reports;
        std::map<DesignPlace, DesignChoice> choices;
        std::map<std::pair<DeviceId, int>, tuning::FrequencyResponse> responses; ///< by device and axis
    };
    Workbench &m_workbench;
    const Selection &m_selection;
    Kept &m_kept;
};

} // namespace mb
