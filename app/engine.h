// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine/enginecore.h"
#include "app/engine/stopcount.h"
#include "app/stopthread.h"
#include "app/trialstore.h"
#include "async/mailbox.h"
#include "transport/qtclock.h"
#include "widgets/common/serviceview.h"
#include "widgets/common/workbench.h"

#include <atomic>
#include <memory>

class QSocketNotifier;

namespace mb {

/// The door between the two threads, and the only one. Orders are posted to the engine thread's mailbox; snapshots, notices
/// and results come back through the window's. At most one snapshot is under way, so a window that hangs is not buried.
class Engine final : public Workbench {
    Q_OBJECT
public:
    Engine(std::span<const Family *const> families, bool opensByItself, QObject *parent = nullptr);
    /// Stops every motor, then ends the engine thread, and waits until it and the user's file have ended.
    ~Engine() override;
    /// The same with a limit. False: what hangs uses this object on, which must not be destroyed; nothing but the end of the process
    /// ends it. Every motor was then told to stop past the engine, and what a guardian watches it stops at that end. Again later
    /// where more is to be waited.
    [[nodiscard]] bool end(std::chrono::milliseconds limit);

    [[nodiscard]] const Snapshot &snapshot() const override { return m_snapshot; }
    [[nodiscard]] Instant now() const override { return m_clock.now(); }
    [[nodiscard]] Duration unixOffset() const override { return m_clock.unixOffset(); }
    [[nodiscard]] SleepLog sleeps() override { return m_clock.sleeps(); }
    [[nodiscard]] const std::vector<LinkListing> &listings() const override { return m_listings; }

    [[nodiscard]] SettingsArchive &settings() override { return *m_archive; }
    [[nodiscard]] TrialNotebook &trials() override { return *m_notebook; }
    [[nodiscard]] VisitArchive &visits() override { return *m_visits; }
    [[nodiscard]] const JournalState &journal() const override { return m_journal; }
    [[nodiscard]] const ServiceView &service() const override { return m_service; }
    [[nodiscard]] const std::map<DeviceId, std::vector<tuning::OwedGains>> &owedGains() const override
    {
        return m_owedGains;
    }
    void stopAll(StopCause cause) override;
    void report(Severity severity, const QString &device, const QString &text) override;
    [[nodiscard]] const std::vector<Notice> &notices() const override { return m_notices; }

    /// Runs `work` on the engine thread. For tests that disturb a simulated device.
    void post(std::function<void(EngineCore &)> work);

Q_SIGNALS:
    /// The journal is kept by this order from now on: to be remembered for the next start.
    void journalChosen(const QString &server, const QString &station);

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
        std::optional<ServiceView> service; ///< nothing: as it was
    };
    struct Ending {
        bool begun = false; ///< it was told to
        std::atomic<bool> stopped = false;
    };
    void takePicture(Picture picture);
    void takeJournal(const std::string &station, const orders::KeepJournal &order);
    void takeDelivery(int waiting, const Message &trouble);

    QtClock m_clock;
    StopThread m_stopLane;
    StopCount m_stops;
    Mailbox m_toEngine;
    Mailbox m_toWindow;
    std::unique_ptr<QSocketNotifier> m_arrivals;
    std::atomic<bool> m_snapshotUnderWay = false;
    Ending m_ending;
    Snapshot m_snapshot;
    std::vector<LinkListing> m_listings;
    std::vector<Notice> m_notices;
    std::map<DeviceId, std::vector<tuning::OwedGains>> m_owedGains;
    TrialStore m_store;
    std::unique_ptr<TrialNotebook> m_notebook;
    std::unique_ptr<SettingsArchive> m_archive;
    std::unique_ptr<VisitArchive> m_visits;
    ServiceView m_service;
    JournalState m_journal;
    Worker *m_worker = nullptr; ///< the engine thread's; touched only there
    std::unique_ptr<Loop> m_thread;
};

} // namespace mb
