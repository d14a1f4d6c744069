// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine/devicejobs.h"
#include "app/engine/devicepresence.h"
#include "app/engine/firmwareupdates.h"
#include "app/engine/links.h"
#include "app/engine/servicejobs.h"
#include "app/engine/snapshotpublisher.h"
#include "async/noncopyable.h"
#include "widgets/orders/reply.h"

namespace mb {

/// The engine thread's half of the door: the session, and parts by responsibility that carry out orders and look after what goes on
/// by itself. Knows no Qt and no thread, so that tests drive it on a virtual clock.
class EngineCore : NonCopyable {
public:
    /// `opensByItself`: also opens CAN interfaces that are up, as they come (docs/names.md#links).
    /// `guard` watches over motors without a watchdog, and outlives this.
    EngineCore(Clock &clock, std::span<const Family *const> families, bool opensByItself, MotionGuard *guard = nullptr);
    /// Stops every motor; whoever waits for an answer has one.
    ~EngineCore();

    /// Does what was ordered, and sees that it is answered (widgets/orders): by the part that has a carryOut() for it.
    void carryOut(const Order &order, const Reply &reply);
    /// The same, as Workbench::send() has it.
    template <class O> void send(O order, std::function<void(Result<AnswerOf<O>>)> finished = {})
    {
        carryOut(Order(std::move(order)), Reply(Reply::from<AnswerOf<O>>(std::move(finished))));
    }
    /// STOP: every motor, at once; nothing that is served turns one any more.
    void stopAll(StopCause cause);
    /// Before the end, which `done` may bring: what this program has asked of devices for itself is given back (Rates::end()).
    void wrapUp(std::function<void()> done) { m_rates.end(std::move(done)); }

    [[nodiscard]] Session &session() { return m_session; }
    [[nodiscard]] Snapshot snapshot() const { return m_publisher.take(); }
    /// For the one who shows them (SnapshotPublisher).
    [[nodiscard]] SnapshotChanges changes() { return m_publisher.changes(); }
    /// Lines for the log: severity, device, English text.
    [[nodiscard]] Listeners<Severity, const std::string &, const Message &> &noticed() { return m_log.noticed(); }
    /// What goes back unless somebody keeps it.
    [[nodiscard]] ProvisionalChanges &provisional() { return m_provisional; }
    [[nodiscard]] Links &links() { return m_links; }
    [[nodiscard]] ServiceJobs &service() { return m_service; }
    /// What earlier experiments owe to units that are here; it is looked for when a unit has told who it is.
    [[nodiscard]] const std::map<DeviceId, std::vector<tuning::OwedGains>> &owedGains() const { return m_owed.owed(); }

    /// From now on what may block is done there. Outlives this.
    void setBackground(Background *background);
    /// From now on snapshots are kept and every write is in the history. The log outlives this.
    void setSettingsLog(settings::SettingsLog *log);
    /// From now on trials are kept, and what they change is written down first. The journal outlives this.
    void setJournal(tuning::ExperimentJournal *journal);
    /// From now on the log of each update is kept in this folder, one file an update.
    void keepTranscripts(std::string folder) { m_firmware.keepTranscripts(std::move(folder)); }

private:
    void look();

    Session m_session;
    EngineLog m_log;
    Operations m_operations;
    EngineContext m_context;
    Motion m_motion;
    Recordings m_recordings;
    Scans m_scans;
    Links m_links;
    ProvisionalChanges m_provisional;
    ParameterJobs m_parameters;
    DeviceJobs m_jobs;
    FirstSnapshots m_firstSnapshots;
    Rates m_rates;
    OwedBook m_owed;
    Trials m_trials;
    FirmwareUpdates m_firmware;
    DevicePresence m_presence;
    ServiceJobs m_service;
    SnapshotPublisher m_publisher;
    Timer m_look;
};

} // namespace mb
