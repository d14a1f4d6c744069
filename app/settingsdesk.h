// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/trialstore.h"
#include "widgets/common/settingsarchive.h"

namespace mb {

/// What is kept of settings for the window: orders go to the store, answers come back through the window's mailbox. Both outlive
/// it.
class SettingsDesk final : public SettingsArchive {
    Q_OBJECT
public:
    SettingsDesk(TrialStore &store, Mailbox &home, QObject *parent = nullptr);

    void list(const std::string &unit, Listed listed) override;
    void fetch(std::int64_t snapshot, Fetched fetched) override;

private:
    template <class T>
    void ask(std::function<Result<T>(SettingsBook &)> question, std::function<void(Result<T>)> answered);

    TrialStore &m_store;
    Mailbox &m_home;
};

} // namespace mb
