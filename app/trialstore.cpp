// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trialstore.h"

#include "async/event.h"

#include <QSysInfo>

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

TrialStore::TrialStore(std::string path, const Clock &clock, std::string person)
    : m_path(std::move(path))
    , m_clock(clock)
    , m_person(std::move(person))
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
    std::unique_ptr<Books> books;
    Error failure;
    std::unique_lock lock(m_mutex);
    while (true) {
        m_wake.wait(lock, [this] { return m_ends || !m_waiting.empty(); });
        if (m_waiting.empty())
            return;
        const Work work = std::move(m_waiting.front());
        m_waiting.pop_front();
        lock.unlock();
        if (!books) { // a disk that was full may have room by now
            auto opened = Database::open(m_path);
            if (opened) {
                database = std::move(*opened);
                books.reset(new Books{{*database, m_clock}, {*database, m_clock, m_person},
                    {*database, m_clock, QSysInfo::machineHostName().toStdString(), m_person}});
            } else {
                failure = opened.error();
            }
        }
        work(books ? Result<Books *>(books.get()) : Result<Books *>(fail(failure)));
        lock.lock();
    }
}

namespace {

template <class T> Task<T> ask(TrialStore &store, Mailbox &home, std::function<Task<T>(Books &)> question)
{
    struct Answer {
        Event come;
        std::optional<Result<T>> result;
    };
    const auto answer = std::make_shared<Answer>();
    store.post([to = &home, answer, question](const Result<Books *> &books) {
        auto result = std::make_shared<Result<T>>(books ? done(question(**books)) : Result<T>(fail(books.error())));
        to->post([answer, result] {
            answer->result = std::move(*result);
            answer->come.set();
        });
    });
    co_await answer->come.wait();
    co_return std::move(*answer->result);
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

Task<void> StoredJournal::settle(std::int64_t trial)
{
    return ask<void>(m_store, m_home, [trial](Books &books) { return books.trials.settle(trial); });
}

Task<void> StoredJournal::complete(std::int64_t number, tuning::Trial trial)
{
    return ask<void>(m_store, m_home,
        [number, trial = std::move(trial)](Books &books) { return books.trials.complete(number, trial); });
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
    return ask<service::Visit>(
        m_store, m_home, [visit = std::move(visit)](Books &books) { return books.service.open(visit); });
}

Task<service::Visit> StoredService::write(service::Visit visit)
{
    return ask<service::Visit>(
        m_store, m_home, [visit = std::move(visit)](Books &books) { return books.service.write(visit); });
}

Task<std::vector<service::Visit>> StoredService::visits(service::VisitFilter filter)
{
    return ask<std::vector<service::Visit>>(
        m_store, m_home, [filter = std::move(filter)](Books &books) { return books.service.visits(filter); });
}

Task<int> StoredService::number(service::NumberWish wish)
{
    return ask<int>(m_store, m_home, [wish = std::move(wish)](Books &books) { return books.service.number(wish); });
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
