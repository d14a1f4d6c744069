// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "async/scope.h"
#include "model/operation.h"
#include "model/session.h"
#include "service/queuerun.h"

#include <list>

namespace mb::service {

class QueueBus;

/// A recipe over many units: one at a time on a bus, several buses side by side (one after the other where the firmware takes
/// another way in, of which there is one). Units that may not be touched (two with one
/// number, wrong hardware) are refused in their row, the others go on. One that has just ended does not start again until it
/// was gone for 2 s. Thread of the session. Everything can be called at any time, but not from inside finished().
class ServiceQueue : NonCopyable {
public:
    ServiceQueue(Clock &clock, RecipeMatter matter, QueueSurroundings surroundings, QueueOptions options);
    /// What runs is cut off: motors stop, the journal has its open visits, and resumes them.
    ~ServiceQueue();

    /// Before start(). The session outlives the queue, the link is open; each bus has its own.
    void addBus(Session &session, Link &link);
    void start();

    /// In the order in which units were found; a row is the same object until something of it changes.
    [[nodiscard]] std::vector<Shared<QueueRow>> rows() const;
    [[nodiscard]] QueueCounts counts() const { return m_run.counts(); }
    [[nodiscard]] const RecipeMatter &matter() const { return m_run.matter(); }
    /// Name of this start, to be resumed; known once a unit has begun or start() has found it.
    [[nodiscard]] const std::string &run() const { return m_run.options().run; }
    [[nodiscard]] bool isRunning() const { return m_lanes > 0; }
    /// The steps of a unit on a real link are not over: the computer must not sleep between them.
    [[nodiscard]] bool mustStayAwake() const;
    /// The next unit is not begun; what runs goes on.
    [[nodiscard]] bool isPausing() const { return m_run.isPausing(); }
    /// Ended by its user, or by its numbers: nothing is served again in it.
    [[nodiscard]] bool isFinishing() const { return m_run.isFinishing(); }
    /// Nothing runs, because of pause().
    [[nodiscard]] bool isPaused() const { return m_run.isPausing() && !m_run.isServing(); }
    /// What ended the queue before its time: numbers that are used up, a lost link, a full disk. Empty detail: nothing did.
    [[nodiscard]] const std::optional<Error> &trouble() const { return m_run.trouble(); }

    /// After this unit.
    void pause() { m_run.setPausing(true); }
    void resume() { m_run.setPausing(false); }
    /// A unit that waits is left out; one that is being served ends where nothing must be cut, and stays open in the journal.
    void skip(std::uint32_t row);
    /// One that was skipped, failed or refused once more, as a new visit. Refused, with the reason: nothing comes of it.
    [[nodiscard]] Result<void> retry(std::uint32_t row);
    /// Whether any is served again.
    bool retryFailed();
    /// No more units; ends when those that run have ended.
    void finish() { m_run.finish(); }
    /// Motors stop now; the units that run have failed, and the queue ends.
    void stop();
    /// Renews the lease of the motors that turn; every 100 ms, by whoever watches over them.
    void renewLease();

    /// A row, a count or the state of the queue changed.
    [[nodiscard]] Listeners<> &changed() { return m_run.changed(); }
    /// A unit has ended, and its row is in the journal.
    [[nodiscard]] Listeners<const Visit &> &unitEnded() { return m_run.unitEnded(); }
    /// The last bus has ended; retry() begins again.
    [[nodiscard]] Listeners<> &ended() { return m_ended; }

private:
    void startLane(QueueBus &bus);
    void laneEnded(QueueBus &bus, const Result<void> &result);
    void closeLane();

    QueueRun m_run;
    int m_lanes = 0;
    Listeners<> m_ended;
    std::list<std::unique_ptr<QueueBus>> m_buses;
    Scope m_scope;
};

} // namespace mb::service
