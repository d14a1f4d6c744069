// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/task.h"
#include "families/supermodified/codec.h"
#include "families/supermodified/pollschedule.h"
#include "transport/seriallink.h"

#include <list>
#include <map>
#include <memory>
#include <set>

namespace mb::supermodified {

/// The half-duplex line that nodes share: one request in flight, whoever asks (a scan, the tasks, moves and polls of every
/// node). Stops go first, then moves, then tasks in turn with polls. One per link, made when first needed.
///
/// It also keeps what is known of the line: which nodes answered, at which rate, and with which acceptance mask, so that
/// the host's own id belongs to no group of nodes (trap 6) and a second scan is fast.
class Line final : public std::enable_shared_from_this<Line> {
public:
    enum class Rank : std::uint8_t { Stop, Move, Task, Poll };

    struct Request {
        Frame frame;                    ///< `from` is filled in, unless it is not 0
        int baudrate = 0;               ///< the line changes to it before it sends
        std::size_t replySize = 0;      ///< data bytes to expect
        Duration patience = answerTime; ///< after the wire time of both frames
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

    // What is known of the line

    struct Known {
        int baudrate = 0;
        std::uint8_t mask = exactMask;
    };
    [[nodiscard]] const std::map<int, Known> &nodes() const { return m_nodes; }
    /// Changes the host's id when it would belong to the group of a node.
    void note(int node, const Known &known);
    /// It was noted from memory, and is not there.
    void forgetNode(int node);
    [[nodiscard]] int hostId() const { return m_hostId; }
    /// Ids of known nodes, other than itself, that act on what is sent to `node`.
    [[nodiscard]] std::vector<int> groupOf(int node) const;

    /// While a motor is driven nothing may change the rate of the line.
    void setDriving(int node, bool driving);
    [[nodiscard]] bool isDriving() const { return !m_driving.empty(); }

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
    };

    void forget(std::uint64_t id);
    void pump();
    [[nodiscard]] std::optional<Entry> next();
    void transmit(Entry entry);
    [[nodiscard]] Result<void> changeRate(const Request &request);
    void armTimeout(Duration patience);
    void hurry();
    void onFrame(const Frame &frame);
    void finish(Result<Frame> result);
    void onLinkState();
    void failUpTo(std::uint64_t id);
    void pollTurn();
    [[nodiscard]] static bool belongs(int host, int node, std::uint8_t mask);
    void chooseHost();

    SerialLink &m_link;
    Clock &m_clock;
    FrameReader m_reader;
    PollSchedule m_schedule;
    std::map<PollKey, Poll> m_polls;
    std::list<Entry> m_waiting; ///< in order of rank
    std::optional<InFlight> m_inFlight;
    std::uint64_t m_lastId = 0;
    std::uint64_t m_failUpTo = 0;
    bool m_taskWasLast = false;
    bool m_pumping = false;
    std::map<int, Known> m_nodes;
    std::set<int> m_driving;
    int m_hostId = usualHostId;
    Timer m_timeout;
    Timer m_pollTimer;
    Timer m_kick;
    Listeners<const Frame &> m_overheard;
    Subscription m_received;
    Subscription m_state;
};

/// One exchange as a task: the reply, which may be an error frame. The line outlives it.
[[nodiscard]] Task<Frame> ask(Line &line, Line::Request request);

} // namespace mb::supermodified
