// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trialstore.h"

#include "async/event.h"

#include <memory>
#include <optional>

namespace mb {
namespace {

/// A word of the book is done when it returns.
template <class T> Result<T> done(Task<T> task)
{
    task.start({});
    return std::move(task.result());
}

} // namespace

TrialStore::TrialStore(std::string path, const Clock &clock)
    : m_path(std::move(path))
    , m_clock(clock)
    , m_thread([this] { run(); })
{
}

TrialStore::~TrialStore()
{
    {
        const std::lock_guard lock(m_mutex);
        m_ends = true;
    }
    m_wake.notify_one();
    m_thread.join();
}

void TrialStore::post(Work work)
{
    {
        const std::lock_guard lock(m_mutex);
        m_waiting.push_back(std::move(work));
    }
    m_wake.notify_one();
}

void TrialStore::run()
{
    std::unique_ptr<Database> database;
    std::optional<TrialBook> book;
    Error failure;
    std::unique_lock lock(m_mutex);
    while (true) {
        m_wake.wait(lock, [this] { return m_ends || !m_waiting.empty(); });
        if (m_waiting.empty())
            return;
        const Work work = std::move(m_waiting.front());
        m_waiting.pop_front();
        lock.unlock();
        if (!book) { // a disk that was full may have room by now
            auto opened = Database::open(m_path);
            if (opened) {
                database = std::move(*opened);
                book.emplace(*database, m_clock);
            } else {
                failure = opened.error();
            }
        }
        work(book ? Result<TrialBook *>(&*book) : Result<TrialBook *>(fail(failure)));
        lock.lock();
    }
}

template <class T> Task<T> StoredJournal::ask(std::function<Task<T>(TrialBook &)> question)
{
    struct Answer {
        Event come;
        std::optional<Result<T>> result;
    };
    const auto answer = std::make_shared<Answer>();
    m_store.post([home = &m_home, answer, question](const Result<TrialBook *> &book) {
        auto result = std::make_shared<Result<T>>(book ? done(question(**book)) : Result<T>(fail(book.error())));
        home->post([answer, result] {
            answer->result = std::move(*result);
            answer->come.set();
        });
    });
    co_await answer->come.wait();
    co_return std::move(*answer->result);
}

Task<std::int64_t> StoredJournal::begin(tuning::Trial trial)
{
    return ask<std::int64_t>([trial = std::move(trial)](TrialBook &book) { return book.begin(trial); });
}

Task<void> StoredJournal::owe(std::int64_t trial, std::string unit, std::vector<tuning::OwedValue> values)
{
    return ask<void>([trial, unit = std::move(unit), values = std::move(values)](
                         TrialBook &book) { return book.owe(trial, unit, values); });
}

Task<void> StoredJournal::settle(std::int64_t trial)
{
    return ask<void>([trial](TrialBook &book) { return book.settle(trial); });
}

Task<void> StoredJournal::complete(std::int64_t number, tuning::Trial trial)
{
    return ask<void>([number, trial = std::move(trial)](TrialBook &book) { return book.complete(number, trial); });
}

Task<void> StoredJournal::keepTuning(tuning::TuneReport report)
{
    return ask<void>([report = std::move(report)](TrialBook &book) { return book.keepTuning(report); });
}

Task<std::vector<tuning::OwedGains>> StoredJournal::owedTo(std::string unit)
{
    return ask<std::vector<tuning::OwedGains>>([unit = std::move(unit)](TrialBook &book) { return book.owedTo(unit); });
}

} // namespace mb
