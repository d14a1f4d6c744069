// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/displayunits.h"
#include "widgets/common/selection.h"
#include "widgets/control/setpointentries.h"
#include "widgets/control/stimulusbar.h"
#include "widgets/parameters/editdesk.h"

#include <map>
#include <string>

namespace mb {

/// One motor: a device, or one of its axes (0 where it has one only).
struct TuneMotor {
    DeviceId device;
    int axis = 0;
    friend auto operator<=>(const TuneMotor &, const TuneMotor &) = default;
};

/// What a person has chosen for one motor, and what was sent to it from the page.
struct TuneChoice {
    Mode mode = Mode::Velocity;
    int editedSlot = 0;
    int runningSlot = 0;
    DisplayUnits units;
    double profiled = 0.0;        ///< counts per revolution that the device's profile had last
    StagedEdits *edits = nullptr; ///< of the device, shared with the other pages
    StimulusChoice stimulus;
    std::string unit;         ///< who it is in the notebook
    SetPointEntries entered;  ///< also of the one that is shown
    std::uint32_t origin = 0; ///< of its positions (DeviceView::origin)
    bool ours = false;        ///< the motion was started here
};

/// The choices of every motor that a Tune page has seen, which the workbench keeps for the next one, and which motor this one shows.
/// Draws nothing and sends nothing.
class TuneChoices : public QObject {
    Q_OBJECT
public:
    TuneChoices(Workbench &workbench, const Selection &selection);

    /// The device that is selected; nullptr: none, or it is gone.
    [[nodiscard]] const DeviceView *device() const { return m_workbench.snapshot().device(m_selection.device()); }
    /// Its axis that is meant (Selection::motor()). 0: it has one motor only.
    [[nodiscard]] int axisOf(const DeviceView &view) const;

    void show(const TuneMotor &motor) { m_shown = motor; }
    [[nodiscard]] const TuneMotor &shown() const { return m_shown; }
    [[nodiscard]] int axis() const { return m_shown.axis; }
    /// Of the motor that is shown; nullptr before the first.
    [[nodiscard]] TuneChoice *current() { return find(m_shown); }
    [[nodiscard]] TuneChoice *find(const TuneMotor &motor);
    /// Makes those of every motor of a device.
    void make(const DeviceView &view);
    /// Those of one motor, made where nobody has seen it yet.
    [[nodiscard]] TuneChoice &of(const DeviceView &view, int axis);
    /// Rises with every edit of a device that was seen here.
    [[nodiscard]] std::uint64_t editRevision() const { return m_editRevision; }

    /// Of a motor, as somebody has told it on the page or in its profile.
    [[nodiscard]] static double countsPerRevolution(Workbench &workbench, const DeviceView &view, int axis);

    /// The units that each motor has until somebody chooses others for it.
    void setRevolutions(bool on);
    /// The live view instead of the experiments.
    void setLive(bool on) { m_kept.live = on; }
    [[nodiscard]] bool isLive() const { return m_kept.live; }
    /// Whoever let a motor of this device count from another place, or switched it off: what was entered for its positions means
    /// nothing any more. True where that is the one that is shown.
    [[nodiscard]] bool forgetPlaces(const DeviceView &view);
    /// Nothing moves that was started here.
    void forgetMotion();

Q_SIGNALS:
    /// Something is staged, or is no longer.
    void edited();

private:
    struct Kept {
        std::map<TuneMotor, TuneChoice> choices;
        bool revolutions = false;
        bool live = false;
    };
    void countEdit();

    Workbench &m_workbench;
    EditDesk &m_desk;
    const Selection &m_selection;
    Kept &m_kept;
    TuneMotor m_shown;
    std::uint64_t m_editRevision = 0;
};

} // namespace mb
