// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine.h"
#include "widgets/service/servicedesk.h"

namespace mb {

/// The service of units in the engine's thread, as the window sees it.
class ServiceDoor final : public ServiceDesk {
    Q_OBJECT
public:
    explicit ServiceDoor(Engine &engine);

    [[nodiscard]] const ServiceView &view() const override { return m_view; }
    void begin(const Plan &plan, Finished finished) override;
    void pause(bool on) override;
    void skip(std::uint32_t row) override;
    void retry(std::uint32_t row) override;
    void retryFailed() override;
    void finish() override;
    void cancel() override;
    void arm(bool on) override;
    void renew() override;
    [[nodiscard]] const JournalState &journal() const override { return m_journal; }
    void keepJournal(const std::string &server, const std::string &station, Finished finished) override;
    void findCut(const service::RecipeMatter &matter, CutFound found) override;
    void list(const service::VisitFilter &filter, Listed listed) override;
    void setNote(const std::string &visit, const QString &note, Finished finished) override;
    void exportTo(const QString &path, std::vector<service::Visit> visits, Finished finished) override;

private:
    ServiceView m_view;
    JournalState m_journal;
    Engine &m_engine;
};

} // namespace mb
