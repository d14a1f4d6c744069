// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/control/tunemotion.h"
#include "widgets/control/tuneparts.h"

namespace mb {

/// The panels of the Tune page as one form: they show what is chosen for the motor in question, and what somebody chooses in
/// one of them is kept and shown in the others. A change of mode, running slot, direction or limit disarms.
class TuneForm : public QObject {
    Q_OBJECT
public:
    TuneForm(TuneChoices &choices, TuneMotion &motion, const TuneParts &parts, const Arming &arming);

    /// Another motor.
    void show(const DeviceView &view, int axis);
    /// Takes the counts per revolution that the profile of the device says.
    void followProfile(const DeviceView &view);
    /// As if the mode was chosen and the target typed, in units of docs/names.md#units.
    void choose(Mode mode, double target);
    /// As if the stimulus was chosen.
    void chooseStimulus(Mode mode, const StimulusChoice &stimulus);
    void setRepeats(int repeats);
    /// The units that each motor has until somebody chooses others for it here.
    void setRevolutions(bool on);

Q_SIGNALS:
    void changed();

private:
    void connectPanels();
    void chooseMode(Mode mode);
    void takeMode(Mode mode);
    void takeEntries();
    void takeSlots();
    void takeStimulus();
    void showUnits(const TuneChoice &chosen);

    TuneChoices &m_choices;
    TuneMotion &m_motion;
    TuneParts m_parts;
    const Arming &m_arming;
};

} // namespace mb
