// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trialdesk.h"

#include "model/registry.h"
#include "storage/reportmatter.h"
#include "storage/trialfile.h"

namespace mb {

TrialDesk::TrialDesk(TrialStore &store, Mailbox &home, QObject *parent)
    : TrialNotebook(parent)
    , m_store(store)
    , m_home(home)
{
}

template <class T>
void TrialDesk::ask(std::function<Result<T>(TrialBook &)> question, std::function<void(Result<T>)> answered)
{
    m_store.ask<T>(
        m_home, [question = std::move(question)](Books &books) { return question(books.trials); }, std::move(answered));
}

void TrialDesk::list(const std::string &unit, Listed listed)
{
    ask<std::vector<KeptTrial>>([unit](TrialBook &book) { return book.listOf(unit); }, std::move(listed));
}

void TrialDesk::fetch(std::int64_t number, Fetched fetched)
{
    ask<std::vector<tuning::Signal>>([number](TrialBook &book) { return book.signals(number); }, std::move(fetched));
}

void TrialDesk::setStar(std::int64_t number, bool star, Finished finished)
{
    ask<void>([number, star](TrialBook &book) { return book.setStar(number, star); }, std::move(finished));
}

void TrialDesk::setNote(std::int64_t number, const QString &note, Finished finished)
{
    ask<void>([number, text = note.toStdString()](TrialBook &book) { return book.setNote(number, text); },
        std::move(finished));
}

void TrialDesk::remove(std::int64_t number, Finished finished)
{
    ask<void>([number](TrialBook &book) { return book.remove(number); }, std::move(finished));
}

void TrialDesk::gather(const ReportWish &wish, Gathered gathered)
{
    ask<std::vector<ReportUnit>>(
        [wish](TrialBook &book) { return reportUnits(book, families(), wish); }, std::move(gathered));
}

void TrialDesk::exportTo(const QString &path, std::vector<KeptTrial> trials, Finished finished)
{
    ask<void>(
        [file = path.toStdString(), trials = std::move(trials)](TrialBook &) { return exportTrials(file, trials); },
        std::move(finished));
}

} // namespace mb
