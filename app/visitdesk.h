// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/trialstore.h"
#include "widgets/common/visitarchive.h"

namespace mb {

/// The journal of service for the window: questions go to the store, answers come back through the window's mailbox. Both outlive it.
class VisitDesk final : public VisitArchive {
    Q_OBJECT
public:
    VisitDesk(TrialStore &store, Mailbox &home, QObject *parent = nullptr);

    void list(const service::VisitFilter &filter, Listed listed) override;
    void findCut(const service::RecipeMatter &matter, CutFound found) override;
    void setNote(const std::string &visit, const QString &note, Finished finished) override;
    void exportTo(const QString &path, std::vector<service::Visit> visits, Finished finished) override;

private:
    TrialStore &m_store;
    Mailbox &m_home;
};

} // namespace mb
