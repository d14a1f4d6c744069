// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/engine.h"

#include "app/folders/account.h"
#include "app/folders/userfolders.h"
#include "app/guardian/client/guardianclient.h"
#include "app/settingsdesk.h"
#include "app/sleep/logindinhibitor.h"
#include "app/sleep/sleepguard.h"
#include "app/trialdesk.h"
#include "model/chunkstore.h"
#include "transport/linkwatch.h"
#include "transport/workerthreads.h"
#include "widgets/common/devicetext.h"

#include <QDir>
#include <QFile>
#include <QSocketNotifier>
#include <QStandardPaths>
#include <QThread>

namespace mb {
namespace {

constexpr Duration snapshotPeriod = std::chrono::milliseconds(33);
constexpr Duration listingPeriod = std::chrono::seconds(1);
constexpr std::size_t keptNotices = 5000;
constexpr std::size_t historyBudget = 256U << 20U; ///< of samples in memory; twenty minutes of sixteen signals at 1 kHz

/// Beyond their budget the recordings go to the user's cache, which is on a disk.
std::shared_ptr<ChunkStore> historyStore()
{
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::CacheLocation);
    QDir().mkpath(folder);
    return std::make_shared<ChunkStore>(folder.toStdString(), historyBudget);
}

} // namespace

/// What lives in the engine thread, made and destroyed there.
struct Engine::Room {
    Room(Engine &owner, std::span<const Family *const> families, bool opensByItself)
        : engine(owner)
        , workers(owner.m_toEngine)
        , journal(owner.m_store, owner.m_toEngine)
        , settingsLog(owner.m_store, owner.m_toEngine)
        , core(clock, families, opensByItself, &guardian)
        , sleepGuard(core.session(), clock, inhibitor)
        , arrivals(owner.m_toEngine.descriptor(), QSocketNotifier::Read)
        , watch(clock)
        , tick(clock)
        , list(clock)
    {
        QObject::connect(&arrivals, &QSocketNotifier::activated, &arrivals, [this] { engine.m_toEngine.drain(); });
        noticed = core.noticed().add([this](Severity severity, const std::string &device, const Message &text) {
            engine.m_toWindow.post([to = &engine, severity, device, text] {
                to->report(severity, QString::fromStdString(device), messageText(text));
            });
        });
        mayBeSuspended = inhibitor.troubled().add([this](const Message &text) {
            engine.m_toWindow.post([to = &engine, text] { to->report(Severity::Caution, {}, messageText(text)); });
        });
        core.setBackground(&workers);
        core.setJournal(&journal);
        core.setSettingsLog(&settingsLog);
        core.session().keepHistoriesIn(store);
        core.session().setStopGate(&engine.m_stopLane.isPressed());
        changed = core.session().changed().add([this] { engine.m_stopLane.follow(core.session()); });
        plugged = watch.changed().add([this] { look(); });
        look();
        publish();
    }
    void look()
    {
        list.startIn(listingPeriod, [this] { look(); });
        tellStore();
        if (std::exchange(isListing, true))
            return;
        const auto found = std::make_shared<std::vector<LinkListing>>();
        workers.run(
            "links", [found] { *found = listLinks(); },
            [this, found] {
                isListing = false;
                core.takeListings(std::move(*found));
            });
    }
    void publish()
    {
        tick.startIn(snapshotPeriod, [this] { publish(); });
        if (engine.m_snapshotUnderWay.exchange(true))
            return;
        auto picture = std::make_shared<Picture>(Picture{core.snapshot(), core.listings(), core.owedGains()});
        engine.m_toWindow.post([to = &engine, picture] { to->takePicture(std::move(*picture)); });
    }

    /// Samples that could not go to disk stay in memory; somebody should know before it is full.
    void tellStore()
    {
        const Message failure = store->failure();
        if (failure != toldFailure && !failure.empty())
            engine.m_toWindow.post(
                [to = &engine, failure] { to->report(Severity::Caution, {}, messageText(failure)); });
        toldFailure = failure;
    }

    Engine &engine;
    std::shared_ptr<ChunkStore> store = historyStore();
    Message toldFailure;
    QtClock clock;
    GuardianClient guardian;
    WorkerThreads workers;
    StoredJournal journal;
    StoredSettings settingsLog;
    EngineCore core;
    bool isListing = false;
    LogindInhibitor inhibitor;
    SleepGuard sleepGuard;
    QSocketNotifier arrivals;
    LinkWatch watch;
    Timer tick;
    Timer list;
    Subscription noticed;
    Subscription mayBeSuspended;
    Subscription plugged;
    Subscription changed;
};

/// The engine thread: its body is the room's event loop.
class Engine::Loop final : public QThread {
public:
    Loop(Engine &engine, std::span<const Family *const> families, bool opensByItself)
        : m_engine(engine)
        , m_families(families)
        , m_opensByItself(opensByItself)
    {
    }

private:
    void run() override
    {
        Room room(m_engine, m_families, m_opensByItself);
        m_engine.m_room = &room;
        exec();
        m_engine.m_toEngine.close();
        m_engine.m_room = nullptr;
    }

    Engine &m_engine;
    std::span<const Family *const> m_families;
    bool m_opensByItself;
};

Engine::Engine(std::span<const Family *const> families, bool opensByItself, QObject *parent)
    : Workbench(parent)
    , m_arrivals(std::make_unique<QSocketNotifier>(m_toWindow.descriptor(), QSocketNotifier::Read))
    , m_store(databaseFile(), m_clock, accountName())
    , m_notebook(std::make_unique<TrialDesk>(m_store, m_toWindow))
    , m_archive(std::make_unique<SettingsDesk>(m_store, m_toWindow))
    , m_thread(std::make_unique<Loop>(*this, families, opensByItself))
{
    connect(m_arrivals.get(), &QSocketNotifier::activated, this, [this] { m_toWindow.drain(); });
    m_thread->setObjectName(QStringLiteral("engine"));
    m_thread->start(QThread::TimeCriticalPriority);
}

Engine::~Engine()
{
    m_toEngine.post([this] {
        m_room->core.stopAll(StopCause::Program);
        QThread::currentThread()->exit();
    });
    m_thread->wait();
    m_toWindow.close();
}

void Engine::post(std::function<void(EngineCore &)> work)
{
    m_toEngine.post([this, work = std::move(work)] { work(m_room->core); });
}

EngineCore::Finished Engine::comeBack(Finished finished)
{
    if (!finished)
        return {};
    return [this, finished = std::move(finished)](
               Result<void> result) { m_toWindow.post([finished, result] { finished(result); }); };
}

void Engine::takePicture(Picture picture)
{
    m_snapshot = std::move(picture.snapshot);
    m_listings = std::move(picture.listings);
    m_owedGains = std::move(picture.owedGains);
    m_snapshotUnderWay = false;
    Q_EMIT changed();
}

void Engine::report(Severity severity, const QString &device, const QString &text)
{
    if (m_notices.size() >= keptNotices)
        m_notices.erase(m_notices.begin(), m_notices.begin() + static_cast<std::ptrdiff_t>(keptNotices / 10));
    m_notices.push_back({now(), severity, device, text});
    Q_EMIT noticed(m_notices.back());
}

void Engine::openLink(const LinkAddress &address, Finished finished)
{
    post([address, back = comeBack(std::move(finished))](EngineCore &core) { core.openLink(address, back); });
}

void Engine::closeLink(const std::string &address)
{
    post([address](EngineCore &core) { core.closeLink(address); });
}

void Engine::scan()
{
    post([](EngineCore &core) { core.scanAll(); });
}

void Engine::scanEverything(const std::string &link)
{
    post([link](EngineCore &core) { core.scanEverything(link); });
}

void Engine::cancelScan(const std::string &link)
{
    post([link](EngineCore &core) { core.cancelScan(link); });
}

void Engine::readParameters(DeviceId device)
{
    post([device](EngineCore &core) { core.readParameters(device); });
}

void Engine::writeParameters(DeviceId device, std::vector<ParameterChange> changes, Finished finished)
{
    post([device, changes = std::move(changes), back = comeBack(std::move(finished))](
             EngineCore &core) { core.writeParameters(device, changes, back); });
}

void Engine::restoreParameters(DeviceId device, std::vector<ParameterChange> changes, Finished finished)
{
    post([device, changes = std::move(changes), back = comeBack(std::move(finished))](
             EngineCore &core) { core.restoreParameters(device, changes, back); });
}

void Engine::undoWrite(DeviceId device, bool again, Finished finished)
{
    post([device, again, back = comeBack(std::move(finished))](
             EngineCore &core) { core.undoWrite(device, again, back); });
}

void Engine::takeSnapshot(DeviceId device, const QString &name, Finished finished)
{
    post([device, name = name.toStdString(), back = comeBack(std::move(finished))](
             EngineCore &core) { core.takeSnapshot(device, name, back); });
}

SettingsArchive &Engine::settings()
{
    return *m_archive;
}

void Engine::storeParameters(DeviceId device, Finished finished)
{
    post([device, back = comeBack(std::move(finished))](EngineCore &core) { core.storeParameters(device, back); });
}

void Engine::rewriteSettings(DeviceId device, Finished finished)
{
    post([device, back = comeBack(std::move(finished))](EngineCore &core) { core.rewriteSettings(device, back); });
}

void Engine::experiment(DeviceId device, const std::string &key, const ExperimentOptions &options, Finished finished)
{
    post([device, key, options, back = comeBack(std::move(finished))](
             EngineCore &core) { core.experiment(device, key, options, back); });
}

void Engine::runTrial(
    DeviceId device, const tuning::ExperimentPlan &plan, TrialMeasured measured, TrialFinished finished)
{
    const EngineCore::TrialMeasured told = [this, measured = std::move(measured)](const tuning::Trial &trial) {
        m_toWindow.post([measured, trial] { measured(trial); });
    };
    const EngineCore::TrialFinished back = [this, finished = std::move(finished)](Result<tuning::Trial> trial) {
        m_toWindow.post([finished, trial = std::move(trial)] { finished(trial); });
    };
    post([device, plan, told, back](EngineCore &core) { core.runTrial(device, plan, told, back); });
}

void Engine::runTuning(DeviceId device, const tuning::TunePlan &plan, TuningFinished finished)
{
    const EngineCore::TuningFinished back = [this, finished = std::move(finished)](Result<tuning::TuneReport> report) {
        m_toWindow.post([finished, report = std::move(report)] { finished(report); });
    };
    post([device, plan, back](EngineCore &core) { core.runTuning(device, plan, back); });
}

void Engine::runSweep(
    DeviceId device, const tuning::SweepPlan &plan, const tuning::PlantModel &plant, SweepFinished finished)
{
    const EngineCore::SweepFinished back
        = [this, finished = std::move(finished)](Result<tuning::FrequencyResponse> response) {
              m_toWindow.post([finished, response = std::move(response)] { finished(response); });
          };
    post([device, plan, plant, back](EngineCore &core) { core.runSweep(device, plan, plant, back); });
}

TrialNotebook &Engine::trials()
{
    return *m_notebook;
}

void Engine::payGains(DeviceId device, std::int64_t trial, Finished finished)
{
    post([device, trial, back = comeBack(std::move(finished))](
             EngineCore &core) { core.payGains(device, trial, back); });
}

void Engine::dismissGains(DeviceId device, std::int64_t trial, Finished finished)
{
    post([device, trial, back = comeBack(std::move(finished))](
             EngineCore &core) { core.dismissGains(device, trial, back); });
}

void Engine::identify(DeviceId device, Finished finished)
{
    post([device, back = comeBack(std::move(finished))](EngineCore &core) { core.identify(device, back); });
}

void Engine::rename(DeviceId device, const QString &name, Finished finished)
{
    const QByteArray latin1 = name.toLatin1();
    post([device, text = latin1.toStdString(), back = comeBack(std::move(finished))](
             EngineCore &core) { core.rename(device, text, back); });
}

void Engine::renumber(DeviceId device, int address, Finished finished)
{
    post([device, address, back = comeBack(std::move(finished))](
             EngineCore &core) { core.renumber(device, address, back); });
}

void Engine::clearFaults(DeviceId device, Finished finished)
{
    post([device, back = comeBack(std::move(finished))](EngineCore &core) { core.clearFaults(device, back); });
}

void Engine::calibrate(DeviceId device, const std::string &key, std::optional<double> value, Finished finished)
{
    post([device, key, value, back = comeBack(std::move(finished))](
             EngineCore &core) { core.calibrate(device, key, value, back); });
}

void Engine::setDialect(DeviceId device, const std::string &key, Finished finished)
{
    post([device, key, back = comeBack(std::move(finished))](EngineCore &core) { core.setDialect(device, key, back); });
}

void Engine::setRate(DeviceId device, ChannelIndex channel, double hertz)
{
    post([device, channel, hertz](EngineCore &core) { core.setRate(device, channel, hertz); });
}

void Engine::startMotion(DeviceId device, const SetPoint &setPoint, std::chrono::milliseconds lease, Finished finished)
{
    post([device, setPoint, lease, back = comeBack(std::move(finished))](
             EngineCore &core) { core.startMotion(device, setPoint, lease, back); });
}

void Engine::updateMotion(DeviceId device, const SetPoint &setPoint, Finished finished)
{
    post([device, setPoint, back = comeBack(std::move(finished))](
             EngineCore &core) { core.updateMotion(device, setPoint, back); });
}

void Engine::renewMotion(DeviceId device)
{
    post([device](EngineCore &core) { core.renewMotion(device); });
}

void Engine::stopMotion(DeviceId device)
{
    post([device](EngineCore &core) { core.stopMotion(device); });
}

void Engine::releaseMoves(DeviceId device, Finished finished)
{
    post([device, back = comeBack(std::move(finished))](EngineCore &core) { core.releaseMoves(device, back); });
}

void Engine::zeroPosition(DeviceId device, Finished finished)
{
    post([device, back = comeBack(std::move(finished))](EngineCore &core) { core.zeroPosition(device, back); });
}

/// Before every other order; past the engine thread where that does not come to it.
void Engine::stopAll(StopCause cause)
{
    if (cause == StopCause::User)
        m_stopLane.press();
    m_toEngine.postUrgent([this, cause] {
        m_room->core.stopAll(cause);
        if (cause == StopCause::User)
            m_stopLane.served();
    });
}

void Engine::dismissStops()
{
    post([](EngineCore &core) { core.dismissStops(); });
}

void Engine::update(DeviceId device, std::shared_ptr<const FirmwareImage> image, UpdateOptions options)
{
    post([device, image = std::move(image), options = std::move(options)](
             EngineCore &core) { core.update(device, image, options); });
}

void Engine::cancel(OperationId operation)
{
    post([operation](EngineCore &core) { core.cancel(operation); });
}

void Engine::sendFrame(const std::string &link, const CanFrame &frame, Finished finished)
{
    post([link, frame, back = comeBack(std::move(finished))](EngineCore &core) { core.sendFrame(link, frame, back); });
}

void Engine::startRecording(const std::string &link, const QString &path, Finished finished)
{
    post([link, file = QFile::encodeName(path).toStdString(), back = comeBack(std::move(finished))](
             EngineCore &core) { core.startRecording(link, file, back); });
}

void Engine::stopRecording(const std::string &link)
{
    post([link](EngineCore &core) { core.stopRecording(link); });
}

void Engine::steerReplay(const std::string &link, const ReplayOrder &order)
{
    post([link, order](EngineCore &core) { core.steerReplay(link, order); });
}

} // namespace mb
