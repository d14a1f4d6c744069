// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "async/mailbox.h"
#include "async/scope.h"
#include "storage/servicebook.h"
#include "storage/settingsbook.h"
#include "storage/sharedjournal.h"
#include "storage/trialbook.h"

#include <chrono>
#include <functional>
#include <memory>
#include <optional>

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
class TrialStore {
public:
    /// With the books, or why there are none. In the thread of the store.
    using Work = std::function<void(const Result<Books *> &)>;

    /// The clock gives the time of day, from any thread; `person` is the account that writes are kept under.
    TrialStore(std::string path, const Clock &clock, std::string person);
    TrialStore(const TrialStore &) = delete;
    TrialStore &operator=(const TrialStore &) = delete;
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

/// The journal as experiments see it, in the thread that drains `home`: each word waits for the store without blocking.
class StoredJournal final : public tuning::ExperimentJournal {
public:
    StoredJournal(TrialStore &store, Mailbox &home)
        : m_store(store)
        , m_home(home)
    {
    }
    [[nodiscard]] Task<std::int64_t> begin(tuning::Trial trial) override;
    [[nodiscard]] Task<void> owe(std::int64_t trial, std::string unit, std::vector<tuning::OwedValue> values) override;
    [[nodiscard]] Task<void> markPutBack(std::int64_t trial) override;
    [[nodiscard]] Task<void> settle(std::int64_t trial) override;
    [[nodiscard]] Task<void> release(std::string unit, std::vector<std::string> keys) override;
    [[nodiscard]] Task<void> complete(std::int64_t number, tuning::Trial trial) override;
    void abandon(std::int64_t number) override;
    [[nodiscard]] Task<void> keepTuning(tuning::TuneReport report) override;
    [[nodiscard]] Task<std::vector<tuning::OwedGains>> owedTo(std::string unit) override;

private:
    TrialStore &m_store;
    Mailbox &m_home;
};

/// The journal of service, in the same way.
class StoredService final : public service::ServiceJournal {
public:
    StoredService(TrialStore &store, Mailbox &home)
        : m_store(store)
        , m_home(home)
    {
    }
    [[nodiscard]] Task<service::Visit> open(service::Visit visit) override;
    [[nodiscard]] Task<service::Visit> write(service::Visit visit) override;
    [[nodiscard]] Task<std::vector<service::Visit>> visits(service::VisitFilter filter) override;
    [[nodiscard]] Task<std::optional<int>> number(service::NumberWish wish) override;

private:
    TrialStore &m_store;
    Mailbox &m_home;
};

/// The log of settings, in the same way.
class StoredSettings final : public settings::SettingsLog {
public:
    StoredSettings(TrialStore &store, Mailbox &home)
        : m_store(store)
        , m_home(home)
    {
    }
    [[nodiscard]] Task<settings::ParameterSnapshot> keep(settings::ParameterSnapshot snapshot) override;
    [[nodiscard]] Task<std::int64_t> begin(settings::SettingsChange change) override;
    [[nodiscard]] Task<void> complete(std::int64_t number, std::vector<settings::ValueChange> values) override;
    [[nodiscard]] Task<std::vector<settings::SettingsChange>> changesOf(std::string unit) override;

private:
    TrialStore &m_store;
    Mailbox &m_home;
};

} // namespace mb
