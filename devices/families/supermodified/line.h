// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/scope.h"
#include "async/task.h"
#include "families/supermodified/answertime.h"
#include "families/supermodified/codec.h"
#include "families/supermodified/pollschedule.h"
#include "families/supermodified/roster.h"
#include "families/supermodified/silence.h"
#include "transport/seriallink.h"

#include <list>
#include <map>
#include <memory>
#include <set>

namespace mb::supermodified {

/// The half-duplex line that nodes share: one request in flight, whoever asks (a scan, the tasks, moves and polls of every
/// node). Stops go first, then moves, then tasks in turn with polls. One per link, made when first needed.
///
/// It listens before it talks: after the port was opened, and after a question without answer, nothing but a stop goes out
/// before the line was silent, because D1 and D2 do not find back from bytes that collided (README.md). A stop that went out
/// before that goes out again after it.
///
/// What is known of the nodes is in its roster, which outlives it.
class Line final : public std::enable_shared_from_this<Line> {
public:
    enum class Rank : std::uint8_t { Stop, Move, Task, Poll };

    struct Request {
        Frame frame;               ///< `from` is filled in, unless it is not 0
        int baudrate = 0;          ///< the line changes to it before it sends
        std::size_t replySize = 0; ///< data bytes to expect
        Duration patience
            = answerTime; ///< after the wire time of both frames; longer where answers are known to be late
        Rank rank = Rank::Task;
        bool answered = true; ///< false for broadcasts
    };
    /// The reply, which may be an error frame; Timeout; LinkLost. Called once, never from inside submit().
    using Done = std::function<void(Result<Frame>)>;

    /// Keeps a request alive: dropping it means that nobody wants the answer any more. What is on the wire still gets its
    /// time.
    class [[nodiscard]] Ticket {
    public:
        Ticket() = default;
        Ticket(std::weak_ptr<Line> line, std::uint64_t id)
            : m_line(std::move(line))
            , m_id(id)
        {
        }
        Ticket(Ticket &&other) noexcept
            : m_line(std::move(other.m_line))
            , m_id(std::exchange(other.m_id, 0))
        {
        }
        Ticket &operator=(Ticket &&other) noexcept
        {
            reset();
            m_line = std::move(other.m_line);
            m_id = std::exchange(other.m_id, 0);
            return *this;
        }
        ~Ticket() { reset(); }
        void reset();

    private:
        std::weak_ptr<Line> m_line;
        std::uint64_t m_id = 0;
    };

    [[nodiscard]] static std::shared_ptr<Line> of(SerialLink &link, Clock &clock);
    Line(SerialLink &link, Clock &clock);
    Line(const Line &) = delete;
    Line &operator=(const Line &) = delete;
    ~Line() = default;

    [[nodiscard]] SerialLink &link() const { return m_link; }
    [[nodiscard]] Clock &clock() const { return m_clock; }

    [[nodiscard]] Ticket submit(Request request, Done done);

    /// A question that is repeated for as long as its key lives; `period` zero pauses it.
    using PollKey = PollSchedule::Key;
    [[nodiscard]] PollKey addPoll(Request request, Duration period, Done done);
    void setPollPeriod(PollKey key, Duration period);
    void setPollRequest(PollKey key, Request request);
    void removePoll(PollKey key);
    /// Its last question was refused: it is due again now.
    void repeatPoll(PollKey key) { m_schedule.hasten(key, m_clock.now()); }

    /// Frames of others than our own exchange: another master's, or late replies.
    [[nodiscard]] Listeners<const Frame &> &overheard() { return m_overheard; }

    [[nodiscard]] Roster &roster() { return m_roster; }
    [[nodiscard]] const AnswerTime &answerTimes() const { return m_answerTimes; }
    [[nodiscard]] const Roster &roster() const { return m_roster; }

    /// While a motor is driven nothing may change the rate of the line.
    void setDriving(int node, bool driving);
    [[nodiscard]] bool isDriving() const { return !m_driving.empty(); }
    /// A node that was driven is told to stop. Those that follow it may turn as well, and hear of it by the stop to its address
    /// only if nothing is lost: each is told by its own, now or when it is found.
    void leaderStopped(int node);
    /// Tells nodes that they are to be stopped for that reason.
    [[nodiscard]] Listeners<> &followersTold() { return m_followersTold; }
    /// Whether that holds for this node; once.
    [[nodiscard]] bool takeFollowerStop(int node) { return m_followerStops.erase(node) > 0; }

private:
    struct Entry {
        std::uint64_t id = 0;
        Request request;
        Done done;
        PollKey poll = 0; ///< 0: not a poll
    };
    struct Poll {
        Request request;
        Done done;
    };
    struct InFlight {
        Entry entry;
        Instant sentEnd{};
        Duration replyTime{};
        bool excused = false; ///< it got more time, because this machine was late
        bool isSent = false;  ///< else the line still gets its rate
    };
    /// A question that was given up; its answer may still come.
    struct Missed {
        Frame frame;
        Instant sentEnd{};
    };

    void forget(std::uint64_t id);
    void pump();
    [[nodiscard]] std::optional<Entry> next();
    void begin(Entry entry);
    [[nodiscard]] Result<void> mayHaveItsRate(const Request &request) const;
    void transmit(const Result<void> &rate);
    [[nodiscard]] Duration patienceFor(const Request &request) const;
    void armTimeout(Duration patience);
    void armTimeoutAt(Instant deadline);
    void expired(Instant deadline);
    void giveUp();
    void shortenTimeout();
    [[nodiscard]] bool isSilent();
    [[nodiscard]] bool stopWaits() const;
    void keepEarly(const Request &stop);
    void repeatStops();
    void onBytes(std::span<const std::uint8_t> bytes);
    void onFrame(const Frame &frame);
    void takeLate(const Frame &frame);
    void measure(const Frame &reply, Instant sentEnd);
    void finish(Result<Frame> result);
    void onLinkState();
    void failUpTo(std::uint64_t id);
    void pollTurn();

    SerialLink &m_link;
    Clock &m_clock;
    FrameReader m_reader;
    PollSchedule m_schedule;
    std::map<PollKey, Poll> m_polls;
    std::list<Entry> m_waiting; ///< in order of rank
    std::optional<InFlight> m_inFlight;
    Scope m_rateChange;
    std::optional<Missed> m_missed;
    std::map<int, int> m_misses; ///< of a node, in a row
    AnswerTime m_answerTimes;
    std::vector<Request> m_early; ///< stops that did not wait for silence
    std::uint64_t m_lastId = 0;
    std::uint64_t m_failUpTo = 0;
    bool m_taskWasLast = false;
    bool m_pumping = false;
    Roster &m_roster;
    std::set<int> m_driving;
    std::set<int> m_followerStops; ///< nodes that have not taken theirs
    Listeners<> m_followersTold;
    Timer m_timeout;
    Silence m_silence; ///< while it is awaited only stops are sent
    Timer m_pollTimer;
    Timer m_kick;
    Listeners<const Frame &> m_overheard;
    Subscription m_received;
    Subscription m_state;
};

/// One exchange as a task: the reply, which may be an error frame. The line outlives it.
[[nodiscard]] Task<Frame> ask(Line &line, Line::Request request);

} // namespace mb::supermodified
