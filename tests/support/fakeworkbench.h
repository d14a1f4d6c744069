// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fakearchive.h"
#include "fakenotebook.h"
#include "tuning/autotune.h"
#include "tuning/experiment.h"
#include "tuning/frequencyresponse.h"
#include "widgets/common/workbench.h"

#include <deque>

namespace mb::test {

/// A workbench without devices: the test sets the snapshot and the time, and reads what was asked for.
class FakeWorkbench : public Workbench {
public:
    using Workbench::Workbench;

    /// One order as the page gave it; only what belongs to its kind is set.
    struct Call {
        std::string what; ///< name of the function
        DeviceId device{};
        std::string text{}; ///< address, name, link or line of the log
        std::vector<ParameterChange> changes{};
        SetPoint setPoint{};
        double number = 0.0; ///< rate, address, lease in ms
        ChannelIndex channel{};
        CanFrame frame{};
        QString path{};
        ReplayOrder order{};
        Finished finished{}; ///< call it to end the order, later than the order itself
    };

    /// An experiment as the page gave it; call `finished` to end it.
    struct Planned {
        tuning::ExperimentPlan plan;
        TrialMeasured measured;
        TrialFinished finished;
    };

    struct Tuned {
        tuning::TunePlan plan;
        TuningFinished finished;
    };

    struct Swept {
        tuning::SweepPlan plan;
        SweepFinished finished;
    };

    std::vector<Planned> plans;
    std::vector<Swept> sweeps;
    std::vector<Tuned> tunings;
    FakeNotebook book;
    FakeArchive archive;
    std::map<DeviceId, std::vector<tuning::OwedGains>> owed;
    Snapshot shot;
    Instant time{std::chrono::seconds(1000)};
    std::vector<LinkListing> links;
    std::vector<Notice> lines;
    std::vector<Call> calls;

    /// Tells the pages of a new snapshot.
    void publish()
    {
        shot.time = time;
        Q_EMIT changed();
    }
    [[nodiscard]] std::vector<Call> callsOf(const std::string &what) const
    {
        std::vector<Call> found;
        for (const Call &call : calls) {
            if (call.what == what)
                found.push_back(call);
        }
        return found;
    }
    [[nodiscard]] DeviceView &device(std::size_t place) { return shot.devices.at(place); }

    const Snapshot &snapshot() const override { return shot; }
    Instant now() const override { return time; }
    Duration unixOffset() const override { return {}; }
    const std::vector<LinkListing> &listings() const override { return links; }
    void openLink(const LinkAddress &address, Finished finished) override
    {
        note({"openLink", {}, address.text()}, std::move(finished));
    }
    void closeLink(const std::string &address) override { note({"closeLink", {}, address}); }
    void scan() override { note({"scan"}); }
    void scanEverything(const std::string &link) override { note({"scanEverything", {}, link}); }
    void cancelScan(const std::string &link) override { note({"cancelScan", {}, link}); }
    void readParameters(DeviceId device) override { note({"readParameters", device}); }
    void writeParameters(DeviceId device, std::vector<ParameterChange> changes, Finished finished) override
    {
        Call call{"writeParameters", device};
        call.changes = std::move(changes);
        note(std::move(call), std::move(finished));
    }
    void restoreParameters(DeviceId device, std::vector<ParameterChange> changes, Finished finished) override
    {
        Call call{"restoreParameters", device};
        call.changes = std::move(changes);
        note(std::move(call), std::move(finished));
    }
    void undoWrite(DeviceId device, bool again, Finished finished) override
    {
        note({again ? "redoWrite" : "undoWrite", device}, std::move(finished));
    }
    void takeSnapshot(DeviceId device, const QString &name, Finished finished) override
    {
        note({"takeSnapshot", device, name.toStdString()}, std::move(finished));
    }
    SettingsArchive &settings() override { return archive; }
    void rewriteSettings(DeviceId device, Finished finished) override
    {
        note({"rewriteSettings", device}, std::move(finished));
    }
    void experiment(
        DeviceId device, const std::string &key, const ExperimentOptions &options, Finished finished) override
    {
        Call call{"experiment", device, key};
        call.setPoint.axis = options.axis;
        call.number = options.power;
        note(std::move(call), std::move(finished));
    }
    void runTrial(
        DeviceId device, const tuning::ExperimentPlan &plan, TrialMeasured measured, TrialFinished finished) override
    {
        plans.push_back({plan, std::move(measured), std::move(finished)});
        note({"runTrial", device});
    }
    void runTuning(DeviceId device, const tuning::TunePlan &plan, TuningFinished finished) override
    {
        tunings.push_back({plan, std::move(finished)});
        note({"runTuning", device});
    }
    void runSweep(
        DeviceId device, const tuning::SweepPlan &plan, const tuning::PlantModel &, SweepFinished finished) override
    {
        sweeps.push_back({plan, std::move(finished)});
        note({"runSweep", device});
    }
    TrialNotebook &trials() override { return book; }
    const std::map<DeviceId, std::vector<tuning::OwedGains>> &owedGains() const override { return owed; }
    void payGains(DeviceId device, std::int64_t trial, Finished finished) override
    {
        noteNumber("payGains", device, static_cast<double>(trial), std::move(finished));
    }
    void dismissGains(DeviceId device, std::int64_t trial, Finished finished) override
    {
        noteNumber("dismissGains", device, static_cast<double>(trial), std::move(finished));
    }
    void storeParameters(DeviceId device, Finished finished) override
    {
        note({"storeParameters", device}, std::move(finished));
    }
    void identify(DeviceId device, Finished finished) override { note({"identify", device}, std::move(finished)); }
    void rename(DeviceId device, const QString &name, Finished finished) override
    {
        note({"rename", device, name.toStdString()}, std::move(finished));
    }
    void renumber(DeviceId device, int address, Finished finished) override
    {
        noteNumber("renumber", device, address, std::move(finished));
    }
    void clearFaults(DeviceId device, Finished finished) override
    {
        note({"clearFaults", device}, std::move(finished));
    }
    void calibrate(DeviceId device, const std::string &key, std::optional<double> value, Finished finished) override
    {
        Call call{"calibrate", device, key};
        call.number = value.value_or(0.0);
        note(std::move(call), std::move(finished));
    }
    void setDialect(DeviceId device, const std::string &key, Finished finished) override
    {
        note({"setDialect", device, key}, std::move(finished));
    }
    void setRate(DeviceId device, ChannelIndex channel, double hertz) override
    {
        Call call{"setRate", device};
        call.number = hertz;
        call.channel = channel;
        note(std::move(call));
    }
    void startMotion(
        DeviceId device, const SetPoint &setPoint, std::chrono::milliseconds lease, Finished finished) override
    {
        Call call{"startMotion", device};
        call.setPoint = setPoint;
        call.number = static_cast<double>(lease.count());
        note(std::move(call), std::move(finished));
    }
    void updateMotion(DeviceId device, const SetPoint &setPoint, Finished finished) override
    {
        Call call{"updateMotion", device};
        call.setPoint = setPoint;
        note(std::move(call), std::move(finished));
    }
    void renewMotion(DeviceId device) override { note({"renewMotion", device}); }
    void stopMotion(DeviceId device) override { note({"stopMotion", device}); }
    void releaseMoves(DeviceId device, Finished finished) override
    {
        note({"releaseMoves", device}, std::move(finished));
    }
    void zeroPosition(DeviceId device, Finished finished) override
    {
        note({"zeroPosition", device}, std::move(finished));
    }
    void stopAll(StopCause cause) override { note({"stopAll", {}, cause == StopCause::User ? "user" : "program"}); }
    void dismissStops() override { note({"dismissStops"}); }
    void update(DeviceId device, std::shared_ptr<const FirmwareImage>, UpdateOptions) override
    {
        note({"update", device});
    }
    void cancel(OperationId operation) override { noteNumber("cancel", {}, operation.value, {}); }
    void sendFrame(const std::string &link, const CanFrame &frame, Finished finished) override
    {
        Call call{"sendFrame", {}, link};
        call.frame = frame;
        note(std::move(call), std::move(finished));
    }
    void startRecording(const std::string &link, const QString &path, Finished finished) override
    {
        Call call{"startRecording", {}, link};
        call.path = path;
        note(std::move(call), std::move(finished));
    }
    void stopRecording(const std::string &link) override { note({"stopRecording", {}, link}); }
    void steerReplay(const std::string &link, const ReplayOrder &order) override
    {
        Call call{"steerReplay", {}, link};
        call.order = order;
        note(std::move(call));
    }
    void report(Severity severity, const QString &device, const QString &text) override
    {
        lines.push_back({time, severity, device, text});
        note({"report", {}, text.toStdString()});
        Q_EMIT noticed(lines.back());
    }
    const std::vector<Notice> &notices() const override { return lines; }

private:
    void note(Call call, Finished finished = {})
    {
        call.finished = std::move(finished);
        calls.push_back(std::move(call));
    }
    void noteNumber(const char *what, DeviceId device, double number, Finished finished)
    {
        Call call{what, device};
        call.number = number;
        note(std::move(call), std::move(finished));
    }
};

} // namespace mb::test
