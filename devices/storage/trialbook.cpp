// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/trialbook.h"

#include "files/qttext.h"
#include "files/runningprogram.h"
#include "storage/messagejson.h"
#include "storage/sqltext.h"
#include "storage/trialjson.h"
#include "storage/tuningjson.h"
#include "storage/unittags.h"

#include <QJsonDocument>
#include <QSqlQuery>
#include <QVariant>

#include <cstring>
#include <utility>

namespace mb {
namespace {

const std::string columns
    = "SELECT id, time, device, unit, firmware, simulated, mode, axis, slot, stimulus, envelope, gains, "
      "metrics, flags, reason, detail, stopped, samples, lost, star, note FROM trial";

/// The first value of a key stays until it is put back, and then too where the unit has lost it again: what is found there now is
/// what was tried.
constexpr const char *oweOne
    = "INSERT INTO owed (unit, key, trial, raw, tried, put_back, time) VALUES (?, ?, ?, ?, ?, 0, ?) "
      "ON CONFLICT (unit, key) DO UPDATE SET "
      "trial = CASE WHEN put_back AND tried IS NOT excluded.raw THEN excluded.trial ELSE trial END, "
      "time = CASE WHEN put_back AND tried IS NOT excluded.raw THEN excluded.time ELSE time END, "
      "raw = CASE WHEN put_back AND tried IS NOT excluded.raw THEN excluded.raw ELSE raw END, "
      "tried = excluded.tried, put_back = 0";

QString textOf(const QJsonObject &object)
{
    return QString::fromUtf8(QJsonDocument(object).toJson(QJsonDocument::Compact));
}

QString textOf(const QJsonArray &array)
{
    return QString::fromUtf8(QJsonDocument(array).toJson(QJsonDocument::Compact));
}

QJsonDocument parsed(const QVariant &text)
{
    return QJsonDocument::fromJson(text.toString().toUtf8());
}

KeptTrial trialOf(const QSqlQuery &row)
{
    KeptTrial kept;
    kept.number = row.value(0).toLongLong();
    kept.time = row.value(1).toDouble();
    tuning::Trial &trial = kept.trial;
    trial.number = kept.number;
    trial.device = textAt(row, 2);
    trial.unit = textAt(row, 3);
    trial.firmware = textAt(row, 4);
    trial.simulated = row.value(5).toBool();
    trial.mode = modeFromString(textAt(row, 6)).value_or(Mode::Off);
    trial.axis = row.value(7).toInt();
    trial.slot = row.value(8).toInt();
    readStimulus(parsed(row.value(9)).object(), trial);
    fromJson(parsed(row.value(10)).object(), trial.envelope);
    fromJson(parsed(row.value(11)).object(), trial.gains);
    readMetrics(parsed(row.value(12)).object(), trial);
    fromJson(parsed(row.value(13)).array(), trial.flags);
    trial.reason = tuning::endReasonFrom(textAt(row, 14));
    trial.detail = messageFrom(textAt(row, 15));
    trial.stopped = row.value(16).toBool();
    trial.samples = row.value(17).toULongLong();
    trial.lost = row.value(18).toULongLong();
    kept.star = row.value(19).toBool();
    kept.note = textAt(row, 20);
    return kept;
}

KeptTuning tuningOf(const QSqlQuery &row)
{
    KeptTuning kept;
    kept.number = row.value(0).toLongLong();
    kept.time = row.value(1).toDouble();
    tuning::TuneReport &report = kept.report;
    report.device = textAt(row, 2);
    report.unit = textAt(row, 3);
    report.firmware = textAt(row, 4);
    report.simulated = row.value(5).toBool();
    report.loop = modeFromString(textAt(row, 6)).value_or(Mode::Off);
    report.axis = row.value(7).toInt();
    report.slot = row.value(8).toInt();
    for (const auto result : {tuning::TuneResult::Kept, tuning::TuneResult::Proposed, tuning::TuneResult::RolledBack,
             tuning::TuneResult::Refused, tuning::TuneResult::Stopped}) {
        if (toString(result) == textAt(row, 9))
            report.result = result;
    }
    report.evidence = messageFrom(textAt(row, 10));
    readTuning(parsed(row.value(11)).object(), report);
    return kept;
}

/// Times, then values, as the machine has them, compressed.
QByteArray packed(const tuning::Trace &trace)
{
    const auto size = static_cast<int>(trace.size() * sizeof(double));
    QByteArray bytes(2 * size, '\0');
    std::memcpy(bytes.data(), trace.t.data(), static_cast<std::size_t>(size));
    std::memcpy(bytes.data() + size, trace.y.data(), static_cast<std::size_t>(size));
    return qCompress(bytes, 1);
}

tuning::Trace unpacked(const QByteArray &data, std::size_t samples)
{
    tuning::Trace trace;
    const QByteArray bytes = qUncompress(data);
    const std::size_t size = samples * sizeof(double);
    if (static_cast<std::size_t>(bytes.size()) != 2 * size)
        return trace;
    trace.t.resize(samples);
    trace.y.resize(samples);
    std::memcpy(trace.t.data(), bytes.constData(), size);
    std::memcpy(trace.y.data(), bytes.constData() + size, size);
    return trace;
}

} // namespace

TrialBook::TrialBook(Database &database, const Clock &clock)
    : m_database(database)
    , m_clock(clock)
{
}

Task<std::int64_t> TrialBook::begin(tuning::Trial trial)
{
    const auto added
        = m_database.run("INSERT INTO trial (time, device, unit, firmware, simulated, mode, axis, slot, stimulus, "
                         "envelope, gains, metrics, flags, detail, stopped, samples, lost, program) "
                         "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, '{}', '[\"aborted\"]', "
                         "'the program ended before the trial did', 0, 0, 0, ?)",
            {now(), qt(trial.device), qt(resolvedUnit(m_database, trial.unit)), qt(trial.firmware), trial.simulated,
                qt(toString(trial.mode)), trial.axis, trial.slot, textOf(toJson(trial.stimulus, trial.repeat)),
                textOf(toJson(trial.envelope)), textOf(toJson(trial.gains)), qt(thisProgram())});
    if (!added)
        co_return fail(added.error());
    co_return m_database.lastRow();
}

Task<void> TrialBook::owe(std::int64_t trial, std::string unit, std::vector<tuning::OwedValue> values)
{
    const double time = now();
    unit = resolvedUnit(m_database, unit);
    co_return m_database.transact([&]() -> Result<void> {
        for (const tuning::OwedValue &value : values) {
            const QVariant tried
                = value.tried ? QVariant(static_cast<qint64>(*value.tried)) : QVariant(QVariant::LongLong);
            MB_TRY_VOID(m_database.run(oweOne,
                {qt(unit), qt(value.key), static_cast<qint64>(trial), static_cast<qint64>(value.raw), tried, time}));
        }
        return {};
    });
}

Task<void> TrialBook::markPutBack(std::int64_t trial)
{
    co_return m_database.run(
        "UPDATE owed SET put_back = 1, time = ? WHERE trial = ?", {now(), static_cast<qint64>(trial)});
}

Task<void> TrialBook::release(std::string unit, std::vector<std::string> keys)
{
    unit = resolvedUnit(m_database, unit);
    co_return m_database.transact([&]() -> Result<void> {
        for (const std::string &key : keys)
            MB_TRY_VOID(m_database.run("DELETE FROM owed WHERE unit = ? AND key = ?", {qt(unit), qt(key)}));
        return {};
    });
}

Task<void> TrialBook::settle(std::int64_t trial)
{
    co_return m_database.run("DELETE FROM owed WHERE trial = ?", {static_cast<qint64>(trial)});
}

Task<void> TrialBook::complete(std::int64_t number, tuning::Trial trial)
{
    co_return m_database.transact([&]() -> Result<void> {
        const QVariant reason = trial.reason == tuning::EndReason::None ? QVariant(QVariant::String)
                                                                        : QVariant(qt(toString(trial.reason)));
        auto changed = changeOne(number,
            "UPDATE trial SET stimulus = ?, gains = ?, metrics = ?, flags = ?, reason = ?, detail = ?, stopped = ?, "
            "samples = ?, "
            "lost = ?, program = '' "
            "WHERE id = ?",
            {textOf(stimulusToJson(trial)), textOf(toJson(trial.gains)), textOf(metricsToJson(trial)),
                textOf(toJson(trial.flags)), reason, savedText(trial.detail), trial.stopped,
                static_cast<qint64>(trial.samples), static_cast<qint64>(trial.lost), static_cast<qint64>(number)});
        return changed ? keepSignals(number, trial.signals) : changed;
    });
}

void TrialBook::abandon(std::int64_t number)
{
    (void)changeOne(number, "UPDATE trial SET program = '' WHERE id = ?", {static_cast<qint64>(number)});
}

Result<void> TrialBook::keepSignals(std::int64_t number, const std::vector<tuning::Signal> &signals)
{
    for (const tuning::Signal &signal : signals) {
        MB_TRY_VOID(m_database.run("INSERT INTO signal (trial, channel, unit, samples, data) VALUES (?, ?, ?, ?, ?)",
            {static_cast<qint64>(number), qt(signal.channel), qt(signal.unit), static_cast<qint64>(signal.trace.size()),
                packed(signal.trace)}));
    }
    return {};
}

Result<void> TrialBook::changeOne(std::int64_t number, const char *statement, const QVariantList &values)
{
    MB_TRY_VOID(m_database.run(statement, values));
    if (m_database.changed() == 1)
        return {};
    return fail(
        Fault::OutOfRange, say("there is no trial %1", number), say("'motorbenchctl trials' lists those there are"));
}

Result<std::vector<KeptTrial>> TrialBook::read(const std::string &where, const QVariantList &values)
{
    std::vector<KeptTrial> trials;
    const std::string statement = columns + where + " ORDER BY id";
    MB_TRY_VOID(
        m_database.run(statement.c_str(), values, [&trials](const QSqlQuery &row) { trials.push_back(trialOf(row)); }));
    return trials;
}

Result<std::vector<KeptTrial>> TrialBook::listOf(const std::string &unit)
{
    return read(" WHERE unit = ?", {qt(resolvedUnit(m_database, unit))});
}

Task<void> TrialBook::keepTuning(tuning::TuneReport report)
{
    co_return m_database.run(
        "INSERT INTO tuning (time, device, unit, firmware, simulated, loop, axis, slot, result, evidence, report) "
        "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
        {now(), qt(report.device), qt(resolvedUnit(m_database, report.unit)), qt(report.firmware), report.simulated,
            qt(toString(report.loop)), report.axis, report.slot, qt(toString(report.result)),
            savedText(report.evidence), textOf(toJson(report))});
}

Result<std::vector<KeptTuning>> TrialBook::tuningsOf(const std::string &unit)
{
    std::vector<KeptTuning> tunings;
    bool known = false; // a file that is read only stays as old as it is
    auto read = m_database.run(
        "SELECT 1 FROM sqlite_master WHERE name = 'tuning'", {}, [&known](const QSqlQuery &) { known = true; });
    if (read && known)
        read = m_database.run("SELECT id, time, device, unit, firmware, simulated, loop, axis, slot, result, "
                              "evidence, report FROM tuning WHERE unit = ? ORDER BY id",
            {qt(resolvedUnit(m_database, unit))},
            [&tunings](const QSqlQuery &row) { tunings.push_back(tuningOf(row)); });
    for (KeptTuning &kept : tunings) {
        std::vector<tuning::Trial> proof;
        for (const tuning::Trial &trial : std::exchange(kept.report.proof, {})) {
            if (const auto found = find(trial.number.value_or(0)))
                proof.push_back(found->trial);
        }
        kept.report.proof = std::move(proof);
    }
    if (!read)
        return fail(read.error());
    return tunings;
}

Result<KeptTrial> TrialBook::find(std::int64_t number)
{
    std::optional<KeptTrial> found;
    const std::string statement = columns + " WHERE id = ?";
    MB_TRY_VOID(m_database.run(
        statement.c_str(), {static_cast<qint64>(number)}, [&found](const QSqlQuery &row) { found = trialOf(row); }));
    if (!found)
        return fail(Fault::OutOfRange, say("there is no trial %1", number),
            say("'motorbenchctl trials' lists those there are"));
    return *found;
}

Result<std::vector<tuning::Signal>> TrialBook::signals(std::int64_t number)
{
    std::vector<tuning::Signal> signals;
    const auto read = m_database.run("SELECT channel, unit, samples, data FROM signal WHERE trial = ? ORDER BY channel",
        {static_cast<qint64>(number)}, [&signals](const QSqlQuery &row) {
            signals.push_back(
                {textAt(row, 0), textAt(row, 1), unpacked(row.value(3).toByteArray(), row.value(2).toULongLong())});
        });
    if (!read)
        return fail(read.error());
    return signals;
}

Result<void> TrialBook::setStar(std::int64_t number, bool star)
{
    return changeOne(number, "UPDATE trial SET star = ? WHERE id = ?", {star, static_cast<qint64>(number)});
}

Result<void> TrialBook::setNote(std::int64_t number, const std::string &note)
{
    return changeOne(number, "UPDATE trial SET note = ? WHERE id = ?", {qt(note), static_cast<qint64>(number)});
}

Result<void> TrialBook::remove(std::int64_t number)
{
    return changeOne(number, "DELETE FROM trial WHERE id = ?", {static_cast<qint64>(number)});
}

namespace {

/// A tuning that has kept its gains may not have been able to take them out of the debt.
void markKept(std::vector<tuning::OwedGains> &owed, const std::vector<KeptTuning> &tunings)
{
    for (tuning::OwedGains &debt : owed) {
        for (const KeptTuning &kept : tunings) {
            if (kept.report.result != tuning::TuneResult::Kept || !isPartOf(debt.trial, kept.report))
                continue;
            for (tuning::OwedValue &value : debt.values)
                value.isKept = std::ranges::any_of(kept.report.proposed.rows,
                    [&value](const auto &row) { return row.key == value.key && row.raw == value.tried; });
        }
    }
}

} // namespace

Task<std::vector<tuning::OwedGains>> TrialBook::owedTo(std::string unit)
{
    std::vector<tuning::OwedGains> owed;
    unit = resolvedUnit(m_database, unit);
    const auto done
        = m_database.run("SELECT owed.trial, key, raw, owed.time, tried, put_back, program FROM owed "
                         "LEFT JOIN trial ON trial.id = owed.trial WHERE owed.unit = ? ORDER BY owed.trial, key",
            {qt(unit)}, [&owed, &unit](const QSqlQuery &row) {
                const std::int64_t trial = row.value(0).toLongLong();
                if (owed.empty() || owed.back().trial != trial)
                    owed.push_back({trial, row.value(3).toDouble(), {}, true, isAnotherRunning(textAt(row, 6)), unit});
                owed.back().isPutBack = owed.back().isPutBack && row.value(5).toBool();
                const std::optional<std::int64_t> tried
                    = row.isNull(4) ? std::nullopt : std::optional<std::int64_t>(row.value(4).toLongLong());
                owed.back().values.push_back({textAt(row, 1), row.value(2).toLongLong(), tried});
            });
    if (!done)
        co_return fail(done.error());
    if (!owed.empty()) {
        if (const auto tunings = tuningsOf(unit))
            markKept(owed, *tunings);
    }
    co_return owed;
}

} // namespace mb
