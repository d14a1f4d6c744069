// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/experiment.h"
#include "model/snapshot.h"
#include "widgets/control/stimulusbar.h"

#include <QString>

#include <optional>

namespace mb {

/// An experiment as a page means it.
struct ExperimentWish {
    Mode mode = Mode::Velocity;
    int axis = 1;
    int slot = 0;
    std::optional<Mode> loop; ///< that it is made for, as of ExperimentPlan
    StimulusChoice stimulus;
    Envelope limits;
    QString limitsFault;                ///< what is entered for them and is none; nothing runs then
    std::vector<ParameterChange> gains; ///< staged, written first
};

/// Whether a device could do it now, by what the window knows of it. The engine checks again, with values read anew.
struct ExperimentCheck {
    bool possible = false; ///< the mode has a loop that can be tried
    bool good = false;     ///< and the stimulus stays inside the envelope
    QString words;         ///< why not; or what will happen, with its numbers
    QString missing;       ///< what the envelope lacks; empty: nothing
    Envelope inForce;
};
[[nodiscard]] ExperimentCheck checkExperiment(
    const DeviceView &device, const ExperimentWish &wish, const DisplayUnits &units, Instant now);

/// A stimulus to begin with, well inside what is known of the envelope; without `to` where nothing is.
[[nodiscard]] StimulusChoice usualStimulus(
    const DeviceView &device, const ExperimentWish &wish, const DisplayUnits &units, Instant now);

[[nodiscard]] tuning::ExperimentPlan planOf(const DeviceView &device, const ExperimentWish &wish);

} // namespace mb
