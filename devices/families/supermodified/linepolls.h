// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/supermodified/linerequest.h"
#include "families/supermodified/pollschedule.h"

#include <map>

namespace mb::supermodified {

/// The questions of a line that are repeated for as long as their keys live, and whose turn it is between them and what else waits.
class LinePolls {
public:
    using Key = PollSchedule::Key;
    struct Poll {
        LineRequest request;
        LineReply done;
        Key key = 0;
    };

    /// `due` is called from the clock when one of them may be sent.
    LinePolls(Clock &clock, std::function<void()> due);

    /// `period` zero pauses it; `done` is called once a period, never from inside here.
    [[nodiscard]] Key add(LineRequest request, Duration period, LineReply done);
    void setPeriod(Key key, Duration period);
    void setRequest(Key key, LineRequest request);
    void remove(Key key);
    [[nodiscard]] bool has(Key key) const { return m_polls.contains(key); }
    /// Its last question was refused: it is due again now.
    void repeat(Key key) { m_schedule.hasten(key, m_clock.now()); }

    /// The next question, if one is due and comes before the tasks that wait; else those have their turn.
    [[nodiscard]] std::optional<Poll> next(bool tasksWait);
    /// Something else than a poll has been sent.
    void passTurn() { m_taskWasLast = true; }
    /// Waits for the next one to be due.
    void arm();
    void stop() { m_timer.stop(); }

private:
    Clock &m_clock;
    std::function<void()> m_due;
    PollSchedule m_schedule;
    std::map<Key, Poll> m_polls;
    bool m_taskWasLast = false;
    Timer m_timer;
};

} // namespace mb::supermodified
