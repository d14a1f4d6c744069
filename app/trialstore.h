// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "async/event.h"
#include "async/mailbox.h"
#include "async/noncopyable.h"
#include "async/scope.h"
#include "storage/servicebook.h"
#include "storage/settingsbook.h"
#include "storage/sharedjournal.h"
#include "storage/trialbook.h"

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

namespace mb {

/// What the user's file keeps: trials and tunings, snapshots and writes, what was done to which unit.
struct Books {
    TrialBook trials;
    SettingsBook settings;
    ServiceBook service;
    std::unique_ptr<SharedJournal> shared; ///< nullptr: the journal is this computer's alone

    [[nodiscard]] service::ServiceJournal &journal()
    {
        return shared ? static_cast<service::ServiceJournal &>(*shared) : service;
    }
};

/// The user's file in a thread of its own, so that neither disk nor server ever holds up engine or window. The file is opened
/// with the first order. Orders are done one after the other, those that wait at the end too; what the journal's server has not
/// got then, it gets the next time.
class TrialStore : NonCopyable {
public:
    /// With the books, or why there are none. In the thread of the store.
    using Work = std::function<void(const Result<Books *> &)>;

    /// The clock gives the time of day, from any thread; `person` is the account that writes are kept under.
    TrialStore(std::string path, const Clock &clock, std::string person);
    /// Waits until all is done.
    ~TrialStore();
    /// The same with a limit. False: a disk hangs, and this may not be destroyed. Again later where more is to be waited.
    [[nodiscard]] bool end(std::chrono::milliseconds limit);

    /// Any thread.
    void post(Work work);
    /// From now on the journal is there; where something waits for its server, that is delivered. Any thread.
    void keepJournal(JournalPlace place);
    /// `told` hears in the thread of the store how many entries the server has not got, and why; empty: it took them. Before
    /// keepJournal().
    void followJournal(std::function<void(int waiting, const Message &trouble)> told);
    /// Asks the journal; `answered` is called in the thread of the store, once.
    template <class T>
    void askJournal(std::function<Task<T>(service::ServiceJournal &)> question, std::function<void(Result<T>)> answered)
    {
        post([this, question = std::move(question), answered = std::move(answered)](const Result<Books *> &books) {
            if (!books)
                return answered(fail(books.error()));
            tasks().spawn<T>(question((*books)->journal()), answered);
        });
    }
    /// Answers a question of the books in the thread that drains `home`, or says why there are none. `answered` may be empty.
    template <class T>
    void ask(Mailbox &home, std::function<Result<T>(Books &)> question, std::function<void(Result<T>)> answered)
    {
        post([&home, question = std::move(question), answered = std::move(answered)](const Result<Books *> &books) {
            auto result = std::make_shared<Result<T>>(books ? question(**books) : Result<T>(fail(books.error())));
            home.post([answered, result] {
                if (answered)
                    answered(std::move(*result));
            });
        });
    }

private:
    class Worker;
    class Loop;

    [[nodiscard]] Scope &tasks();

    std::string m_path;
    const Clock &m_clock;
    std::string m_person;
    Mailbox m_orders;
    bool m_ends = false;          ///< it was told to
    Worker *m_worker = nullptr;   ///< the store's thread only
    std::unique_ptr<Loop> m_loop; ///< last: its thread uses all the others
};

/// Books as they are seen in the thread that drains `home`: each word is said in the thread of the store, and its answer is waited for
/// without blocking.
class StoredBooks {
public:
    StoredBooks(TrialStore &store, Mailbox &home)
        : m_store(store)
        , m_home(home)
    {
    }

protected:
    /// Of a book that has done a word when it returns: trials or settings.
    template <class T, class Book, class... Wanted, class... Given>
    [[nodiscard]] Task<T> ask(Task<T> (Book::*word)(Wanted...), Given... given) const
    {
        const Awaited<T> awaited(m_home);
        m_store.post([answer = awaited.answer(), word, ... given = std::move(given)](const Result<Books *> &books) {
            if (!books)
                return answer(fail(books.error()));
            Task<T> task = (in<Book>(**books).*word)(given...);
            task.start({});
            answer(std::move(task.result()));
        });
        return awaited.wait();
    }
    /// Of the journal, which may wait for its server.
    template <class T, class... Wanted, class... Given>
    [[nodiscard]] Task<T> askJournal(Task<T> (service::ServiceJournal::*word)(Wanted...), Given... given) const
    {
        const Awaited<T> awaited(m_home);
        m_store.askJournal<T>([word, ... given = std::move(given)](
                                  service::ServiceJournal &journal) { return (journal.*word)(given...); },
            awaited.answer());
        return awaited.wait();
    }
    void post(TrialStore::Work work) const { m_store.post(std::move(work)); }

private:
    template <class Book> static Book &in(Books &books)
    {
        if constexpr (std::is_same_v<Book, TrialBook>)
            return books.trials;
        else
            return books.settings;
    }
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

    TrialStore &m_store;
    Mailbox &m_home;
};

/// The journal of experiments.
class StoredJournal final : public tuning::ExperimentJournal, private StoredBooks {
public:
    using StoredBooks::StoredBooks;
    Task<std::int64_t> begin(tuning::Trial trial) override { return ask(&TrialBook::begin, std::move(trial)); }
    Task<void> owe(std::int64_t trial, std::string unit, std::vector<tuning::OwedValue> values) override
    {
        return ask(&TrialBook::owe, trial, std::move(unit), std::move(values));
    }
    Task<void> markPutBack(std::int64_t trial) override { return ask(&TrialBook::markPutBack, trial); }
    Task<void> settle(std::int64_t trial) override { return ask(&TrialBook::settle, trial); }
    Task<void> release(std::string unit, std::vector<std::string> keys) override
    {
        return ask(&TrialBook::release, std::move(unit), std::move(keys));
    }
    Task<void> complete(std::int64_t number, tuning::Trial trial) override
    {
        return ask(&TrialBook::complete, number, std::move(trial));
    }
    void abandon(std::int64_t number) override
    {
        post([number](const Result<Books *> &books) {
            if (books)
                (*books)->trials.abandon(number);
        });
    }
    Task<void> keepTuning(tuning::TuneReport report) override { return ask(&TrialBook::keepTuning, std::move(report)); }
    Task<std::vector<tuning::OwedGains>> owedTo(std::string unit) override
    {
        return ask(&TrialBook::owedTo, std::move(unit));
    }
};

/// The journal of service.
class StoredService final : public service::ServiceJournal, private StoredBooks {
public:
    using StoredBooks::StoredBooks;
    Task<service::Visit> open(service::Visit visit) override
    {
        return askJournal(&ServiceJournal::open, std::move(visit));
    }
    Task<service::Visit> write(service::Visit visit) override
    {
        return askJournal(&ServiceJournal::write, std::move(visit));
    }
    Task<std::vector<service::Visit>> visits(service::VisitFilter filter) override
    {
        return askJournal(&ServiceJournal::visits, std::move(filter));
    }
    Task<std::optional<int>> number(service::NumberWish wish) override
    {
        return askJournal(&ServiceJournal::number, std::move(wish));
    }
};

/// The log of settings.
class StoredSettings final : public settings::SettingsLog, private StoredBooks {
public:
    using StoredBooks::StoredBooks;
    Task<settings::ParameterSnapshot> keep(settings::ParameterSnapshot snapshot) override
    {
        return ask(&SettingsBook::keep, std::move(snapshot));
    }
    Task<std::int64_t> begin(settings::SettingsChange change) override
    {
        return ask(&SettingsBook::begin, std::move(change));
    }
    Task<void> complete(std::int64_t number, std::vector<settings::ValueChange> values) override
    {
        return ask(&SettingsBook::complete, number, std::move(values));
    }
    Task<std::vector<settings::SettingsChange>> changesOf(std::string unit) override
    {
        return ask(&SettingsBook::changesOf, std::move(unit));
    }
    Task<void> moved(std::string from, std::string to) override
    {
        return ask(&SettingsBook::moved, std::move(from), std::move(to));
    }
};

} // namespace mb
