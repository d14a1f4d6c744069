// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/servicedoor.h"

#include "app/engine/servicejobs.h"
#include "app/folders/account.h"
#include "storage/visitjson.h"

#include <QPointer>

namespace mb {
namespace {

/// Of the newest run on this station, if a unit of it is open still.
Result<ServiceDesk::CutRun> cutRunOf(ServiceBook &book, const std::string &recipe, const std::string &hash)
{
    const auto run = book.lastRun(recipe);
    if (!run)
        return fail(run.error());
    ServiceDesk::CutRun cut;
    if (run->empty())
        return cut;
    service::VisitFilter filter;
    filter.run = *run;
    filter.recipeHash = hash;
    const auto visits = book.list(filter);
    if (!visits)
        return fail(visits.error());
    for (const service::Visit &visit : *visits)
        ++(visit.outcome == service::Outcome::Open ? cut.open : cut.ended);
    if (cut.open > 0)
        cut.run = *run;
    return cut;
}

} // namespace

ServiceDoor::ServiceDoor(Engine &engine)
    : ServiceDesk(&engine)
    , m_engine(engine)
{
    engine.followService(
        [self = QPointer<ServiceDoor>(this)](const ServiceView &view) {
            if (!self)
                return;
            self->m_view = view;
            Q_EMIT self->changed();
        },
        [self = QPointer<ServiceDoor>(this)](const service::Visit &visit) {
            if (self)
                Q_EMIT self->unitEnded(visit);
        });
    engine.followJournal([self = QPointer<ServiceDoor>(this)](int waiting, const Message &trouble) {
        if (!self)
            return;
        self->m_journal.waiting = waiting;
        self->m_journal.trouble = trouble;
        Q_EMIT self->changed();
    });
    m_journal.station = hostName();
}

void ServiceDoor::keepJournal(const std::string &server, const std::string &station, Finished finished)
{
    JournalPlace place{station.empty() ? hostName() : station, {}};
    if (!server.empty()) {
        auto parsed = JournalServer::parse(server);
        if (!parsed)
            return finished(fail(parsed.error()));
        place.server = std::move(*parsed);
    }
    m_engine.askService(
        [engine = &m_engine, place](ServiceJobs &jobs) {
            const Result<void> taken = jobs.setStation(place.station);
            if (taken)
                engine->keepJournal(place); // before any unit of this station is written down
            return taken;
        },
        [this, self = QPointer<ServiceDoor>(this), server, given = station, name = place.station,
            finished = std::move(finished)](const Result<void> &result) {
            if (self && result) {
                m_journal.server = server;
                m_journal.station = name;
                Q_EMIT changed();
                Q_EMIT journalKept(QString::fromStdString(server), QString::fromStdString(given));
            }
            finished(result);
        });
}

void ServiceDoor::begin(const Plan &plan, Finished finished)
{
    m_engine.askService([plan](ServiceJobs &jobs) { return jobs.begin(plan); }, std::move(finished));
}

void ServiceDoor::pause(bool on)
{
    m_engine.askService([on](ServiceJobs &jobs) -> Result<void> { return jobs.pause(on), Result<void>(); }, {});
}

void ServiceDoor::skip(std::uint32_t row)
{
    m_engine.askService([row](ServiceJobs &jobs) -> Result<void> { return jobs.skip(row), Result<void>(); }, {});
}

void ServiceDoor::retry(std::uint32_t row)
{
    m_engine.askService([row](ServiceJobs &jobs) -> Result<void> { return jobs.retry(row), Result<void>(); }, {});
}

void ServiceDoor::retryFailed()
{
    m_engine.askService([](ServiceJobs &jobs) -> Result<void> { return jobs.retryFailed(), Result<void>(); }, {});
}

void ServiceDoor::cancel()
{
    m_engine.askService([](ServiceJobs &jobs) -> Result<void> { return jobs.cancel(), Result<void>(); }, {});
}

void ServiceDoor::finish()
{
    m_engine.askService([](ServiceJobs &jobs) -> Result<void> { return jobs.finish(), Result<void>(); }, {});
}

void ServiceDoor::arm(bool on)
{
    m_engine.askService([on](ServiceJobs &jobs) -> Result<void> { return jobs.arm(on), Result<void>(); }, {});
}

void ServiceDoor::renew()
{
    m_engine.askService([](ServiceJobs &jobs) -> Result<void> { return jobs.renew(), Result<void>(); }, {});
}

void ServiceDoor::findCut(const service::RecipeMatter &matter, CutFound found)
{
    m_engine.askBooks<CutRun>([recipe = matter.recipe.name, hash = matter.hash](
                                  Books &books) { return cutRunOf(books.service, recipe, hash); },
        std::move(found));
}

void ServiceDoor::list(const service::VisitFilter &filter, Listed listed)
{
    m_engine.askBooks<std::vector<service::Visit>>(
        [filter](Books &books) { return books.service.list(filter); }, std::move(listed));
}

void ServiceDoor::setNote(const std::string &visit, const QString &note, Finished finished)
{
    m_engine.askBooks<void>(
        [visit, text = note.toStdString()](Books &books) {
            const Result<void> kept = books.service.setNote(visit, text);
            if (books.shared)
                books.shared->deliverSoon();
            return kept;
        },
        std::move(finished));
}

void ServiceDoor::exportTo(const QString &path, std::vector<service::Visit> visits, Finished finished)
{
    m_engine.askBooks<void>(
        [file = path.toStdString(), visits = std::move(visits)](Books &) { return exportVisits(file, visits); },
        std::move(finished));
}

} // namespace mb
