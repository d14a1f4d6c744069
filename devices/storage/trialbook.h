// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/seconds.h"
#include "experiment/experimentjournal.h"
#include "experiment/kepttrial.h"
#include "storage/database.h"
#include "tuning/kepttuning.h"

namespace mb {

/// The notebook: every experiment, kept for good, also those that nobody saw end. A row is there before its experiment begins.
/// Thread of the database, which outlives it. Every function but list() and find() fails on a full disk or a file that cannot
/// be written (NotKept), or a number that is not there (OutOfRange), the cause in the text, and then nothing was changed.
class TrialBook final : public tuning::ExperimentJournal {
public:
    /// The clock gives the time of day.
    TrialBook(Database &database, const Clock &clock);

    [[nodiscard]] Task<std::int64_t> begin(tuning::Trial trial) override;
    [[nodiscard]] Task<void> owe(std::int64_t trial, std::string unit, std::vector<tuning::OwedValue> values) override;
    [[nodiscard]] Task<void> markPutBack(std::int64_t trial) override;
    [[nodiscard]] Task<void> settle(std::int64_t trial) override;
    [[nodiscard]] Task<void> release(std::string unit, std::vector<std::string> keys) override;
    [[nodiscard]] Task<void> complete(std::int64_t number, tuning::Trial trial) override;
    void abandon(std::int64_t number) override;
    [[nodiscard]] Task<void> keepTuning(tuning::TuneReport report) override;
    [[nodiscard]] Task<std::vector<tuning::OwedGains>> owedTo(std::string unit) override;

    /// In order of their beginning.
    [[nodiscard]] Result<std::vector<KeptTrial>> list() { return read({}, {}); }
    /// The same of one unit, wherever it was connected (Trial::unit).
    [[nodiscard]] Result<std::vector<KeptTrial>> listOf(const std::string &unit);
    /// Tunings of one unit in order of their end; none in a file that is read only and older than they are.
    [[nodiscard]] Result<std::vector<KeptTuning>> tuningsOf(const std::string &unit);
    [[nodiscard]] Result<KeptTrial> find(std::int64_t number);
    [[nodiscard]] Result<std::vector<tuning::Signal>> signals(std::int64_t number);
    [[nodiscard]] Result<void> setStar(std::int64_t number, bool star);
    [[nodiscard]] Result<void> setNote(std::int64_t number, const std::string &note);
    [[nodiscard]] Result<void> remove(std::int64_t number);
    [[nodiscard]] Database &database() const { return m_database; }

private:
    [[nodiscard]] Result<std::vector<KeptTrial>> read(const std::string &where, const QVariantList &values);
    [[nodiscard]] double now() const { return unixSeconds(m_clock); }
    [[nodiscard]] Result<void> changeOne(std::int64_t number, const char *statement, const QVariantList &values);
    [[nodiscard]] Result<void> keepSignals(std::int64_t number, const std::vector<tuning::Signal> &signals);

    Database &m_database;
    const Clock &m_clock;
};

} // namespace mb
