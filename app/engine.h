// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/enginecore.h"
#include "app/stopthread.h"
#include "app/trialstore.h"
#include "async/mailbox.h"
#include "transport/qtclock.h"
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
    /// Stops every motor, then ends the engine thread.
    ~Engine() override;

    [[nodiscard]] const Snapshot &snapshot() const override { return m_snapshot; }
    [[nodiscard]] Instant now() const override { return m_clock.now(); }
    [[nodiscard]] Duration unixOffset() const override { return m_clock.unixOffset(); }
    [[nodiscard]] const std::vector<LinkListing> &listings() const override { return m_listings; }

    void openLink(const LinkAddress &address, Finished finished) override;
    void closeLink(const std::string &address) override;
    void scan() override;
    void scanEverything(const std::string &link) override;
    void cancelScan(const std::string &link) override;
    void readParameters(DeviceId device) override;
    void writeParameters(DeviceId device, std::vector<ParameterChange> changes, Finished finished) override;
    void restoreParameters(DeviceId device, std::vector<ParameterChange> changes, Finished finished) override;
    void undoWrite(DeviceId device, bool again, Finished finished) override;
    void takeSnapshot(DeviceId device, const QString &name, Finished finished) override;
    [[nodiscard]] SettingsArchive &settings() override;
    void storeParameters(DeviceId device, Finished finished) override;
    void rewriteSettings(DeviceId device, Finished finished) override;
    void experiment(
        DeviceId device, const std::string &key, const ExperimentOptions &options, Finished finished) override;
    void runTrial(
        DeviceId device, const tuning::ExperimentPlan &plan, TrialMeasured measured, TrialFinished finished) override;
    void runTuning(DeviceId device, const tuning::TunePlan &plan, TuningFinished finished) override;
    void runSweep(DeviceId device, const tuning::SweepPlan &plan, const tuning::PlantModel &plant,
        SweepFinished finished) override;
    [[nodiscard]] TrialNotebook &trials() override;
    [[nodiscard]] const std::map<DeviceId, std::vector<tuning::OwedGains>> &owedGains() const override
    {
        return m_owedGains;
    }
    void payGains(DeviceId device, std::int64_t trial, Finished finished) override;
    void dismissGains(DeviceId device, std::int64_t trial, Finished finished) override;
    void identify(DeviceId device, Finished finished) override;
    void rename(DeviceId device, const QString &name, Finished finished) override;
    void renumber(DeviceId device, int address, Finished finished) override;
    void clearFaults(DeviceId device, Finished finished) override;
    void calibrate(DeviceId device, const std::string &key, std::optional<double> value, Finished finished) override;
    void setDialect(DeviceId device, const std::string &key, Finished finished) override;
    void setRate(DeviceId device, ChannelIndex channel, double hertz) override;
    void startMotion(
        DeviceId device, const SetPoint &setPoint, std::chrono::milliseconds lease, Finished finished) override;
    void updateMotion(DeviceId device, const SetPoint &setPoint, Finished finished) override;
    void renewMotion(DeviceId device) override;
    void stopMotion(DeviceId device) override;
    void releaseMoves(DeviceId device, Finished finished) override;
    void zeroPosition(DeviceId device, Finished finished) override;
    void stopAll(StopCause cause) override;
    void dismissStops() override;
    void update(DeviceId device, std::shared_ptr<const FirmwareImage> image, UpdateOptions options) override;
    void cancel(OperationId operation) override;
    void sendFrame(const std::string &link, const CanFrame &frame, Finished finished) override;
    void startRecording(const std::string &link, const QString &path, Finished finished) override;
    void stopRecording(const std::string &link) override;
    void steerReplay(const std::string &link, const ReplayOrder &order) override;
    void report(Severity severity, const QString &device, const QString &text) override;
    [[nodiscard]] const std::vector<Notice> &notices() const override { return m_notices; }

    /// Runs `work` on the engine thread. For tests that disturb a simulated device.
    void post(std::function<void(EngineCore &)> work);

private:
    struct Room;
    class Loop;

    /// A callback that hops back to the window's thread.
    [[nodiscard]] EngineCore::Finished comeBack(Finished finished);
    /// What the window knows of the engine, taken at one moment.
    struct Picture {
        Snapshot snapshot;
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
    Room *m_room = nullptr; ///< the engine thread's; touched only there
    std::unique_ptr<Loop> m_thread;
};

} // namespace mb
