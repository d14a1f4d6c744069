// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/line.h"

#include "async/event.h"

#include <algorithm>

namespace mb::supermodified {
namespace {

using namespace std::chrono_literals;

/// A node needs this long for a broadcast before it listens again.
constexpr Duration broadcastPause = 1ms;
/// What a stop leaves a node that does not answer.
constexpr Duration hurriedPatience = 3ms;
/// After the port was opened: an answer to whoever had it before has begun by then.
constexpr Duration openingSilence = answerTime + 5ms;
/// Between the bytes of one piece, as adapters hand them out, and at least so many byte times.
constexpr Duration pieceGap = 3ms;
constexpr int pieceGapBytes = 3;
/// An answer this late belongs to no question any more.
constexpr Duration forgottenAfter = 1s;
/// A deadline that is served later than this says that the machine was busy: what came meanwhile is still to be read.
constexpr Duration punctual = 1ms;
/// After a known node missed a question the next ones wait twice as long each, so often.
constexpr int doublings = 2;
/// After that it is silent: one question in so many waits as long as any node may take.
constexpr int patientEvery = 8;

Duration timeOf(const SerialLink &link, std::size_t bytes)
{
    return link.byteTime() * static_cast<int>(bytes);
}

Duration gapOf(const SerialLink &link)
{
    return std::max<Duration>(pieceGap, link.byteTime() * pieceGapBytes);
}

} // namespace

void Line::Ticket::reset()
{
    if (const std::uint64_t id = std::exchange(m_id, 0); id != 0) {
        if (const auto line = m_line.lock())
            line->forget(id);
    }
}

std::shared_ptr<Line> Line::of(SerialLink &link, Clock &clock)
{
    return link.shared<Line>([&] { return std::make_shared<Line>(link, clock); });
}

Line::Line(SerialLink &link, Clock &clock)
    : m_link(link)
    , m_clock(clock)
    , m_reader([this](const Frame &frame) { onFrame(frame); })
    , m_rateChange(clock)
    , m_roster(link.kept<Roster>())
    , m_timeout(clock)
    , m_silence(clock, [this] { pump(); })
    , m_pollTimer(clock)
    , m_kick(clock)
    , m_received(link.received().add([this](std::span<const std::uint8_t> bytes) { onBytes(bytes); }))
    , m_state(link.stateChanged().add([this](LinkState) { onLinkState(); }))
{
    m_silence.await(openingSilence);
}

// Requests

Line::Ticket Line::submit(Request request, Done done)
{
    const std::uint64_t id = ++m_lastId;
    const Rank rank = request.rank;
    const auto place = std::find_if(
        m_waiting.begin(), m_waiting.end(), [rank](const Entry &other) { return other.request.rank > rank; });
    m_waiting.insert(place, Entry{id, std::move(request), std::move(done), 0});
    if (rank == Rank::Stop)
        shortenTimeout();
    if (m_link.state() == LinkState::Open)
        pump();
    else
        m_kick.startIn(Duration::zero(), [this] { onLinkState(); });
    return {weak_from_this(), id};
}

void Line::forget(std::uint64_t id)
{
    if (m_inFlight && m_inFlight->entry.id == id)
        m_inFlight->entry.done = {};
    std::erase_if(m_waiting, [id](const Entry &entry) { return entry.id == id; });
}

/// A stop does not wait for somebody who is silent: what may still come is on the wire for replyTime only.
void Line::shortenTimeout()
{
    if (m_inFlight && m_inFlight->isSent && m_inFlight->entry.request.rank != Rank::Stop)
        armTimeout(std::min(m_inFlight->entry.request.patience, hurriedPatience));
}

Duration Line::patienceFor(const Request &request) const
{
    if (!request.answered)
        return broadcastPause;
    if (const Patience &wanted = m_link.patience(); wanted.timeout && request.rank == Rank::Task)
        return request.patience > answerTime ? wanted.work(request.patience) : wanted.answer(request.patience);
    const Duration usual = m_answerTimes.patience(request.patience);
    const Duration longest = std::max(usual, AnswerTime::ceiling);
    const auto missed = m_misses.find(request.frame.to);
    const int misses = missed == m_misses.end() ? 0 : missed->second;
    if (misses <= doublings)
        return std::min(usual * (1 << misses), longest);
    return request.rank == Rank::Poll && misses % patientEvery == 0 ? longest : usual;
}

void Line::armTimeout(Duration patience)
{
    armTimeoutAt(m_inFlight->sentEnd + m_inFlight->replyTime + patience);
}

void Line::armTimeoutAt(Instant deadline)
{
    const Instant when = std::max(deadline, m_clock.now());
    m_timeout.start(when, [this, when] { expired(when); });
}

/// An answer that has begun is heard out, and one that this machine had no time to read is not missed.
void Line::expired(Instant deadline)
{
    const Instant now = m_clock.now();
    const Duration late = now - deadline;
    m_answerTimes.addLateness(late);
    InFlight &question = *m_inFlight;
    if (!question.entry.request.answered) {
        finish(question.entry.request.frame);
    } else if (late > punctual && !std::exchange(question.excused, true)) {
        armTimeoutAt(now + std::clamp(late, Duration(answerTime), AnswerTime::ceiling));
    } else if (const Instant pause = m_silence.heardAt() + gapOf(m_link);
               m_silence.heardAt() > question.sentEnd && pause > now && now < question.sentEnd + Silence::longest) {
        armTimeoutAt(pause);
    } else {
        giveUp();
    }
}

void Line::giveUp()
{
    const Frame frame = m_inFlight->entry.request.frame;
    m_missed = Missed{frame, m_inFlight->sentEnd};
    if (m_roster.nodes().contains(frame.to))
        ++m_misses[frame.to];
    m_reader.forget();
    finish(fail(Fault::Timeout, say("node %1 does not answer", frame.to)));
}

// Silence

bool Line::isSilent()
{
    const bool waited = m_silence.isAwaited();
    if (!m_silence.look())
        return false;
    if (waited)
        repeatStops();
    return true;
}

bool Line::stopWaits() const
{
    return !m_waiting.empty() && m_waiting.front().request.rank == Rank::Stop;
}

void Line::keepEarly(const Request &stop)
{
    std::erase_if(m_early, [&stop](const Request &known) { return known.frame.to == stop.frame.to; });
    m_early.push_back(stop);
}

/// What they met on the line nobody knows; their answers were taken already.
void Line::repeatStops()
{
    for (Request &request : std::exchange(m_early, {}))
        m_waiting.push_front(Entry{++m_lastId, std::move(request), {}, 0});
}

void Line::onBytes(std::span<const std::uint8_t> bytes)
{
    const auto self = weak_from_this().lock();
    m_silence.interrupt(gapOf(m_link));
    m_reader.feed(bytes);
}

void Line::pump()
{
    if (m_pumping || m_inFlight || m_link.state() != LinkState::Open || (!isSilent() && !stopWaits()))
        return;
    m_pumping = true;
    if (auto entry = next())
        begin(std::move(*entry));
    m_pumping = false;
    if (!m_inFlight)
        pollTurn();
}

std::optional<Line::Entry> Line::next()
{
    const auto due = m_schedule.nextDue();
    const bool pollDue = due && *due <= m_clock.now();
    const bool onlyTasks = m_waiting.empty() || m_waiting.front().request.rank == Rank::Task;
    if (pollDue && onlyTasks && (m_waiting.empty() || m_taskWasLast)) {
        m_taskWasLast = false;
        const PollKey key = m_schedule.take(m_clock.now());
        const Poll &poll = m_polls.at(key);
        return Entry{++m_lastId, poll.request, poll.done, key};
    }
    if (m_waiting.empty())
        return std::nullopt;
    Entry entry = std::move(m_waiting.front());
    m_waiting.pop_front();
    m_taskWasLast = true;
    return entry;
}

void Line::begin(Entry entry)
{
    const int rate = entry.request.baudrate;
    m_inFlight = InFlight{std::move(entry)};
    const auto allowed = mayHaveItsRate(m_inFlight->entry.request);
    if (allowed && rate != m_link.baudrate() && m_link.background())
        m_rateChange.spawn<void>(m_link.setBaudrateSoon(rate), [this](const Result<void> &set) {
            if (m_inFlight && !m_inFlight->isSent)
                transmit(set);
        });
    else
        transmit(allowed ? m_link.setBaudrate(rate) : allowed);
}

/// Of what is in flight, at the rate that it wants, or that could not be had.
void Line::transmit(const Result<void> &rate)
{
    Request &request = m_inFlight->entry.request;
    if (request.frame.from == 0)
        request.frame.from = static_cast<std::uint8_t>(m_roster.hostId());
    Result<void> sent = rate;
    const auto bytes = uartBytes(request.frame);
    m_reader.forget();
    m_inFlight->isSent = true;
    if (sent)
        sent = m_link.send(bytes, request.rank == Rank::Stop ? Priority::Urgent : Priority::Normal);
    const Duration patience = patienceFor(request);
    if (m_silence.isAwaited() && request.rank == Rank::Stop)
        keepEarly(request);
    m_inFlight->sentEnd = m_clock.now() + timeOf(m_link, bytes.size());
    m_inFlight->replyTime = request.answered ? timeOf(m_link, frameOverhead + request.replySize) : Duration::zero();
    if (sent)
        armTimeout(stopWaits() && request.rank != Rank::Stop ? std::min(patience, hurriedPatience) : patience);
    else
        m_timeout.startIn(Duration::zero(), [this, error = sent.error()] { finish(fail(error)); });
}

/// The stop of a driven motor, a guardian's too, goes out at the rate that the line has.
Result<void> Line::mayHaveItsRate(const Request &request) const
{
    if (isDriving() && request.rank != Rank::Stop && request.baudrate != m_link.baudrate())
        return fail(Fault::Unsafe,
            say("a motor is driven on this line at %1 bit/s, and this node has another rate", m_link.baudrate()),
            say("stop it first"));
    return {};
}

void Line::onFrame(const Frame &frame)
{
    if (m_inFlight && m_inFlight->isSent && m_inFlight->entry.request.answered) {
        const Frame &sent = m_inFlight->entry.request.frame;
        if (answers(frame, sent.to, sent.from, static_cast<Command>(sent.command))) {
            const bool again = m_missed && m_missed->frame.to == sent.to && m_missed->frame.command == sent.command;
            if (!again) // else which of the two it answers cannot be told
                measure(frame, m_inFlight->sentEnd);
            m_missed.reset();
            m_misses.erase(sent.to);
            finish(frame);
            return;
        }
    }
    takeLate(frame);
    m_overheard.notify(frame);
}

/// The answer to a question that was given up says how long answers take now.
void Line::takeLate(const Frame &frame)
{
    if (!m_missed || m_clock.now() - m_missed->sentEnd > forgottenAfter)
        return;
    const Frame &asked = m_missed->frame;
    if (answers(frame, asked.to, asked.from, static_cast<Command>(asked.command)))
        measure(frame, std::exchange(m_missed, std::nullopt)->sentEnd);
}

void Line::measure(const Frame &reply, Instant sentEnd)
{
    const Duration took = m_clock.now() - sentEnd - timeOf(m_link, frameOverhead + reply.size);
    m_answerTimes.add(std::max(took, Duration::zero()));
    m_link.noteRoundTrip(std::max(took, Duration::zero()));
}

void Line::finish(Result<Frame> result)
{
    const auto self = weak_from_this().lock();
    m_timeout.stop();
    const Done done = std::move(m_inFlight->entry.done);
    m_inFlight.reset();
    if (done)
        done(std::move(result));
    pump();
}

void Line::pollTurn()
{
    const auto due = m_schedule.nextDue();
    if (!due)
        m_pollTimer.stop();
    else
        m_pollTimer.start(std::max(*due, m_clock.now()), [this] { pump(); });
}

void Line::onLinkState()
{
    if (m_link.state() != LinkState::Open) {
        m_pollTimer.stop();
        m_timeout.stop();
        m_reader.forget();
        m_failUpTo = m_lastId;
        m_early.clear();
    } else {
        m_silence.await(openingSilence);
    }
    // told from the clock: whoever listens to the link must not be surprised by the end of its own tasks
    m_kick.startIn(Duration::zero(), [this] {
        const auto self = weak_from_this().lock();
        failUpTo(m_failUpTo);
        pump();
    });
}

/// What was asked before the link went away has no answer any more.
void Line::failUpTo(std::uint64_t id)
{
    const Error error = m_link.state() == LinkState::Open ? Error{Fault::LinkLost, say("the link was opened anew")}
                                                          : m_link.notOpen();
    if (m_inFlight && m_inFlight->entry.id <= id) {
        const Done done = std::move(m_inFlight->entry.done);
        m_inFlight.reset();
        m_rateChange.clear();
        if (done)
            done(fail(error));
    }
    for (;;) {
        const auto old
            = std::find_if(m_waiting.begin(), m_waiting.end(), [id](const Entry &entry) { return entry.id <= id; });
        if (old == m_waiting.end())
            return;
        const Done done = std::move(old->done);
        m_waiting.erase(old);
        if (done)
            done(fail(error));
    }
}

// Polls

Line::PollKey Line::addPoll(Request request, Duration period, Done done)
{
    request.rank = Rank::Poll;
    const PollKey key = m_schedule.add(period, m_clock.now());
    m_polls[key] = Poll{std::move(request), std::move(done)};
    m_pollTimer.startIn(Duration::zero(), [this] { pump(); });
    return key;
}

void Line::setPollPeriod(PollKey key, Duration period)
{
    m_schedule.setPeriod(key, period, m_clock.now());
    if (!m_inFlight && m_link.state() == LinkState::Open)
        pollTurn();
}

void Line::setPollRequest(PollKey key, Request request)
{
    request.rank = Rank::Poll;
    m_polls.at(key).request = std::move(request);
}

void Line::removePoll(PollKey key)
{
    m_schedule.remove(key);
    m_polls.erase(key);
    if (m_inFlight && m_inFlight->entry.poll == key)
        m_inFlight->entry.done = {};
}

// What is known

void Line::setDriving(int node, bool driving)
{
    if (driving)
        m_driving.insert(node);
    else
        m_driving.erase(node);
}

void Line::leaderStopped(int node)
{
    for (const int follower : m_roster.followersOf(node))
        m_followerStops.insert(follower);
    if (!m_followerStops.empty())
        m_followersTold.notify();
}

// As a task

namespace {

struct Answer {
    Answer(Line &line, Line::Request request)
        : ticket(line.submit(std::move(request), [this](Result<Frame> reply) {
            result = std::move(reply);
            arrived.set();
        }))
    {
    }
    Result<Frame> result;
    Event arrived;
    Line::Ticket ticket;
};

} // namespace

Task<Frame> ask(Line &line, Line::Request request)
{
    Answer answer(line, std::move(request));
    co_await answer.arrived.wait();
    co_return std::move(answer.result);
}

} // namespace mb::supermodified
