// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "async/scope.h"
#include "async/task.h"
#include "families/supermodified/codec.h"
#include "families/supermodified/drivennodes.h"
#include "families/supermodified/linepolls.h"
#include "families/supermodified/linetiming.h"
#include "families/supermodified/roster.h"
#include "families/supermodified/silence.h"
#include "transport/seriallink.h"

#include <list>
#include <memory>

namespace mb::supermodified {

/// The half-duplex line that nodes share: one request in flight, whoever asks (a scan, the tasks, moves and polls of every
/// node). Stops go first, then moves, then tasks in turn with polls. One per link, made when first needed.
///
/// It listens before it talks: after the port was opened, and after a question without answer, nothing but a stop goes out
/// before the line was silent, because D1 and D2 do not find back from bytes that collided (README.md). A stop that went out
/// before that goes out again after it.
///
/// What is known of the nodes is in its roster, which outlives it.
class Line final : public std::enable_shared_from_this<Line>, private NonCopyable {
public:
    using Request = LineRequest;
    using Rank = LineRequest::Rank;
    /// Called once, never from inside submit().
    using Done = LineReply;

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
    ~Line() = default;

    [[nodiscard]] SerialLink &link() const { return m_link; }
    [[nodiscard]] Clock &clock() const { return m_clock; }

    [[nodiscard]] Ticket submit(Request request, Done done);

    /// Questions that are repeated.
    [[nodiscard]] LinePolls &polls() { return m_polls; }

    /// Frames of others than our own exchange: another master's, or late replies.
    [[nodiscard]] Listeners<const Frame &> &unsolicited() { return m_unsolicited; }

    [[nodiscard]] Roster &roster() { return m_roster; }
    [[nodiscard]] const AnswerTime &answerTimes() const { return m_timing.times(); }

    /// While a motor is driven nothing may change the rate of the line.
    [[nodiscard]] DrivenNodes &driven() { return m_driven; }

private:
    struct Entry {
        std::uint64_t id = 0;
        Request request;
        Done done{};
        LinePolls::Key poll = 0; ///< 0: not a poll
    };
    struct InFlight {
        Entry entry;
        Instant sentEnd{};
        Duration replyTime{};
        std::optional<Frame> reply{}; ///< while it is not known whether more comes (LineRequest::settles)
        Instant settledAt{};
        bool excused = false; ///< it got more time, because this machine was late
        bool isSent = false;  ///< else the line still gets its rate
    };
    void forget(std::uint64_t id);
    void pump();
    [[nodiscard]] std::optional<Entry> next();
    void begin(Entry entry);
    [[nodiscard]] Result<void> mayHaveItsRate(const Request &request) const;
    void transmit(const Result<void> &rate);
    void armTimeout(Duration patience);
    void armTimeoutAt(Instant deadline);
    void expired(Instant deadline);
    void giveUp();
    [[nodiscard]] bool keeps(const Frame &reply);
    void shortenTimeout();
    [[nodiscard]] bool isSilent();
    [[nodiscard]] bool stopWaits() const { return !m_waiting.empty() && m_waiting.front().request.rank == Rank::Stop; }
    void repeatStops();
    void onBytes(std::span<const std::uint8_t> bytes);
    void onFrame(const Frame &frame);
    void finish(Result<Frame> result);
    void tell(const Entry &entry, Result<Frame> result);
    void onLinkState();
    void failUpTo(std::uint64_t id);

    SerialLink &m_link;
    Clock &m_clock;
    FrameReader m_reader;
    LinePolls m_polls;
    LineTiming m_timing;
    std::list<Entry> m_waiting; ///< in order of rank
    std::optional<InFlight> m_inFlight;
    Scope m_rateChange;
    std::vector<Request> m_early; ///< stops that did not wait for silence
    std::uint64_t m_lastId = 0;
    std::uint64_t m_failUpTo = 0;
    bool m_pumping = false;
    Roster &m_roster;
    DrivenNodes m_driven;
    Timer m_timeout;
    Silence m_silence; ///< while it is awaited only stops are sent
    Timer m_kick;
    Listeners<const Frame &> m_unsolicited;
    Subscription m_received;
    Subscription m_state;
};

/// One exchange as a task: the reply, which may be an error frame. The line outlives it.
[[nodiscard]] Task<Frame> ask(Line &line, Line::Request request);

} // namespace mb::supermodified
