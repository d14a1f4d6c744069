// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/servicebook.h"

#include "files/qttext.h"
#include "storage/sqltext.h"

#include <QSqlQuery>
#include <QUuid>

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

double ServiceBook::now() const
{
    return std::chrono::duration<double>(m_clock.now().time_since_epoch() + m_clock.unixOffset()).count();
}

Result<Visit> ServiceBook::put(Visit visit, std::int64_t revision)
{
    for (service::StepEntry &entry : visit.steps)
        entry.time = entry.time > 0.0 ? entry.time : now();
    if (auto kept = putVisits(m_database, {{visit, revision}}); !kept)
        return fail(kept.error());
    return visit;
}

Task<Visit> ServiceBook::open(Visit visit)
{
    visit.id = QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString();
    visit.time = now();
    visit.person = m_person;
    visit.station = visit.station.empty() ? m_station : visit.station;
    co_return put(std::move(visit), 1);
}

Task<Visit> ServiceBook::write(Visit visit)
{
    const auto known = getVisit(m_database, visit.id);
    if (!known)
        co_return fail(known.error());
    visit.note = visit.note.empty() ? known->visit.note : visit.note; // somebody may have added it meanwhile
    co_return put(std::move(visit), known->revision + 1);
}

Result<std::vector<Visit>> ServiceBook::list(const VisitFilter &filter)
{
    auto kept = getVisits(m_database, filter);
    if (!kept)
        return fail(kept.error());
    std::vector<Visit> visits;
    for (KeptVisit &each : *kept)
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
        const auto given = giveNumber(m_database, wish);
        if (!given)
            co_return fail(given.error());
        if (*given)
            co_return *given;
        const std::string token = QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString();
        const auto block = takeBlock(m_database, token, wish, numbersInBlock, m_station, now());
        if (!block)
            co_return fail(block.error());
        if (block->isEmpty())
            co_return std::nullopt;
        if (auto kept = keepBlock(m_database, wish.scope, *block); !kept)
            co_return fail(kept.error());
    }
}

Result<void> ServiceBook::setNote(const std::string &visit, const std::string &note)
{
    auto known = getVisit(m_database, visit);
    if (!known)
        return fail(known.error());
    known->visit.note = note;
    ++known->revision;
    return putVisits(m_database, {*known});
}

Result<std::string> ServiceBook::lastRun(const std::string &recipe)
{
    std::string run;
    auto read
        = m_database.run("SELECT run FROM service_visit WHERE recipe = ? AND station = ? ORDER BY rowid DESC LIMIT 1",
            {qt(recipe), qt(m_station)}, [&run](const QSqlQuery &row) { run = textAt(row, 0); });
    if (!read)
        return fail(read.error());
    return run;
}

} // namespace mb
