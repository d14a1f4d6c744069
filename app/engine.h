// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine/enginecore.h"
#include "app/stopthread.h"
#include "app/trialstore.h"
#include "async/mailbox.h"
#include "transport/qtclock.h"
#include "widgets/common/workbench.h"

#include <atomic>
#include <memory>

class QSocketNotifier;

namespace mb {

class ServiceJobs;
struct ServiceView;

/// The door between the two threads, and the only one. Orders are posted to the engine thread's mailbox; snapshots, notices
/// and results come back through the window's. At most one snapshot is under way, so a window that hangs is not buried.
class Engine final : public Workbench {
    Q_OBJECT
public:
    Engine(std::span<const Family *const> families, bool opensByItself, QObject *parent = nullptr);
    /// Stops every motor, then ends the engine thread.
    ~Engine() override;

    [[nodiscard]] const Snapshot &snapshot() const override { return m_snapshot; }
    [[nodiscard]] Instant now() const override { return m_clock.now(); }
    [[nodiscard]] Duration unixOffset() const override { return m_clock.unixOffset(); }
    [[nodiscard]] const std::vector<LinkListing> &listings() const override { return m_listings; }

    [[nodiscard]] SettingsArchive &settings() override;
    [[nodiscard]] TrialNotebook &trials() override;
    [[nodiscard]] const std::map<DeviceId, std::vector<tuning::OwedGains>> &owedGains() const override
    {
        return m_owedGains;
    }
    void stopAll(StopCause cause) override;
    void report(Severity severity, const QString &device, const QString &text) override;
    [[nodiscard]] const std::vector<Notice> &notices() const override { return m_notices; }

    /// The service of units: `work` runs on the engine thread, `finished` hears of it here.
    void askService(std::function<Result<void>(ServiceJobs &)> work, std::function<void(Result<void>)> finished);
    /// From now on, here: every view that is another, at most 30 times a second, and every unit that has ended.
    void followService(
        std::function<void(const ServiceView &)> viewed, std::function<void(const service::Visit &)> ended);

    /// As ServiceDesk::keepJournal(); nothing is served meanwhile. From any thread.
    void keepJournal(JournalPlace place) { m_store.keepJournal(std::move(place)); }
    /// From now on, here: how many entries the journal's server has not got, and why. Before keepJournal().
    void followJournal(std::function<void(int waiting, const Message &trouble)> told);

    /// A question of the user's file, answered here later.
    template <class T>
    void askBooks(std::function<Result<T>(Books &)> question, std::function<void(Result<T>)> answered)
    {
        m_store.ask<T>(m_toWindow, std::move(question), std::move(answered));
    }

    /// Runs `work` on the engine thread. For tests that disturb a simulated device.
    void post(std::function<void(EngineCore &)> work);

private:
    struct Journals;
    class Worker;
    class Loop;

    void deliver(Order order, Reply::Finished finished) override;
    /// What the window knows of the engine, taken at one moment.
    struct Picture {
        SnapshotChanges changes;
        std::vector<LinkListing> listings;
        std::map<DeviceId, std::vector<tuning::OwedGains>> owedGains;
    };
    void takePicture(Picture picture);

    QtClock m_clock;
    StopThread m_stopLane;
    Mailbox m_toEngine;
    Mailbox m_toWindow;
    std::unique_ptr<QSocketNotifier> m_arrivals;
    std::atomic<bool> m_snapshotUnderWay = false;
    Snapshot m_snapshot;
    std::vector<LinkListing> m_listings;
    std::vector<Notice> m_notices;
    std::map<DeviceId, std::vector<tuning::OwedGains>> m_owedGains;
    TrialStore m_store;
    std::unique_ptr<TrialNotebook> m_notebook;
    std::unique_ptr<SettingsArchive> m_archive;
    Worker *m_worker = nullptr; ///< the engine thread's; touched only there
    std::unique_ptr<Loop> m_thread;
};

} // namespace mb
