// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/listeners.h"
#include "async/noncopyable.h"
#include "model/session.h"
#include "service/queuerow.h"
#include "service/unitservice.h"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

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

/// One run of a recipe over many units, as its buses share it: what is done and by whom, how many have ended how, and whether the
/// next may begin. Thread of the queue.
class QueueRun : NonCopyable {
public:
    QueueRun(Clock &clock, RecipeMatter matter, QueueSurroundings surroundings, QueueOptions options);

    [[nodiscard]] Clock &clock() const { return m_clock; }
    [[nodiscard]] const RecipeMatter &matter() const { return m_matter; }
    [[nodiscard]] const QueueOptions &options() const { return m_options; }
    [[nodiscard]] QueueSurroundings &around() { return m_around; }
    /// What the direction check has found in this run.
    [[nodiscard]] tuning::DirectionBook &directions() { return m_directions; }
    /// Of the run that is resumed, once recall() has ended.
    [[nodiscard]] const std::vector<Visit> &earlier() const { return m_earlier; }
    /// Number of the row that was made last; counted up by who makes one.
    [[nodiscard]] std::uint32_t &lastRow() { return m_lastRow; }
    /// Units that one scan finds, not as they are put on.
    [[nodiscard]] bool isOnce() const { return !m_options.units; }

    /// Names the run, or reads what an earlier one of this name has done. Fails with what the journal says.
    [[nodiscard]] Task<void> recall();

    [[nodiscard]] const QueueCounts &counts() const { return m_counts; }
    /// A unit has ended, its row is in the journal.
    void count(const Visit &visit);
    /// It begins again.
    void uncount(const Visit &visit) { change(visit, -1); }

    void setPausing(bool is);
    [[nodiscard]] bool isPausing() const { return m_isPausing; }
    void finish();
    [[nodiscard]] bool isFinishing() const { return m_isFinishing; }

    /// A bus of the run; both outlive it.
    void addPlace(Session &session, const Link &link) { m_places.emplace_back(&session, &link); }
    /// A unit of this serial number is heard, or being served, on another bus of the run.
    [[nodiscard]] bool isElsewhere(const Link &link, const std::string &unit) const;
    /// A bus has taken a unit in hand, or let go of it.
    void begin(const Link &link, const std::string &unit) { m_serving[&link] = unit; }
    void end(const Link &link) { m_serving.erase(&link); }
    [[nodiscard]] bool isServing() const { return !m_serving.empty(); }
    [[nodiscard]] bool isComplete() const;
    [[nodiscard]] bool mayBegin() const;

    /// The first one counts.
    void setTrouble(const Error &error);
    /// It goes on.
    void forgetTrouble() { m_trouble.reset(); }
    [[nodiscard]] const std::optional<Error> &trouble() const { return m_trouble; }

    [[nodiscard]] Listeners<> &changed() { return m_changed; }
    [[nodiscard]] Listeners<const Visit &> &unitEnded() { return m_unitEnded; }

private:
    void change(const Visit &visit, int by);

    Clock &m_clock;
    RecipeMatter m_matter;
    QueueSurroundings m_around;
    QueueOptions m_options;
    tuning::DirectionBook m_directions;
    std::vector<Visit> m_earlier;
    QueueCounts m_counts;
    std::optional<Error> m_trouble;
    std::vector<std::pair<Session *, const Link *>> m_places;
    std::map<const Link *, std::string> m_serving; ///< unit
    std::uint32_t m_lastRow = 0;
    bool m_isPausing = false;
    bool m_isFinishing = false;
    Listeners<> m_changed;
    Listeners<const Visit &> m_unitEnded;
};

} // namespace mb::service
