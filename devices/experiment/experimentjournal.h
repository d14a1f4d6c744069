// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/task.h"
#include "experiment/trial.h"

namespace mb::tuning {

struct TuneReport;

/// A value that an experiment has changed and owes to the unit.
struct OwedValue {
    std::string key;
    std::int64_t raw = 0;
    std::optional<std::int64_t> tried{}; ///< what it has written instead; nothing: not known
    bool isKept = false;                 ///< on purpose: a tuning has kept that

    friend bool operator==(const OwedValue &, const OwedValue &) = default;
};

/// What an experiment changed and nobody has put back for certain.
struct OwedGains {
    std::int64_t trial = 0;
    double time = 0.0; ///< Unix, s, when it was owed, or put back without a proof that the unit has it for good
    std::vector<OwedValue> values;
    bool isPutBack = false;  ///< but the unit may not have it for good
    bool isUnderWay = false; ///< another program is making this trial, and puts it back itself
    std::string unit{};      ///< whose, as the notebook calls it (model/unit.h)

    friend bool operator==(const OwedGains &, const OwedGains &) = default;
};

/// Where an experiment writes down what must outlive this program. Thread of the session; whoever implements it waits for a
/// disk in a thread of its own where that matters.
class ExperimentJournal {
public:
    virtual ~ExperimentJournal() = default;

    /// A row for a trial that is about to begin; its number.
    [[nodiscard]] virtual Task<std::int64_t> begin(Trial trial) = 0;
    /// What must be put back whatever happens: on the disk when this ends. A unit is owed one value of each key, that of before the
    /// first trial that has not put it back: what a later trial found there was tried.
    [[nodiscard]] virtual Task<void> owe(std::int64_t trial, std::string unit, std::vector<OwedValue> values) = 0;
    /// All that this trial owes was put back now, and nothing proves yet that the unit has it for good.
    [[nodiscard]] virtual Task<void> markPutBack(std::int64_t trial) = 0;
    /// It was put back, and the unit has it for good.
    [[nodiscard]] virtual Task<void> settle(std::int64_t trial) = 0;
    /// The unit has others of these on purpose: nothing is owed of them any more, by whichever trial.
    [[nodiscard]] virtual Task<void> release(std::string unit, std::vector<std::string> keys) = 0;
    /// What came of it.
    [[nodiscard]] virtual Task<void> complete(std::int64_t number, Trial trial) = 0;
    /// Nothing comes of it any more: whoever made it was cut, and puts nothing back. Nobody waits for it, and the journal may be full.
    virtual void abandon(std::int64_t number) = 0;
    /// What came of a whole tuning: its trials are kept by then.
    [[nodiscard]] virtual Task<void> keepTuning(TuneReport report) = 0;
    /// What earlier experiments owe to a unit, oldest first.
    [[nodiscard]] virtual Task<std::vector<OwedGains>> owedTo(std::string unit) = 0;
};

} // namespace mb::tuning
