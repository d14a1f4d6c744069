// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/scope.h"
#include "model/operation.h"
#include "model/session.h"
#include "service/queuerow.h"
#include "service/unitservice.h"

#include <list>

namespace mb::service {

struct QueueOptions {
    std::string station;
    /// Nothing: the units that one scan finds. A number: units as they are put on, until so many have ended (0: until finish()).
    std::optional<int> units;
    std::string run;         ///< of an earlier queue that this one goes on with; empty: a new one
    bool onlyChosen = false; ///< what is found waits as Skipped until it is chosen with retry()
};

/// How many units ended how, those of the run that was resumed included.
struct QueueCounts {
    int passed = 0;
    int failed = 0;
    int refused = 0;
    [[nodiscard]] int ended() const { return passed + failed + refused; }
};

/// What a queue shares with who made it, who outlives it.
struct QueueSurroundings {
    ServiceJournal &journal;
    settings::SettingsLog *settings = nullptr;
    tuning::ExperimentJournal *trials = nullptr;
    MotionPermit *permit = nullptr;
    std::function<void(const std::string &)> note; ///< a line for people
};

/// A recipe over many units: one at a time on a bus, several buses side by side (one after the other where the firmware takes
/// another way in, of which there is one). Units that may not be touched (two with one
/// number, wrong hardware) are refused in their row, the others go on. One that has just ended does not start again until it
/// was gone for 2 s. Thread of the session. Everything can be called at any time, but not from inside finished().
class ServiceQueue {
public:
    ServiceQueue(Clock &clock, RecipeMatter matter, QueueSurroundings surroundings, QueueOptions options);
    ServiceQueue(const ServiceQueue &) = delete;
    ServiceQueue &operator=(const ServiceQueue &) = delete;
    /// What runs is cut off: motors stop, the journal has its open visits, and resumes them.
    ~ServiceQueue();

    /// Before start(). The session outlives the queue, the link is open; each bus has its own.
    void addBus(Session &session, Link &link);
    void start();

    /// In the order in which units were found.
    [[nodiscard]] std::vector<QueueRow> rows() const;
    [[nodiscard]] QueueCounts counts() const { return m_counts; }
    [[nodiscard]] const RecipeMatter &matter() const { return m_matter; }
    /// Name of this start, to be resumed; known once a unit has begun or start() has found it.
    [[nodiscard]] const std::string &run() const { return m_options.run; }
    [[nodiscard]] bool isRunning() const { return m_lanes > 0; }
    /// The steps of a unit on a real link are not over: the computer must not sleep between them.
    [[nodiscard]] bool mustStayAwake() const;
    /// The next unit is not begun; what runs goes on.
    [[nodiscard]] bool isPausing() const { return m_isPausing; }
    /// Nothing runs, because of pause().
    [[nodiscard]] bool isPaused() const;
    /// What ended the queue before its time: numbers that are used up, a lost link, a full disk. Empty detail: nothing did.
    [[nodiscard]] const std::optional<Error> &trouble() const { return m_trouble; }

    /// After this unit.
    void pause();
    void resume();
    /// A unit that waits is left out; one that is being served ends where nothing must be cut, and stays open in the journal.
    void skip(std::uint32_t row);
    /// One that was skipped, failed or refused once more, as a new visit.
    void retry(std::uint32_t row);
    void retryFailed();
    /// No more units; ends when those that run have ended.
    void finish();
    /// Motors stop now; the units that run have failed, and the queue ends.
    void stop();
    /// Renews the lease of the motors that turn; every 100 ms, by whoever watches over them.
    void renewLease();

    /// A row, a count or the state of the queue changed.
    [[nodiscard]] Listeners<> &changed() { return m_changed; }
    /// A unit has ended, and its row is in the journal.
    [[nodiscard]] Listeners<const Visit &> &unitEnded() { return m_unitEnded; }
    /// The last bus has ended; retry() begins again.
    [[nodiscard]] Listeners<> &ended() { return m_ended; }

private:
    class Bus;
    friend class Bus;
    void laneEnded(Bus &bus, const Result<void> &result);
    void count(const Visit &visit);
    void uncount(const Visit &visit) { change(visit, -1); }
    void change(const Visit &visit, int by);
    [[nodiscard]] bool mayBegin() const;
    [[nodiscard]] bool isComplete() const;
    [[nodiscard]] Task<void> recall();
    void startLane(Bus &bus);

    Clock &m_clock;
    RecipeMatter m_matter;
    QueueSurroundings m_around;
    QueueOptions m_options;
    tuning::DirectionBook m_directions;
    std::vector<Visit> m_earlier; ///< of the run that is resumed
    QueueCounts m_counts;
    std::optional<Error> m_trouble;
    std::uint32_t m_lastRow = 0;
    int m_lanes = 0;
    bool m_isPausing = false;
    bool m_isFinishing = false;
    Listeners<> m_changed;
    Listeners<const Visit &> m_unitEnded;
    Listeners<> m_ended;
    std::list<std::unique_ptr<Bus>> m_buses;
    Scope m_scope;
};

} // namespace mb::service
