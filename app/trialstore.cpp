// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trialstore.h"

#include "app/folders/account.h"
#include "transport/qtclock.h"
#include "transport/workerthreads.h"

#include <QDeadlineTimer>
#include <QSocketNotifier>
#include <QThread>

#include <limits>
#include <utility>

namespace mb {

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
            MB_TRY(auto opened, Database::open(m_store.m_path));
            m_database = std::move(opened);
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

} // namespace mb
