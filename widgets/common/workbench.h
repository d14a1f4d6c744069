// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/parametertransfer.h"
#include "model/snapshot.h"
#include "transport/linkcatalog.h"

#include <QObject>
#include <QString>

#include <functional>
#include <map>
#include <memory>

namespace mb {

namespace tuning {
struct ExperimentPlan;
struct FrequencyResponse;
struct OwedGains;
struct PlantModel;
struct SweepPlan;
struct Trial;
struct TunePlan;
struct TuneReport;
} // namespace tuning
class SettingsArchive;
class TrialNotebook;

/// One line of the log of the window.
struct Notice {
    Instant time{};
    Severity severity = Severity::Info;
    QString device; ///< "DMC60C #5", or of a link "can0"; empty when it is about none
    QString text;
};

/// The door between the window and the devices, as pages see it: orders go in, snapshots come out, nothing waits.
/// Everything on the GUI thread; callbacks too, later, never from inside the call. The program's is app/engine.
class Workbench : public QObject {
    Q_OBJECT
public:
    using Finished = std::function<void(Result<void>)>;

    using QObject::QObject;

    [[nodiscard]] virtual const Snapshot &snapshot() const = 0;
    /// The present time on the line of all time stamps, and what to add to get Unix time.
    [[nodiscard]] virtual Instant now() const = 0;
    [[nodiscard]] virtual Duration unixOffset() const = 0;
    [[nodiscard]] virtual const std::vector<LinkListing> &listings() const = 0;

    virtual void openLink(const LinkAddress &address, Finished finished) = 0;
    virtual void closeLink(const std::string &address) = 0;
    /// Scans every open link.
    virtual void scan() = 0;
    /// Every rate and every address of this link, however long it takes; a scan that runs is ended for it.
    virtual void scanEverything(const std::string &link) = 0;
    /// Ends a scan; what it has found stays.
    virtual void cancelScan(const std::string &link) = 0;

    /// All readable parameters. An operation of the device.
    virtual void readParameters(DeviceId device) = 0;
    /// Writes with read-back; `finished` has the first error. An operation of the device.
    virtual void writeParameters(DeviceId device, std::vector<ParameterChange> changes, Finished finished) = 0;
    /// The same for values that were kept, in a snapshot for one: a snapshot of what is there is taken first.
    virtual void restoreParameters(DeviceId device, std::vector<ParameterChange> changes, Finished finished) = 0;
    /// Takes back the last write to the unit that can be undone, of any day, or does `again` what was undone last: a new write
    /// with its own proof. An operation of the device.
    virtual void undoWrite(DeviceId device, bool again, Finished finished) = 0;
    /// Keeps everything that can be read under a name; an empty one is "by hand". An operation of the device.
    virtual void takeSnapshot(DeviceId device, const QString &name, Finished finished) = 0;
    /// Snapshots and writes of earlier.
    [[nodiscard]] virtual SettingsArchive &settings() = 0;
    /// Writes what a reset took (DeviceProfile::lost) again. An operation of the device.
    virtual void rewriteSettings(DeviceId device, Finished finished) = 0;
    /// Finds out what the device does not tell (Family::experiments). An operation of the device; one that moves needs
    /// renewMotion() all the time. `finished` has the first error, the log of the operation what was found.
    virtual void experiment(
        DeviceId device, const std::string &key, const ExperimentOptions &options, Finished finished)
        = 0;
    using TrialMeasured = std::function<void(const tuning::Trial &)>;
    using TrialFinished = std::function<void(const Result<tuning::Trial> &)>;
    /// One guarded experiment on a loop (tuning/experiment.h), kept in the notebook. An operation of the device, which needs
    /// renewMotion() all the time; stopMotion() and stopAll() end it at any phase. `measured` when a hold has ended and the
    /// motor is on its way back; `finished` with the trial, or with why nothing has moved.
    virtual void runTrial(
        DeviceId device, const tuning::ExperimentPlan &plan, TrialMeasured measured, TrialFinished finished)
        = 0;
    using TuningFinished = std::function<void(const Result<tuning::TuneReport> &)>;
    /// Tunes a loop by itself (tuning/autotune.h), by several experiments in a row: an operation of the device like runTrial(),
    /// whose log tells each before it moves.
    virtual void runTuning(DeviceId device, const tuning::TunePlan &plan, TuningFinished finished) = 0;
    using SweepFinished = std::function<void(const Result<tuning::FrequencyResponse> &)>;
    /// A frequency response by sines one after the other (tuning/frequencyresponse.h): an operation like runTuning().
    virtual void runSweep(
        DeviceId device, const tuning::SweepPlan &plan, const tuning::PlantModel &plant, SweepFinished finished)
        = 0;
    [[nodiscard]] virtual TrialNotebook &trials() = 0;
    /// Gains that an experiment before has changed in a unit that is here, and that nobody has put back for certain.
    [[nodiscard]] virtual const std::map<DeviceId, std::vector<tuning::OwedGains>> &owedGains() const = 0;
    /// Puts back what a trial owes; or lets the unit keep what it has. Operations of the device.
    virtual void payGains(DeviceId device, std::int64_t trial, Finished finished) = 0;
    virtual void dismissGains(DeviceId device, std::int64_t trial, Finished finished) = 0;
    /// Waits for the device's own proof that flash has what RAM has. An operation of the device.
    virtual void storeParameters(DeviceId device, Finished finished) = 0;

    /// Blink; new name; new number. Operations of the device.
    virtual void identify(DeviceId device, Finished finished) = 0;
    virtual void rename(DeviceId device, const QString &name, Finished finished) = 0;
    virtual void renumber(DeviceId device, int address, Finished finished) = 0;
    virtual void clearFaults(DeviceId device, Finished finished) = 0;
    /// A number that only its user knows, and the dialect to speak against what the scan found (model/deviceprofile.h).
    virtual void calibrate(DeviceId device, const std::string &key, std::optional<double> value, Finished finished) = 0;
    virtual void setDialect(DeviceId device, const std::string &key, Finished finished) = 0;
    /// Samples per second wished for while a page shows the device; 0 returns to the device's own.
    virtual void setRate(DeviceId device, ChannelIndex channel, double hertz) = 0;

    /// Motion. The caller renews the lease from the GUI thread for as long as it means the motor to turn.
    virtual void startMotion(
        DeviceId device, const SetPoint &setPoint, std::chrono::milliseconds lease, Finished finished)
        = 0;
    virtual void updateMotion(DeviceId device, const SetPoint &setPoint, Finished finished) = 0;
    virtual void renewMotion(DeviceId device) = 0;
    virtual void stopMotion(DeviceId device) = 0;
    /// Starts the buffered moves of every device on the link of `device` at the same moment.
    virtual void releaseMoves(DeviceId device, Finished finished) = 0;
    /// Stops the motor, and lets its position count from 0 (Device::zeroPosition). An operation of the device.
    virtual void zeroPosition(DeviceId device, Finished finished) = 0;
    /// Every motor on every link, before anything else that waits, whatever the engine is busy with; of whom `cause` decides.
    virtual void stopAll(StopCause cause) = 0;
    /// The user has looked at the motors that may still turn: no stop is owed to them any more.
    virtual void dismissStops() = 0;

    /// An operation of the device; its report is in the snapshot.
    virtual void update(DeviceId device, std::shared_ptr<const FirmwareImage> image, UpdateOptions options) = 0;
    virtual void cancel(OperationId operation) = 0;

    /// Sends one frame by hand.
    virtual void sendFrame(const std::string &link, const CanFrame &frame, Finished finished) = 0;

    /// Writes what passes a CAN link to a file, as a candump log, or as Vector ASC where its name ends in `.asc`. How it goes
    /// is in the snapshot; when it ends, also by itself, a notice tells.
    virtual void startRecording(const std::string &link, const QString &path, Finished finished) = 0;
    virtual void stopRecording(const std::string &link) = 0;
    /// Of a `replay:` link; where it stands is in the snapshot.
    virtual void steerReplay(const std::string &link, const ReplayOrder &order) = 0;
    /// The present on the time line of a link: of a recording, where it stands; now() for others.
    [[nodiscard]] Instant presentOf(const std::string &link) const
    {
        const LinkView *view = snapshot().link(link);
        return view && view->replay ? view->time : now();
    }

    /// A line for the log and, for 8 s, the status bar.
    virtual void report(Severity severity, const QString &device, const QString &text) = 0;
    [[nodiscard]] virtual const std::vector<Notice> &notices() const = 0;

Q_SIGNALS:
    /// snapshot() is a new one; at most 30 times a second.
    void changed();
    void noticed(const mb::Notice &notice);
};

} // namespace mb
