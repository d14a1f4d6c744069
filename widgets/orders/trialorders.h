// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"
#include "model/session.h"
#include "tuning/autotune.h"
#include "tuning/frequencyresponse.h"

#include <cstdint>
#include <functional>
#include <string>

/// Experiments. Operations of the device: Unsafe while another one has it or its motor turns, Timeout when it is gone. Those that
/// move need RenewMotion all the time; StopMotion and STOP end them at any phase.
namespace mb::orders {

/// Finds out what the device does not tell (Family::experiments). The log of the operation has what was found.
struct RunExperiment {
    DeviceId device;
    std::string key;
    ExperimentOptions options;
};

/// One guarded experiment on a loop (tuning/experiment.h), kept in the notebook. Fails with why nothing has moved.
struct RunTrial {
    using Answer = tuning::Trial;
    DeviceId device;
    tuning::ExperimentPlan plan;
    /// When a hold has ended and the motor is on its way back; in the thread of whoever has given the order, before its answer.
    std::function<void(const tuning::Trial &)> measured;
};

/// Tunes a loop by itself (tuning/autotune.h), by several experiments in a row; the log of the operation tells each before it
/// moves.
struct RunTuning {
    using Answer = tuning::TuneReport;
    DeviceId device;
    tuning::TunePlan plan;
};

/// A frequency response by sines one after the other (tuning/frequencyresponse.h).
struct RunSweep {
    using Answer = tuning::FrequencyResponse;
    DeviceId device;
    tuning::SweepPlan plan;
    tuning::PlantModel plant;
};

/// Puts back the gains that a trial owes. OutOfRange when it owes none.
struct PayGains {
    DeviceId device;
    std::int64_t trial = 0; ///< its number in the notebook
};

/// Lets the unit keep the gains that a trial has left in it.
struct DismissGains {
    DeviceId device;
    std::int64_t trial = 0;
};

} // namespace mb::orders
