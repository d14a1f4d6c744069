// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/awaitedports.h"
#include "app/provisionalchanges.h"
#include "async/scope.h"
#include "model/parametertransfer.h"
#include "model/snapshot.h"
#include "model/trafficrecorder.h"
#include "model/transcript.h"
#include "model/unknownframes.h"
#include "settings/settingslog.h"
#include "transport/linkcatalog.h"
#include "tuning/autotune.h"
#include "tuning/frequencyresponse.h"
#include "widgets/orders/reply.h"

#include <functional>
#include <list>
#include <map>
#include <memory>
#include <set>
#include <string>

namespace mb {

/// The engine thread's half of the door: the session, its operations and the scanning that goes on by itself. Knows no Qt
/// and no thread, so that tests drive it on a virtual clock.
class EngineCore {
public:
    using Finished = std::function<void(Result<void>)>;

    /// `opensByItself`: also opens CAN interfaces that are up, as they come (product.md, "Link addresses").
    /// `guard` watches over motors without a watchdog, and outlives this.
    EngineCore(Clock &clock, std::span<const Family *const> families, bool opensByItself, MotionGuard *guard = nullptr);
    EngineCore(const EngineCore &) = delete;
    EngineCore &operator=(const EngineCore &) = delete;
    ~EngineCore();

    [[nodiscard]] Session &session() { return m_session; }
    /// From now on what may block is done there. Outlives this.
    void setBackground(Background *background);
    [[nodiscard]] Snapshot snapshot();
    /// Something that a snapshot shows has changed since the last one.
    [[nodiscard]] Listeners<> &changed() { return m_changed; }
    /// Lines for the log: severity, device, English text.
    [[nodiscard]] Listeners<Severity, const std::string &, const std::string &> &noticed() { return m_noticed; }

    /// Does what was ordered, and sees that it is answered (widgets/orders).
    void carryOut(const Order &order, const Reply &reply);

    /// A serial port that is not plugged in is opened once it is; until then this has failed. One that does not open fails after
    /// Link::openLimit; nothing waits for it meanwhile.
    void openLink(const LinkAddress &address, const Finished &finished);
    void closeLink(const std::string &address);
    void scanAll();
    void scanEverything(const std::string &address);
    /// What it has found stays.
    void cancelScan(const std::string &address);
    /// What is there to be opened, whenever it may have changed: interfaces that are up are opened if that is wanted, lost
    /// links whose interface is back too; one that opened by itself, and found nobody, goes with its interface.
    void takeListings(std::vector<LinkListing> listings);
    [[nodiscard]] const std::vector<LinkListing> &listings() const { return m_listings; }

    void readParameters(DeviceId id);
    void writeParameters(DeviceId id, std::vector<ParameterChange> changes, Finished finished);
    /// The same for values that were kept: a snapshot of what is there is taken first.
    void restoreParameters(DeviceId id, std::vector<ParameterChange> changes, Finished finished);
    /// From now on snapshots are kept and every write is in the history. The log outlives this.
    void setSettingsLog(settings::SettingsLog *log) { m_settingsLog = log; }
    /// Writes what was there before the last write that can be undone; or `again` what was undone last.
    void undoWrite(DeviceId id, bool again, Finished finished);
    /// What goes back unless somebody keeps it.
    [[nodiscard]] ProvisionalChanges &provisional() { return m_provisional; }
    void takeSnapshot(DeviceId id, const std::string &name, Finished finished);
    void storeParameters(DeviceId id, Finished finished);
    void rewriteSettings(DeviceId id, const Finished &finished);
    void experiment(DeviceId id, const std::string &key, const ExperimentOptions &options, const Finished &finished);
    /// From now on trials are kept, and what they change is written down first. The journal outlives this.
    void setJournal(tuning::ExperimentJournal *journal) { m_journal = journal; }
    using TrialMeasured = std::function<void(const tuning::Trial &)>;
    using TrialFinished = std::function<void(Result<tuning::Trial>)>;
    /// One experiment on one loop (tuning/experiment.h): an operation of the device. It needs renewMotion() all the time;
    /// stopMotion(), stopAll() and cancel() end its motion at once, and it puts back what it changed. `measured` after each hold.
    void runTrial(
        DeviceId id, const tuning::ExperimentPlan &plan, const TrialMeasured &measured, const TrialFinished &finished);
    using TuningFinished = std::function<void(Result<tuning::TuneReport>)>;
    /// A tuning by itself (tuning/autotune.h): an operation of the device, with everything of runTrial().
    void runTuning(DeviceId id, const tuning::TunePlan &plan, const TuningFinished &finished);
    using SweepFinished = std::function<void(Result<tuning::FrequencyResponse>)>;
    /// A frequency response (tuning/frequencyresponse.h): an operation like runTuning().
    void runSweep(
        DeviceId id, const tuning::SweepPlan &plan, const tuning::PlantModel &plant, const SweepFinished &finished);
    /// What earlier experiments owe to units that are here; it is looked for when a unit has told who it is.
    [[nodiscard]] const std::map<DeviceId, std::vector<tuning::OwedGains>> &owedGains() const { return m_owed; }
    /// Puts back what a trial owes, or owes it no longer. Operations of the device.
    void payGains(DeviceId id, std::int64_t trial, Finished finished);
    void dismissGains(DeviceId id, std::int64_t trial, Finished finished);
    void identify(DeviceId id, Finished finished);
    void rename(DeviceId id, const std::string &name, Finished finished);
    void renumber(DeviceId id, int address, Finished finished);
    void clearFaults(DeviceId id, Finished finished);
    void calibrate(DeviceId id, const std::string &key, std::optional<double> value, const Finished &finished);
    void setDialect(DeviceId id, const std::string &key, const Finished &finished);
    void setRate(DeviceId id, ChannelIndex channel, double hertz);

    void startMotion(
        DeviceId id, const SetPoint &setPoint, Duration lease, const Finished &finished, const Glide &glide = {});
    void updateMotion(DeviceId id, const SetPoint &setPoint, const Finished &finished, const Glide &glide = {});
    void renewMotion(DeviceId id);
    void stopMotion(DeviceId id);
    void releaseMoves(DeviceId id, const Finished &finished);
    void zeroPosition(DeviceId id, Finished finished);
    void stopAll(StopCause cause);
    /// The user has looked at the motors that were not seen to stand.
    void dismissStops();

    void update(DeviceId id, std::shared_ptr<const FirmwareImage> image, const UpdateOptions &options);
    /// From now on the log of each update is kept in this folder, one file an update.
    void keepTranscripts(std::string folder) { m_transcripts = std::move(folder); }
    void cancel(OperationId id);
    void sendFrame(const std::string &link, const CanFrame &frame, const Finished &finished);

    /// Writes what passes a CAN link to a file (TrafficRecorder), until stopRecording() or a full disk: a notice tells.
    void startRecording(const std::string &link, const std::string &path, const Finished &finished);
    void stopRecording(const std::string &link);
    /// Orders for a `replay:` link. A new position ends what its devices were doing.
    void steerReplay(const std::string &link, const ReplayOrder &order);

private:
    struct Running {
        OperationId id;
        DeviceId device;
        std::unique_ptr<Operation> operation;
        std::optional<UpdateReport> update;
        std::uint64_t shown = 0;
        bool isExperiment = false;                            ///< STOP ends it, whatever it is doing
        std::shared_ptr<tuning::Interruption> interruption{}; ///< of a trial, which puts back what it changed
        bool yields = false; ///< it began by itself and is done again later: an order ends it
    };
    /// A link that is being opened, and who waits for it.
    struct Opening {
        std::vector<Finished> finished;
        std::unique_ptr<Scope> scope;
    };
    struct Presence {
        std::string name;
        bool heard = false; ///< it answered since it was found, or found again
        bool lost = false;  ///< and was told to have fallen silent
    };
    struct Watched {
        bool scanning = false;
        std::string step; ///< of the scan
        int done = 0;
        int total = 0;
        bool byItself = false; ///< nobody asked for it
        bool wasLost = false;  ///< and its return was not told yet
        bool played = false;   ///< a recording, let go for the first time
        std::shared_ptr<TrafficLog> traffic;
        std::unique_ptr<TrafficRecorder> recorder;
        Subscription recorderChanged;
        bool toldOfRecording = false;
        std::unique_ptr<UnknownFrames> unknown;
        Subscription tap;
        Subscription state;
        std::unique_ptr<Scope> scan; ///< last: its task uses everything above
    };

    /// Starts a job that has the device for itself; refuses when another one has it, and yields nullptr. The maker runs at
    /// once.
    template <class T>
    Running *begin(DeviceId id, const char *title, const std::function<Task<T>(Device &, Progress &)> &make,
        std::function<void(Running &, Result<T>)> finished, const Finished &refused);
    Running *beginSimple(
        DeviceId id, const char *title, const std::function<Task<void>(Device &, Progress &)> &make, Finished finished);
    void watch(Link &link);
    void keepTraffic(Link &link);
    [[nodiscard]] Link *linkUnder(const std::string &address) const;
    void recorderChanged(Link &link);
    void dismissWork(DeviceId id, const Error &error);
    void forgetWork(const Link &link);
    void playWhenKnown(Link &link);
    void scan(Link &link, ScanExtent extent = ScanExtent::Quick);
    void endScan(Watched &watched);
    void scanned(Link &link, const Result<std::vector<Device *>> &devices);
    void look();
    void callTheRoll();
    void interruptTrials(std::optional<DeviceId> id);
    [[nodiscard]] tuning::ExperimentSurroundings surroundings(Progress &progress, tuning::Interruption &interruption);
    void experimentEnded(Running &running);
    /// What is told of an experiment that has ended.
    struct Notable {
        Severity severity;
        std::string text;
    };
    template <class T>
    using MovingStory = std::function<Task<T>(Device &, SetPointStream &, tuning::ExperimentSurroundings)>;
    template <class T>
    void runMoving(DeviceId id, const char *title, const MovingStory<T> &story,
        const std::function<Notable(const T &)> &judge, const std::function<void(Result<T>)> &finished);
    void write(DeviceId id, std::vector<ParameterChange> changes, settings::Purpose purpose, Finished finished);
    [[nodiscard]] Task<void> keptBefore(Device &device, settings::Occasion occasion, Progress &progress);
    void meetUnits();
    void met(DeviceId id, const Running &running, const Result<settings::ParameterSnapshot> &taken);
    void makeWay(DeviceId id);
    void wishAgain(DeviceId id);
    void lookAgain(DeviceId id);
    void lookForOwed();
    void compareOwed(DeviceId id, const std::string &unit);
    void endOwed(DeviceId id, std::int64_t trial);
    void refreshRestarted();
    void openByItself();
    void reopenLost();
    void welcomeReturned();
    void followStop(const Device &device);
    void guardianActed(const std::string &name, MotionGuard::Verdict verdict);
    [[nodiscard]] bool hasOperationOn(const Link &link) const;
    void dropVanished();
    void removeLink(Link &link);
    void openAwaited(const LinkAddress &address);
    void beginOpening(const std::string &address, Task<void> task);
    void endOpening(const std::string &address, const Result<void> &result);
    [[nodiscard]] Task<void> openAll(std::vector<LinkAddress> addresses);
    [[nodiscard]] Task<void> openReturned(LinkAddress address);
    void couldNotOpen(const LinkAddress &address, const Error &error);
    void opened(Link &link);
    [[nodiscard]] Result<void> mayRecord(const std::string &link) const;
    [[nodiscard]] Task<void> record(std::string link, std::string path);
    void endRecording(Watched &watched);
    [[nodiscard]] Task<std::unique_ptr<BackgroundFile>> makeFile(std::string path);
    void noteWrites(const Device &device, const std::vector<ParameterStore::Entry> &before,
        const std::vector<TransferOutcome> &outcomes);
    [[nodiscard]] const Device *updatedBeside(DeviceId id) const;
    void saveTranscript(const Running &running, const Device &device);
    [[nodiscard]] Task<std::string> keepTranscript(Transcript transcript);
    void probeSilent(Link &link);
    [[nodiscard]] static std::string proofOf(const std::vector<TransferOutcome> &outcomes);
    void streamChanged(DeviceId id);
    void prune();
    [[nodiscard]] ProvisionalChanges::Surroundings provisionalSurroundings();
    void touch() { m_changed.notify(); }
    void notice(Severity severity, const std::string &device, const std::string &text)
    {
        m_noticed.notify(severity, device, text);
    }
    [[nodiscard]] bool isQuiet() const;
    [[nodiscard]] bool hasOperation(DeviceId id) const;
    /// "DMC60C #5", with the link where another one has such a device, too.
    [[nodiscard]] std::string labelOf(const Device &device) const;

    static constexpr const char *updateTitle = "Update firmware";

    Clock &m_clock;
    bool m_opensByItself;
    Listeners<> m_changed;
    Listeners<Severity, const std::string &, const std::string &> m_noticed;
    Session m_session;
    std::map<const Link *, Watched> m_watched;
    std::map<DeviceId, Subscription> m_streams;
    std::vector<LinkListing> m_listings;
    std::map<std::string, Diagnosis> m_failed; ///< by address, until it opens or is closed
    std::set<std::string> m_closedByHand;      ///< not opened again by themselves
    AwaitedPorts m_awaited;
    std::map<DeviceId, Presence> m_roll; ///< of who was found
    std::string m_transcripts;           ///< folder; empty: none are kept
    std::list<Running> m_operations;
    std::uint32_t m_lastOperation = 0;
    Background *m_background = nullptr;
    std::map<std::string, Opening> m_openings; ///< by address
    Scope m_files;                             ///< that are being made or written
    Subscription m_sessionChanged;
    Subscription m_remarked;
    Subscription m_profileTrouble;
    Subscription m_memoryTrouble;
    Subscription m_stopChanged;
    Subscription m_guardianActed;
    std::map<std::pair<DeviceId, ChannelIndex>, double> m_rates; ///< asked for while the device was busy
    std::map<std::pair<DeviceId, ChannelIndex>, double>
        m_wished; ///< asked for last; a trial has rates of its own meanwhile
    Timer m_ratesAgain;
    Timer m_look;
    Timer m_returned;
    Instant m_lastScan{};
    std::set<DeviceId> m_mayTurn; ///< told so
    tuning::ExperimentJournal *m_journal = nullptr;
    tuning::DirectionBook m_directions;
    settings::SettingsLog *m_settingsLog = nullptr;
    std::map<DeviceId, std::string> m_met;       ///< units that a snapshot was taken of when they were found
    std::map<DeviceId, std::string> m_lookedFor; ///< units whose owed gains were asked for, and who they were
    std::map<DeviceId, Instant> m_lookAgain;     ///< when what was put back must be stored
    std::map<DeviceId, std::vector<tuning::OwedGains>> m_owed;
    ProvisionalChanges m_provisional;
    Scope m_asking{m_clock}; ///< last: what it asks uses everything above
};

} // namespace mb
