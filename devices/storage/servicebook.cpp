// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/servicebook.h"

#include "files/qttext.h"
#include "files/runningprogram.h"
#include "storage/sqltext.h"

#include <QSqlQuery>
#include <QUuid>

#include <algorithm>

namespace mb {

using service::NumberWish;
using service::Visit;
using service::VisitFilter;

ServiceBook::ServiceBook(Database &database, const Clock &clock, std::string station, std::string person)
    : m_database(database)
    , m_clock(clock)
    , m_station(std::move(station))
    , m_person(std::move(person))
{
}

/// In one transaction: a note that another program adds meanwhile is lost by nobody.
Result<Visit> ServiceBook::put(Visit visit, bool isNew)
{
    for (service::StepEntry &entry : visit.steps)
        entry.time = entry.time > 0.0 ? entry.time : now();
    auto kept = m_database.transact([&]() -> Result<void> {
        MB_TRY_VOID(m_database.run(
            "INSERT OR REPLACE INTO service_run (run, program) VALUES (?, ?)", {qt(visit.run), qt(thisProgram())}));
        if (isNew)
            return putVisit(m_database, {visit, 1});
        MB_TRY(const auto known, getVisit(m_database, visit.id));
        visit.note = visit.note.empty() ? known.visit.note : visit.note;
        return putVisit(m_database, {visit, known.revision + 1});
    });
    if (!kept)
        return fail(kept.error());
    return visit;
}

/// A clock that is set back does not change the order of a run.
Task<Visit> ServiceBook::open(Visit visit)
{
    visit.id = QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString();
    visit.time = now();
    const auto read = m_database.run("SELECT max(time) FROM service_visit WHERE run = ?", {qt(visit.run)},
        [&visit](const QSqlQuery &row) { visit.time = std::max(visit.time, row.value(0).toDouble() + 1e-3); });
    if (!read)
        co_return fail(read.error());
    visit.person = m_person;
    visit.station = visit.station.empty() ? m_station : visit.station;
    co_return put(std::move(visit), true);
}

Task<Visit> ServiceBook::write(Visit visit)
{
    co_return put(std::move(visit), false);
}

Result<std::vector<Visit>> ServiceBook::list(const VisitFilter &filter)
{
    MB_TRY(auto kept, getVisits(m_database, filter));
    std::vector<Visit> visits;
    for (KeptVisit &each : kept)
        visits.push_back(std::move(each.visit));
    return visits;
}

Task<std::vector<Visit>> ServiceBook::visits(VisitFilter filter)
{
    co_return list(filter);
}

/// Nobody else gives numbers here, so there is always a next one until the highest.
Task<std::optional<int>> ServiceBook::number(NumberWish wish)
{
    for (;;) {
        const std::optional<int> given = co_await giveNumber(m_database, wish);
        if (given)
            co_return given;
        const std::string token = QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString();
        const auto block = co_await takeBlock(m_database, token, wish, numbersInBlock, m_station, now());
        if (block.isEmpty())
            co_return std::nullopt;
        co_await keepBlock(m_database, wish.scope, block);
    }
}

Result<void> ServiceBook::setNote(const std::string &visit, const std::string &note)
{
    auto set = m_database.run(
        "UPDATE service_visit SET note = ?, revision = revision + 1 WHERE id = ?", {qt(note), qt(visit)});
    if (set && m_database.changed() == 0)
        return fail(getVisit(m_database, visit).error());
    return set;
}

Result<std::string> ServiceBook::lastRun(const std::string &recipe, bool simulated)
{
    std::string run;
    std::string program;
    auto read
        = m_database.run("SELECT run, program FROM service_visit LEFT JOIN service_run USING (run) "
                         "WHERE recipe = ? AND station = ? AND simulated = ? ORDER BY service_visit.rowid DESC LIMIT 1",
            {qt(recipe), qt(m_station), simulated ? 1 : 0}, [&](const QSqlQuery &row) {
                run = textAt(row, 0);
                program = textAt(row, 1);
            });
    if (!read)
        return fail(read.error());
    if (isAnotherRunning(program))
        return fail(Fault::Refused, say("the last run of %1 was begun by another program, which still runs", recipe),
            say("end that first"));
    return run;
}

} // namespace mb
