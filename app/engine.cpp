// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/engine.h"

#include "app/engine/linklister.h"
#include "app/engine/servicefeed.h"
#include "app/folders/account.h"
#include "app/folders/userfolders.h"
#include "app/guardian/client/guardianclient.h"
#include "app/settingsdesk.h"
#include "app/sleep/logindinhibitor.h"
#include "app/sleep/sleepguard.h"
#include "app/trialdesk.h"
#include "app/visitdesk.h"
#include "telemetry/chunkstore.h"
#include "transport/workerthreads.h"
#include "widgets/common/devicetext.h"

#include <QDeadlineTimer>
#include <QDir>
#include <QSocketNotifier>
#include <QThread>

#include <algorithm>
#include <limits>
#include <utility>

namespace mb {
namespace {

constexpr Duration snapshotPeriod = std::chrono::milliseconds(33);
constexpr std::chrono::milliseconds stopPatience{100}; ///< at the end, until motors are stopped past the engine
constexpr std::chrono::milliseconds storeLimit{2000};  ///< for what waits to be written
constexpr std::size_t keptNotices = 5000;
constexpr std::size_t historyBudget = 256U << 20U; ///< of samples in memory; twenty minutes of sixteen signals at 1 kHz

/// Beyond their budget the recordings go to the user's cache, which is on a disk.
std::shared_ptr<ChunkStore> historyStore()
{
    const std::string folder = samplesFolder();
    QDir().mkpath(QString::fromStdString(folder));
    return std::make_shared<ChunkStore>(folder, historyBudget);
}

} // namespace

/// What the engine writes to the user's file, and hears back.
struct Engine::Journals {
    explicit Journals(Engine &owner)
        : trials(owner.m_store, owner.m_toEngine)
        , settings(owner.m_store, owner.m_toEngine)
        , service(owner.m_store, owner.m_toEngine)
    {
    }
    StoredJournal trials;
    StoredSettings settings;
    StoredService service;
};

/// What lives in the engine thread, made and destroyed there.
class Engine::Worker {
public:
    Worker(Engine &owner, std::span<const Family *const> families, bool opensByItself)
        : engine(owner)
        , workers(owner.m_toEngine)
        , journals(owner)
        , core(clock, families, opensByItself, &guardian)
        , serviceFeed(
              core.service(), [this](const service::Visit &visit) { tellEnded(visit); },
              [this](const JournalPlace &place, const orders::KeepJournal &order) { keepJournal(place, order); })
        , sleepGuard(core.session(), clock, inhibitor, [this] { return core.service().mustStayAwake(); })
        , arrivals(owner.m_toEngine.descriptor(), QSocketNotifier::Read)
        , lister(clock, workers, core.links())
        , tick(clock)
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
        core.setJournal(&journals.trials);
        core.setSettingsLog(&journals.settings);
        core.service().setBooks({&journals.service, &journals.settings, &journals.trials}, hostName());
        core.session().keepHistoriesIn(store);
        core.session().setStopGate(&engine.m_stopLane.isPressed());
        changed = core.session().changed().add([this] { engine.m_stopLane.follow(core.session()); });
        looked = lister.looked().add([this] { tellStore(); });
        lister.look();
        publish();
    }
    void publish()
    {
        tick.startIn(snapshotPeriod, [this] { publish(); });
        engine.m_stopLane.follow(core.session()); // what was driven since
        if (engine.m_snapshotUnderWay.exchange(true))
            return;
        auto picture = std::make_shared<Picture>(
            Picture{core.changes(), core.links().listings(), core.owedGains(), serviceFeed.news()});
        engine.m_toWindow.post([to = &engine, picture] { to->takePicture(std::move(*picture)); });
    }

    void tellEnded(const service::Visit &visit)
    {
        engine.m_toWindow.post([to = &engine, visit] { Q_EMIT to->unitEnded(visit); });
    }

    void keepJournal(const JournalPlace &place, const orders::KeepJournal &order)
    {
        engine.m_store.keepJournal(place);
        engine.m_toWindow.post([to = &engine, station = place.station, order] { to->takeJournal(station, order); });
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
    Journals journals;
    EngineCore core;
    ServiceFeed serviceFeed;
    LogindInhibitor inhibitor;
    SleepGuard sleepGuard;
    QSocketNotifier arrivals;
    LinkLister lister;
    Timer tick;
    Subscription noticed;
    Subscription mayBeSuspended;
    Subscription looked;
    Subscription changed;
};

/// The engine thread: its body is the worker's event loop.
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
        Worker worker(m_engine, m_families, m_opensByItself);
        m_engine.m_worker = &worker;
        exec();
        m_engine.m_toEngine.close();
        m_engine.m_worker = nullptr;
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
    , m_visits(std::make_unique<VisitDesk>(m_store, m_toWindow))
    , m_thread(std::make_unique<Loop>(*this, families, opensByItself))
{
    connect(m_arrivals.get(), &QSocketNotifier::activated, this, [this] { m_toWindow.drain(); });
    m_journal.station = hostName();
    m_store.followJournal([this](int waiting, const Message &trouble) {
        m_toWindow.post([this, waiting, trouble] { takeDelivery(waiting, trouble); });
    });
    m_thread->setObjectName(QStringLiteral("engine"));
    m_thread->start(QThread::TimeCriticalPriority);
}

Engine::~Engine()
{
    constexpr auto forEver = std::chrono::milliseconds(std::numeric_limits<int>::max());
    while (!end(forEver)) { }
    m_toWindow.drain(); // orders that were not carried out any more are answered, too
    m_toWindow.close();
}

bool Engine::end(std::chrono::milliseconds limit)
{
    if (!std::exchange(m_ending.begun, true)) {
        m_stops.count(StopCause::User); // nothing that waits is to be begun any more, whatever it is
        m_toEngine.postUrgent([this] {
            m_worker->core.stopAll(StopCause::Program);
            m_ending.stopped = true;
        });
        m_toEngine.post([this] { m_worker->core.wrapUp([] { QThread::currentThread()->exit(); }); });
    }
    const QDeadlineTimer until(limit);
    if (!m_thread->wait(QDeadlineTimer(std::min(limit, stopPatience))) && !m_ending.stopped)
        m_stopLane.press(StopCause::Program);
    const bool ended = m_thread->wait(until);
    return m_store.end(std::max(storeLimit, std::chrono::milliseconds(until.remainingTime()))) && ended;
}

void Engine::post(std::function<void(EngineCore &)> work)
{
    m_toEngine.post([this, work = std::move(work)] { work(m_worker->core); });
}

/// Whatever becomes of it, its answer comes back through the window's mailbox.
void Engine::deliver(Order order, Reply::Finished finished)
{
    if (auto *trial = std::get_if<orders::RunTrial>(&order); trial && trial->measured)
        trial->measured = [this, measured = std::move(trial->measured)](
                              const tuning::Trial &sofar) { m_toWindow.post([measured, sofar] { measured(sofar); }); };
    Reply reply;
    if (finished)
        reply = Reply([this, finished = std::move(finished)](Result<Answer> answer) {
            m_toWindow.post([finished, answer = std::move(answer)] { finished(answer); });
        });
    post([this, order = std::move(order), reply = std::move(reply), given = m_stops.now()](EngineCore &core) {
        if (m_stops.takesBack(order, given))
            return reply.give(fail(Fault::Cancelled, say("a stop came before it was begun")));
        core.carryOut(order, reply);
    });
}

void Engine::takePicture(Picture picture)
{
    m_snapshot = merged(std::move(m_snapshot), std::move(picture.changes));
    m_listings = std::move(picture.listings);
    m_owedGains = std::move(picture.owedGains);
    m_snapshotUnderWay = false;
    Q_EMIT changed();
    if (!picture.service)
        return;
    m_service = std::move(*picture.service);
    Q_EMIT serviceChanged();
}

void Engine::takeJournal(const std::string &station, const orders::KeepJournal &order)
{
    m_journal.server = order.server;
    m_journal.station = station;
    Q_EMIT serviceChanged();
    Q_EMIT journalChosen(QString::fromStdString(order.server), QString::fromStdString(order.station));
}

void Engine::takeDelivery(int waiting, const Message &trouble)
{
    m_journal.waiting = waiting;
    m_journal.trouble = trouble;
    Q_EMIT serviceChanged();
}

void Engine::report(Severity severity, const QString &device, const QString &text)
{
    if (m_notices.size() >= keptNotices)
        m_notices.erase(m_notices.begin(), m_notices.begin() + static_cast<std::ptrdiff_t>(keptNotices / 10));
    m_notices.push_back({now(), severity, device, text});
    Q_EMIT noticed(m_notices.back());
}

/// Before every other order; past the engine thread where that does not come to it.
void Engine::stopAll(StopCause cause)
{
    m_stops.count(cause);
    if (cause == StopCause::User)
        m_stopLane.press(cause);
    m_toEngine.postUrgent([this, cause] {
        m_worker->core.stopAll(cause);
        if (cause == StopCause::User)
            m_stopLane.served();
    });
}

} // namespace mb
