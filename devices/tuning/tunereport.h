// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/experiment.h"
#include "tuning/gainscale.h"
#include "tuning/identification.h"
#include "tuning/margins.h"
#include "tuning/prediction.h"

namespace mb::tuning {

/// What a tuning is asked for.
struct TunePlan {
    Mode loop = Mode::Velocity;
    int axis = 1;
    int slot = 0; ///< where the result belongs
    Aim aim = Aim::Normal;
    std::optional<double> response;  ///< s, instead of the aim
    std::optional<double> ms;        ///< largest sensitivity, instead of the aim's
    bool propose = false;            ///< end before a gain is written
    bool keep = false;               ///< also where nobody knows what it replaces
    std::optional<PlantModel> known; ///< of this loop, identified before: no pushes
    std::optional<TriedScale> scale; ///< that belongs to it: TuneReport::scale
    VelocityTaking taking;           ///< and how its loop takes its velocity: TuneReport::taking
    std::optional<MotorFound> motor; ///< what it was found on, with its gates: for the report
    std::vector<Gate> gates;
    Envelope limits;
};

/// Names are stable: they are the result in JSON.
enum class TuneResult { Kept, Proposed, RolledBack, Refused, Stopped };
[[nodiscard]] std::string_view toString(TuneResult result);

/// Gains for one aim, rounded to the device's, and what they will do.
struct Proposal {
    Aim aim = Aim::Normal;
    Design design;
    ScaledGains gains;
    Margins margins;
    Prediction predicted;                 ///< of a step of `step`
    double step = 0.0;                    ///< in the unit of the loop
    std::optional<ProfileLimits> profile; ///< of what it may be led by; nothing in a current loop
};

/// What came of it, and all that it stands on.
struct TuneReport {
    TuneResult result = TuneResult::Refused;
    std::string device;   ///< selector
    std::string unit;     ///< as Trial::unit
    std::string firmware; ///< version, empty when unknown
    bool simulated = false;
    Mode loop = Mode::Velocity;
    int axis = 1;
    int slot = 0;
    Message evidence; ///< one sentence for people: why it ended so
    std::optional<MotorFound> motor;
    PlantModel plant;                ///< of the loop, what the design stands on
    std::optional<TriedScale> scale; ///< of its gains, where they had to be tried
    VelocityTaking taking;           ///< of a velocity loop
    std::vector<Gate> gates;
    std::vector<Proposal> proposals; ///< calm, normal, brisk, as far as the device can have them
    Envelope envelope;               ///< in force, that they were found for
    std::optional<Design>
        design; ///< of what was chosen, as what follows: one of them, numbers of its own, or what was there
    ScaledGains proposed;
    std::vector<std::pair<std::string, std::optional<double>>> before; ///< gains by key, in the unit of the parameter
    std::optional<Margins> margins;
    std::optional<Prediction> predicted;    ///< of a step of `step`
    double step = 0.0;                      ///< in the unit of the loop
    std::optional<ProfileLimits> profile;   ///< as Proposal
    std::vector<Trial> proof;               ///< one a direction
    double heat = 0.0;                      ///< in the winding before the first of them (windingheat.h)
    Metrics measured;                       ///< the worse of both
    EndReason stopReason = EndReason::None; ///< None: its own end
    bool stopped = true;                    ///< the motor was seen stopped
    Message notPutBack; ///< why something else than before, and than was kept, is in force; empty: nothing is
    double seconds = 0.0;
    std::vector<std::int64_t> trials; ///< numbers in the notebook
};

/// Nobody knows what its gains replaced, so that nothing can put it back, and nothing is owed.
[[nodiscard]] bool replacesUnknown(const TuneReport &report);
/// What was there before is in force again where nothing was kept.
[[nodiscard]] bool isPutBack(const TuneReport &report);

} // namespace mb::tuning
