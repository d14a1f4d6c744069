// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine/lentlinks.h"
#include "app/engine/stationpermit.h"
#include "async/noncopyable.h"
#include "storage/journalserver.h"
#include "widgets/common/serviceview.h"
#include "widgets/orders/serviceorders.h"

#include <set>

namespace mb {

/// Units that are served in the engine's session: the queue on links that are lent to it, and what the window sees of it. Engine thread.
class ServiceJobs : NonCopyable {
public:
    /// Who writes down what becomes of a unit; they outlive this.
    struct Books {
        service::ServiceJournal *visits = nullptr;
        settings::SettingsLog *settings = nullptr;
        tuning::ExperimentJournal *trials = nullptr;
    };
    ServiceJobs(const EngineContext &context, Scans &scans);
    ~ServiceJobs();

    /// Without a journal of visits nothing is served (Unsupported); what is served is cut off and stays open in the journal before.
    /// `station`: its name there, until somebody chooses another.
    void setBooks(const Books &books, std::string station);

    void carryOut(const orders::ServeUnits &order, const Finished &finished);
    void carryOut(const orders::PauseService &order, const Finished &finished);
    void carryOut(const orders::SkipUnit &order, const Finished &finished);
    void carryOut(const orders::RetryUnit &order, const Finished &finished);
    void carryOut(const orders::RetryFailedUnits &order, const Finished &finished);
    void carryOut(const orders::FinishService &order, const Finished &finished);
    void carryOut(const orders::CancelService &order, const Finished &finished);
    void carryOut(const orders::ArmService &order, const Finished &finished);
    void carryOut(const orders::RenewService &order, const Finished &finished);
    void carryOut(const orders::KeepJournal &order, const Finished &finished);
    void arm(bool on) { m_permit.arm(on && isRunning() && m_matter->recipe.test); }
    /// Motors of units stop with all others; nothing is armed any more, and the queue ends.
    void stop();
    [[nodiscard]] ServiceView view() const;
    [[nodiscard]] bool mustStayAwake() const { return m_queue && m_queue->mustStayAwake(); }

    [[nodiscard]] Listeners<> &changed() { return m_changed; }
    [[nodiscard]] Listeners<const service::Visit &> &unitEnded() { return m_unitEnded; }
    /// The journal is kept there from now on, by this order: before any unit is written down.
    [[nodiscard]] Listeners<const JournalPlace &, const orders::KeepJournal &> &journalChosen()
    {
        return m_journalChosen;
    }

private:
    [[nodiscard]] Result<void> begin(const orders::ServeUnits &order);
    void queueChanged();
    void choose();
    void ended(const service::Visit &visit);
    Result<void> again(const std::function<Result<void>()> &order);
    void followLinks();
    void leave();
    [[nodiscard]] bool isRunning() const { return m_queue && m_queue->isRunning(); }

    EngineContext m_context;
    LentLinks m_links;
    StationPermit m_permit;
    Books m_books;
    std::string m_computer; ///< name of this station where nobody has chosen one
    std::string m_station;
    std::optional<std::set<DeviceId>> m_chosen; ///< as orders::ServeUnits::chosen
    std::set<std::uint32_t> m_judged;           ///< rows that were taken or left
    Message m_trouble;
    ServiceView m_last; ///< of a queue whose link is gone
    Listeners<> m_changed;
    Listeners<const service::Visit &> m_unitEnded;
    Listeners<const JournalPlace &, const orders::KeepJournal &> m_journalChosen;
    std::shared_ptr<const service::RecipeMatter> m_matter; ///< of the queue
    std::unique_ptr<service::ServiceQueue> m_queue;
    Subscription m_queueChanged;
    Subscription m_queueEnded;
    Subscription m_visitEnded;
    Subscription m_sessionChanged;
    Subscription m_permitChanged;
};

} // namespace mb
