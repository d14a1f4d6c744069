// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settingsdesk.h"

#include <memory>

namespace mb {

SettingsDesk::SettingsDesk(TrialStore &store, Mailbox &home, QObject *parent)
    : SettingsArchive(parent)
    , m_store(store)
    , m_home(home)
{
}

template <class T>
void SettingsDesk::ask(std::function<Result<T>(SettingsBook &)> question, std::function<void(Result<T>)> answered)
{
    m_store.post(
        [home = &m_home, question = std::move(question), answered = std::move(answered)](const Result<Books *> &books) {
            auto result
                = std::make_shared<Result<T>>(books ? question((*books)->settings) : Result<T>(fail(books.error())));
            home->post([answered, result] {
                if (answered)
                    answered(std::move(*result));
            });
        });
}

void SettingsDesk::list(const std::string &unit, Listed listed)
{
    ask<SettingsTimeline>(
        [unit](SettingsBook &book) -> Result<SettingsTimeline> {
            auto snapshots = book.snapshots(unit);
            if (!snapshots)
                return fail(snapshots.error());
            auto changes = book.changes(unit);
            if (!changes)
                return fail(changes.error());
            return SettingsTimeline{std::move(*snapshots), std::move(*changes)};
        },
        std::move(listed));
}

void SettingsDesk::fetch(std::int64_t snapshot, Fetched fetched)
{
    ask<settings::ParameterSnapshot>(
        [snapshot](SettingsBook &book) { return book.find(std::to_string(snapshot)); }, std::move(fetched));
}

} // namespace mb
