// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/trialstore.h"
#include "widgets/common/trialnotebook.h"

namespace mb {

/// The notebook for the window: orders go to the store, answers come back through the window's mailbox. Both outlive it.
class TrialDesk final : public TrialNotebook {
    Q_OBJECT
public:
    TrialDesk(TrialStore &store, Mailbox &home, QObject *parent = nullptr);

    void list(const std::string &unit, Listed listed) override;
    void fetch(std::int64_t number, Fetched fetched) override;
    void setStar(std::int64_t number, bool star, Finished finished) override;
    void setNote(std::int64_t number, const QString &note, Finished finished) override;
    void remove(std::int64_t number, Finished finished) override;
    void gather(const ReportWish &wish, Gathered gathered) override;
    void exportTo(const QString &path, std::vector<KeptTrial> trials, Finished finished) override;

private:
    template <class T>
    void ask(std::function<Result<T>(TrialBook &)> question, std::function<void(Result<T>)> answered);

    TrialStore &m_store;
    Mailbox &m_home;
};

} // namespace mb
