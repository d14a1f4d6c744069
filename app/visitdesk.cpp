// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/visitdesk.h"

#include "storage/visitjson.h"

namespace mb {
namespace {

/// Of the newest run on this station, if a unit of it is open still.
Result<CutRun> cutRunOf(ServiceBook &book, const std::string &recipe, const std::string &hash, bool simulated)
{
    MB_TRY(const auto run, book.lastRun(recipe, simulated));
    CutRun cut;
    cut.simulated = simulated;
    if (run.empty())
        return cut;
    service::VisitFilter filter;
    filter.run = run;
    filter.recipeHash = hash;
    MB_TRY(const auto visits, book.list(filter));
    for (const service::Visit &visit : visits)
        ++(visit.outcome == service::Outcome::Open ? cut.open : cut.ended);
    if (cut.open > 0)
        cut.run = run;
    return cut;
}

} // namespace

VisitDesk::VisitDesk(TrialStore &store, Mailbox &home, QObject *parent)
    : VisitArchive(parent)
    , m_store(store)
    , m_home(home)
{
}

void VisitDesk::list(const service::VisitFilter &filter, Listed listed)
{
    m_store.ask<std::vector<service::Visit>>(
        m_home, [filter](Books &books) { return books.service.list(filter); }, std::move(listed));
}

void VisitDesk::findCut(const service::RecipeMatter &matter, CutFound found)
{
    m_store.ask<CutRun>(
        m_home,
        [recipe = matter.recipe.name, hash = matter.hash](Books &books) {
            auto cut = cutRunOf(books.service, recipe, hash, false);
            return cut && !cut->run.empty() ? cut : cutRunOf(books.service, recipe, hash, true);
        },
        std::move(found));
}

void VisitDesk::setNote(const std::string &visit, const QString &note, Finished finished)
{
    m_store.ask<void>(
        m_home,
        [visit, text = note.toStdString()](Books &books) {
            const Result<void> kept = books.service.setNote(visit, text);
            if (books.shared)
                books.shared->deliverSoon();
            return kept;
        },
        std::move(finished));
}

void VisitDesk::exportTo(const QString &path, std::vector<service::Visit> visits, Finished finished)
{
    m_store.ask<void>(
        m_home, [file = path.toStdString(), visits = std::move(visits)](Books &) { return exportVisits(file, visits); },
        std::move(finished));
}

} // namespace mb
