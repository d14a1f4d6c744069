// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "storage/database.h"
#include "tuning/experimentjournal.h"

#include <optional>

namespace mb {

/// A trial as it is kept, without its signals.
struct KeptTrial {
    std::int64_t number = 0;
    double time = 0.0; ///< Unix time of its beginning, s
    tuning::Trial trial;
    bool star = false;
    std::string note;
};

/// What an experiment changed and nobody has put back for certain.
struct Debt {
    std::int64_t trial = 0;
    double time = 0.0; ///< Unix, s
    std::vector<tuning::OwedValue> values;
};

/// The notebook: every experiment, kept for good, also those that nobody saw end. A row is there before its experiment begins.
/// Thread of the database, which outlives it. Every function but list() and find() fails on a full disk, a file that cannot be
/// written, or a number that is not there (OutOfRange, the cause in the text), and then nothing was changed.
class TrialBook final : public tuning::ExperimentJournal {
public:
    /// The clock gives the time of day.
    TrialBook(Database &database, const Clock &clock);

    [[nodiscard]] Task<std::int64_t> begin(tuning::Trial trial) override;
    [[nodiscard]] Task<void> owe(std::int64_t trial, std::string unit, std::vector<tuning::OwedValue> values) override;
    [[nodiscard]] Task<void> settle(std::int64_t trial) override;
    [[nodiscard]] Task<void> complete(std::int64_t number, tuning::Trial trial) override;

    /// In order of their beginning; of one device, if it is named.
    [[nodiscard]] Result<std::vector<KeptTrial>> list(const std::string &device = {});
    [[nodiscard]] Result<KeptTrial> find(std::int64_t number);
    [[nodiscard]] Result<std::vector<tuning::Signal>> signals(std::int64_t number);
    [[nodiscard]] Result<void> setStar(std::int64_t number, bool star);
    [[nodiscard]] Result<void> setNote(std::int64_t number, const std::string &note);
    [[nodiscard]] Result<void> remove(std::int64_t number);
    /// Of one unit, oldest first.
    [[nodiscard]] Result<std::vector<Debt>> debts(const std::string &unit);

private:
    [[nodiscard]] double now() const;
    [[nodiscard]] Result<void> changeOne(std::int64_t number, const char *statement, const QVariantList &values);
    [[nodiscard]] Result<void> keepSignals(std::int64_t number, const std::vector<tuning::Signal> &signals);

    Database &m_database;
    const Clock &m_clock;
};

} // namespace mb
