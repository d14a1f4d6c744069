// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/line.h"

#include "async/event.h"

#include <algorithm>

namespace mb::supermodified {
namespace {

using namespace std::chrono_literals;

/// What a stop leaves a node that does not answer.
constexpr Duration hurriedPatience = 3ms;
/// After the port was opened: an answer to whoever had it before has begun by then.
constexpr Duration openingSilence = answerTime + 5ms;
/// Between the bytes of one piece, as adapters hand them out, and at least so many byte times.
constexpr Duration pieceGap = 3ms;
constexpr int pieceGapBytes = 3;
/// A deadline that is served later than this says that the machine was busy: what came meanwhile is still to be read.
constexpr Duration punctual = 1ms;

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
    , m_polls(clock, [this] { pump(); })
    , m_timing(link, clock)
    , m_rateChange(clock)
    , m_roster(link.kept<Roster>())
    , m_driven(m_roster)
    , m_timeout(clock)
    , m_silence(clock, [this] { pump(); })
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
    const auto place
        = std::ranges::find_if(m_waiting, [rank](const Entry &other) { return other.request.rank > rank; });
    m_waiting.insert(place, Entry{id, request, std::move(done)});
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
    m_timing.addLateness(late);
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
    if (m_inFlight->reply && m_clock.now() >= m_inFlight->settledAt) {
        const Frame reply = *m_inFlight->reply;
        m_timing.answered(frame, m_inFlight->sentEnd, reply);
        finish(reply);
        return;
    }
    m_timing.gaveUp(frame, m_inFlight->sentEnd, m_roster.nodes().contains(frame.to));
    m_reader.forget();
    finish(fail(Fault::Timeout, say("node %1 does not answer", frame.to)));
}

/// It may answer an earlier question, and then its own answer would be taken for that of the next: the last one counts.
bool Line::keeps(const Frame &reply)
{
    InFlight &question = *m_inFlight;
    if (!question.entry.request.settles
        || (!question.reply && !m_timing.mayBeEarlier(question.entry.request.frame, reply)))
        return false;
    question.reply = reply;
    question.settledAt = m_clock.now() + AnswerTime::ceiling;
    armTimeoutAt(stopWaits() ? m_clock.now() : question.settledAt); // then it is asked again
    return true;
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

/// What they met on the line nobody knows; their answers were taken already.
void Line::repeatStops()
{
    for (Request &request : std::exchange(m_early, {}))
        m_waiting.push_front(Entry{++m_lastId, request});
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
        m_polls.arm();
}

std::optional<Line::Entry> Line::next()
{
    if (m_waiting.empty() || m_waiting.front().request.rank == Rank::Task) {
        if (auto poll = m_polls.next(!m_waiting.empty()))
            return Entry{++m_lastId, poll->request, std::move(poll->done), poll->key};
    }
    if (m_waiting.empty())
        return std::nullopt;
    Entry entry = std::move(m_waiting.front());
    m_waiting.pop_front();
    m_polls.passTurn();
    return entry;
}

void Line::begin(Entry entry)
{
    const int rate = entry.request.baudrate;
    m_inFlight = InFlight{std::move(entry)};
    const auto allowed = mayHaveItsRate(m_inFlight->entry.request);
    if (allowed && rate != m_link.baudrate() && m_link.settings().background)
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
    const Duration patience = m_timing.patienceFor(request);
    if (m_silence.isAwaited() && request.rank == Rank::Stop) {
        std::erase_if(m_early, [&request](const Request &known) { return known.frame.to == request.frame.to; });
        m_early.push_back(request);
    }
    m_inFlight->sentEnd = m_clock.now() + timeOf(m_link, bytes.size());
    m_inFlight->replyTime = request.answered ? timeOf(m_link, frameOverhead + request.replySize) : Duration::zero();
    if (sent) {
        armTimeout(stopWaits() && request.rank != Rank::Stop ? std::min(patience, hurriedPatience) : patience);
        if (const auto left = request.left)
            left();
    } else {
        m_timeout.startIn(Duration::zero(), [this, error = sent.error()] { finish(fail(error)); });
    }
}

/// The stop of a driven motor, a guardian's too, goes out at the rate that the line has.
Result<void> Line::mayHaveItsRate(const Request &request) const
{
    if (m_driven.any() && request.rank != Rank::Stop && request.baudrate != m_link.baudrate())
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
            if (!keeps(frame)) {
                m_timing.answered(sent, m_inFlight->sentEnd, frame);
                finish(frame);
            }
            return;
        }
    }
    m_timing.late(frame);
    m_unsolicited.notify(frame);
}

void Line::finish(Result<Frame> result)
{
    const auto self = weak_from_this().lock();
    m_timeout.stop();
    const Entry entry = std::move(m_inFlight->entry);
    m_inFlight.reset();
    tell(entry, std::move(result));
    pump();
}

/// A poll may have been removed meanwhile.
void Line::tell(const Entry &entry, Result<Frame> result)
{
    if (entry.done && (entry.poll == 0 || m_polls.has(entry.poll)))
        entry.done(std::move(result));
}

void Line::onLinkState()
{
    if (m_link.state() != LinkState::Open) {
        m_polls.stop();
        m_timeout.stop();
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
        const Entry entry = std::move(m_inFlight->entry);
        m_timeout.stop();
        m_inFlight.reset();
        m_rateChange.clear();
        tell(entry, fail(error));
    }
    for (;;) {
        const auto old = std::ranges::find_if(m_waiting, [id](const Entry &entry) { return entry.id <= id; });
        if (old == m_waiting.end())
            return;
        const Done done = std::move(old->done);
        m_waiting.erase(old);
        if (done)
            done(fail(error));
    }
}

// As a task

namespace {

struct Answer {
    Answer(Line &line, Line::Request request)
        : ticket(line.submit(request, [this](Result<Frame> reply) {
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
    Answer answer(line, request);
    co_await answer.arrived.wait();
    co_return std::move(answer.result);
}

} // namespace mb::supermodified
