// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settingsdesk.h"

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
    m_store.ask<T>(
        m_home, [question = std::move(question)](Books &books) { return question(books.settings); },
        std::move(answered));
}

void SettingsDesk::list(const std::string &unit, Listed listed)
{
    ask<SettingsTimeline>(
        [unit](SettingsBook &book) -> Result<SettingsTimeline> {
            MB_TRY(auto snapshots, book.snapshots(unit));
            MB_TRY(auto changes, book.changes(unit));
            return SettingsTimeline{std::move(snapshots), std::move(changes)};
        },
        std::move(listed));
}

void SettingsDesk::fetch(std::int64_t snapshot, Fetched fetched)
{
    ask<settings::ParameterSnapshot>(
        [snapshot](SettingsBook &book) { return book.find(std::to_string(snapshot)); }, std::move(fetched));
}

} // namespace mb
