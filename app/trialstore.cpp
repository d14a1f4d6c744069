// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trialstore.h"

#include "app/folders/account.h"
#include "async/event.h"
#include "transport/qtclock.h"
#include "transport/workerthreads.h"

#include <QDeadlineTimer>
#include <QSocketNotifier>
#include <QThread>

#include <limits>
#include <utility>

namespace mb {
namespace {

/// A word of the book is done when it returns.
template <class T> Result<T> done(Task<T> task)
{
    task.start({});
    return std::move(task.result());
}

} // namespace

/// What lives in the store's thread, made and destroyed there.
class TrialStore::Worker {
public:
    explicit Worker(TrialStore &store)
        : m_store(store)
        , m_workers(store.m_orders)
        , m_place{hostName(), {}}
        , m_tasks(m_timers)
    {
    }
    /// A disk that was full may have room by now, so it is tried again with every order.
    [[nodiscard]] Result<Books *> books()
    {
        if (m_books)
            return m_books.get();
        if (!m_database) {
            auto opened = Database::open(m_store.m_path);
            if (!opened)
                return fail(opened.error());
            m_database = std::move(*opened);
        }
        m_books.reset(new Books{{*m_database, m_store.m_clock}, {*m_database, m_store.m_clock, m_store.m_person},
            {*m_database, m_store.m_clock, m_place.station, m_store.m_person}, nullptr});
        if (m_place.server) {
            m_books->shared = std::make_unique<SharedJournal>(m_books->service, *m_place.server, m_timers, &m_workers);
            m_changed = m_books->shared->changed().add([this] { tell(); });
        }
        tell();
        return m_books.get();
    }
    void keepJournal(JournalPlace place)
    {
        m_tasks.clear();
        m_changed = {};
        m_books.reset();
        m_place = std::move(place);
        (void)books(); // what waits for the server is delivered at once
    }
    void followJournal(std::function<void(int, const Message &)> told) { m_told = std::move(told); }
    /// Words of the journal that are waited for.
    [[nodiscard]] Scope &tasks() { return m_tasks; }

private:
    void tell()
    {
        if (!m_told)
            return;
        const SharedJournal *shared = m_books->shared.get();
        m_told(shared ? shared->waiting() : 0, shared ? shared->trouble().detail : Message());
    }

    TrialStore &m_store;
    QtClock m_timers;
    WorkerThreads m_workers;
    JournalPlace m_place;
    std::unique_ptr<Database> m_database;
    std::unique_ptr<Books> m_books;
    std::function<void(int, const Message &)> m_told;
    Subscription m_changed;
    Scope m_tasks; ///< last: they use all the others
};

class TrialStore::Loop final : public QThread {
public:
    explicit Loop(TrialStore &store)
        : m_store(store)
    {
    }

private:
    void run() override
    {
        Worker worker(m_store);
        m_store.m_worker = &worker;
        QSocketNotifier arrivals(m_store.m_orders.descriptor(), QSocketNotifier::Read);
        connect(&arrivals, &QSocketNotifier::activated, &arrivals, [this] { m_store.m_orders.drain(); });
        exec();
        m_store.m_orders.close();
        m_store.m_worker = nullptr;
    }

    TrialStore &m_store;
};

TrialStore::TrialStore(std::string path, const Clock &clock, std::string person)
    : m_path(std::move(path))
    , m_clock(clock)
    , m_person(std::move(person))
    , m_loop(std::make_unique<Loop>(*this))
{
    m_loop->setObjectName(QStringLiteral("store"));
    m_loop->start();
}

TrialStore::~TrialStore()
{
    constexpr auto forEver = std::chrono::milliseconds(std::numeric_limits<int>::max());
    while (!end(forEver)) { }
}

bool TrialStore::end(std::chrono::milliseconds limit)
{
    if (!std::exchange(m_ends, true))
        m_orders.post([] { QThread::currentThread()->exit(); }); // after all that waits
    return m_loop->wait(QDeadlineTimer(limit));
}

Scope &TrialStore::tasks()
{
    return m_worker->tasks();
}

void TrialStore::post(Work work)
{
    m_orders.post([this, work = std::move(work)] { work(m_worker->books()); });
}

void TrialStore::keepJournal(JournalPlace place)
{
    m_orders.post([this, place = std::move(place)]() mutable { m_worker->keepJournal(std::move(place)); });
}

void TrialStore::followJournal(std::function<void(int, const Message &)> told)
{
    m_orders.post([this, told = std::move(told)] { m_worker->followJournal(told); });
}

namespace {

/// An answer of the store's thread, awaited in the one that drains `home`.
template <class T> class Awaited {
public:
    explicit Awaited(Mailbox &home)
        : m_home(home)
    {
    }
    /// To be called in the store's thread, once.
    [[nodiscard]] std::function<void(Result<T>)> answer() const
    {
        return [to = &m_home, arrival = m_arrival](Result<T> told) {
            to->post([arrival, result = std::make_shared<Result<T>>(std::move(told))] {
                arrival->result = std::move(*result);
                arrival->come.set();
            });
        };
    }
    [[nodiscard]] Task<T> wait() const { return arrived(m_arrival); }

private:
    struct Arrival {
        Event come;
        std::optional<Result<T>> result;
    };
    static Task<T> arrived(std::shared_ptr<Arrival> arrival)
    {
        co_await arrival->come.wait();
        co_return std::move(*arrival->result);
    }

    Mailbox &m_home;
    std::shared_ptr<Arrival> m_arrival = std::make_shared<Arrival>();
};

template <class T> Task<T> ask(TrialStore &store, Mailbox &home, std::function<Task<T>(Books &)> question)
{
    const Awaited<T> awaited(home);
    store.post([answer = awaited.answer(), question = std::move(question)](const Result<Books *> &books) {
        answer(books ? done(question(**books)) : Result<T>(fail(books.error())));
    });
    return awaited.wait();
}

template <class T>
Task<T> askJournal(TrialStore &store, Mailbox &home, std::function<Task<T>(service::ServiceJournal &)> question)
{
    const Awaited<T> awaited(home);
    store.askJournal<T>(std::move(question), awaited.answer());
    return awaited.wait();
}

} // namespace

Task<std::int64_t> StoredJournal::begin(tuning::Trial trial)
{
    return ask<std::int64_t>(
        m_store, m_home, [trial = std::move(trial)](Books &books) { return books.trials.begin(trial); });
}

Task<void> StoredJournal::owe(std::int64_t trial, std::string unit, std::vector<tuning::OwedValue> values)
{
    return ask<void>(m_store, m_home, [trial, unit = std::move(unit), values = std::move(values)](Books &books) {
        return books.trials.owe(trial, unit, values);
    });
}

Task<void> StoredJournal::markPutBack(std::int64_t trial)
{
    return ask<void>(m_store, m_home, [trial](Books &books) { return books.trials.markPutBack(trial); });
}

Task<void> StoredJournal::release(std::string unit, std::vector<std::string> keys)
{
    return ask<void>(m_store, m_home,
        [unit = std::move(unit), keys = std::move(keys)](Books &books) { return books.trials.release(unit, keys); });
}

Task<void> StoredJournal::settle(std::int64_t trial)
{
    return ask<void>(m_store, m_home, [trial](Books &books) { return books.trials.settle(trial); });
}

Task<void> StoredJournal::complete(std::int64_t number, tuning::Trial trial)
{
    return ask<void>(m_store, m_home,
        [number, trial = std::move(trial)](Books &books) { return books.trials.complete(number, trial); });
}

void StoredJournal::abandon(std::int64_t number)
{
    m_store.post([number](const Result<Books *> &books) {
        if (books)
            (*books)->trials.abandon(number);
    });
}

Task<void> StoredJournal::keepTuning(tuning::TuneReport report)
{
    return ask<void>(
        m_store, m_home, [report = std::move(report)](Books &books) { return books.trials.keepTuning(report); });
}

Task<std::vector<tuning::OwedGains>> StoredJournal::owedTo(std::string unit)
{
    return ask<std::vector<tuning::OwedGains>>(
        m_store, m_home, [unit = std::move(unit)](Books &books) { return books.trials.owedTo(unit); });
}

Task<service::Visit> StoredService::open(service::Visit visit)
{
    return askJournal<service::Visit>(
        m_store, m_home, [visit = std::move(visit)](service::ServiceJournal &journal) { return journal.open(visit); });
}

Task<service::Visit> StoredService::write(service::Visit visit)
{
    return askJournal<service::Visit>(
        m_store, m_home, [visit = std::move(visit)](service::ServiceJournal &journal) { return journal.write(visit); });
}

Task<std::vector<service::Visit>> StoredService::visits(service::VisitFilter filter)
{
    return askJournal<std::vector<service::Visit>>(m_store, m_home,
        [filter = std::move(filter)](service::ServiceJournal &journal) { return journal.visits(filter); });
}

Task<std::optional<int>> StoredService::number(service::NumberWish wish)
{
    return askJournal<std::optional<int>>(
        m_store, m_home, [wish = std::move(wish)](service::ServiceJournal &journal) { return journal.number(wish); });
}

Task<settings::ParameterSnapshot> StoredSettings::keep(settings::ParameterSnapshot snapshot)
{
    return ask<settings::ParameterSnapshot>(
        m_store, m_home, [snapshot = std::move(snapshot)](Books &books) { return books.settings.keep(snapshot); });
}

Task<std::int64_t> StoredSettings::begin(settings::SettingsChange change)
{
    return ask<std::int64_t>(
        m_store, m_home, [change = std::move(change)](Books &books) { return books.settings.begin(change); });
}

Task<void> StoredSettings::complete(std::int64_t number, std::vector<settings::ValueChange> values)
{
    return ask<void>(m_store, m_home,
        [number, values = std::move(values)](Books &books) { return books.settings.complete(number, values); });
}

Task<std::vector<settings::SettingsChange>> StoredSettings::changesOf(std::string unit)
{
    return ask<std::vector<settings::SettingsChange>>(
        m_store, m_home, [unit = std::move(unit)](Books &books) { return books.settings.changesOf(unit); });
}

} // namespace mb
