// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/task.h"
#include "experiment/envelope.h"
#include "experiment/experimentjournal.h"
#include "experiment/interruption.h"
#include "experiment/trial.h"

#include <functional>
#include <optional>
#include <vector>

namespace mb::tuning {

class DirectionBook;

/// Whether gains that an experiment has written stay in force after it.
enum class Keep { Never, WhenDone, Always };

/// What an experiment is asked to do. Numbers are in the unit of the mode.
struct ExperimentPlan {
    Mode mode = Mode::Velocity;
    int axis = 1;
    int slot = 0;
    std::optional<double> from; ///< nothing: the present position in position mode, else 0
    double to = 0.0;
    Profile profile = Profile::Step;
    std::optional<double> seconds; ///< of the profile; nothing: the usual
    bool turnsBack = false;        ///< what a ramp has reached is not held
    int repeat = 1;
    std::optional<double> reach;   ///< counts from where it began: a push ends where the motor would stop beyond
    std::optional<double> fastest; ///< counts/s: a push ends where the motor is quicker
    /// Counts: a push that changes its sign whenever the motor has passed its start by so much the way it is pushed, until it has swung
    /// nine times; duty mode only.
    std::optional<double> relay;
    std::optional<double> rate; ///< samples per second asked for; nothing: the family's usual
    double rest = 0.0;          ///< s that each way back takes at least
    bool profiled = false;      ///< the device's own profile leads from X to Y and back; position mode only
    double noise = 0.0;         ///< σ of what a loop measures, where it is known: no swing of it is taken for one
    std::vector<ParameterChange> gains; ///< in force while it runs
    Keep keep = Keep::Never;            ///< and afterwards
    std::optional<double>
        announced;            ///< its counts/s per duty at most, 0 or nothing where nobody knows (announcement.h)
    Message intent{};         ///< what it is, for people: said when nothing can refuse it any more
    Envelope limits;          ///< what the caller allows
    std::optional<Mode> loop; ///< that it is made for, whose limits must be known, too; nothing: its mode
};

/// What an experiment shares with who started it, who outlives it. Thread of the session.
struct ExperimentSurroundings {
    ExperimentJournal *journal = nullptr; ///< nullptr: nothing is kept, and gains are written with Keep::Always only
    DirectionBook *directions = nullptr;  ///< of this run of the program
    Interruption *interruption = nullptr;
    double rate = 0.0; ///< samples per second to ask for; 0: what its family says
    /// Counts, from where the travel of all experiments that share it is counted: the first that moves the motor says it. nullptr: each
    /// has its own.
    std::optional<double> *start = nullptr;
    /// Once, when all is checked and before the first gain is written or anything moves; where it fails, so does the experiment.
    std::function<Task<void>()> before;
    std::function<void(const Message &)> note; ///< a line for people: what happens now
    std::function<void(const Message &)> warn; ///< one that they should not miss; where empty, a note
    /// When a hold has ended, before the way back: the trial with what this repeat has measured. The motor still runs.
    std::function<void(const Trial &)> measured;
    /// Why what it has written is still in force: Trial::notPutBack, also of one that fails; or Keep::Always, and then nothing is owed.
    std::function<void(const Message &)> leftInForce;

    void caution(const Message &text) const
    {
        if (const auto &told = warn ? warn : note)
            told(text);
    }
};

/// Of the stream's lease while an experiment runs.
constexpr Duration experimentLease = std::chrono::seconds(1);

} // namespace mb::tuning
