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

Duration timeOf(const SerialLink &link, std::size_t bytes)
{
    return link.byteTime() * static_cast<int>(bytes);
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
    , m_timeout(clock)
    , m_pollTimer(clock)
    , m_kick(clock)
    , m_received(link.received().add([this](std::span<const std::uint8_t> bytes) {
        const auto self = weak_from_this().lock();
        m_reader.feed(bytes);
    }))
    , m_state(link.stateChanged().add([this](LinkState) { onLinkState(); }))
{
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
        hurry();
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
void Line::hurry()
{
    if (m_inFlight && m_inFlight->entry.request.rank != Rank::Stop)
        armTimeout(std::min(m_inFlight->entry.request.patience, hurriedPatience));
}

void Line::armTimeout(Duration patience)
{
    m_timeout.start(m_inFlight->sentEnd + m_inFlight->replyTime + patience, [this] {
        m_reader.forget();
        if (!m_inFlight->entry.request.answered)
            finish(m_inFlight->entry.request.frame);
        else
            finish(fail(
                Fault::Timeout, "node " + std::to_string(m_inFlight->entry.request.frame.to) + " does not answer"));
    });
}

void Line::pump()
{
    if (m_pumping || m_inFlight || m_link.state() != LinkState::Open)
        return;
    m_pumping = true;
    if (auto entry = next())
        transmit(std::move(*entry));
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

void Line::transmit(Entry entry)
{
    Request &request = entry.request;
    if (request.frame.from == 0)
        request.frame.from = static_cast<std::uint8_t>(m_hostId);
    Result<void> sent = changeRate(request);
    const auto bytes = uartBytes(request.frame);
    m_reader.forget();
    if (sent)
        sent = m_link.send(bytes, request.rank == Rank::Stop ? Priority::Urgent : Priority::Normal);
    const Duration patience = request.answered ? request.patience : broadcastPause;
    const Duration replyTime = request.answered ? timeOf(m_link, frameOverhead + request.replySize) : Duration::zero();
    m_inFlight = InFlight{std::move(entry), m_clock.now() + timeOf(m_link, bytes.size()), replyTime};
    if (sent)
        armTimeout(patience);
    else
        m_timeout.startIn(Duration::zero(), [this, error = sent.error()] { finish(fail(error)); });
}

/// The stop of a driven motor, a guardian's too, goes out at the rate that the line has.
Result<void> Line::changeRate(const Request &request)
{
    if (isDriving() && request.rank != Rank::Stop && request.baudrate != m_link.baudrate())
        return fail(Fault::Unsafe,
            "a motor is driven on this line at " + std::to_string(m_link.baudrate())
                + " bit/s, and this node has another rate",
            "stop it first");
    return m_link.setBaudrate(request.baudrate);
}

void Line::onFrame(const Frame &frame)
{
    if (m_inFlight && m_inFlight->entry.request.answered) {
        const Frame &sent = m_inFlight->entry.request.frame;
        if (answers(frame, sent.to, sent.from, static_cast<Command>(sent.command))) {
            const Duration took = m_clock.now() - m_inFlight->sentEnd - timeOf(m_link, frameOverhead + frame.size);
            m_link.noteRoundTrip(std::max(took, Duration::zero()));
            finish(frame);
            return;
        }
    }
    m_overheard.notify(frame);
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
    const Error error
        = m_link.state() == LinkState::Open ? Error{Fault::LinkLost, "the link was opened anew"} : m_link.notOpen();
    if (m_inFlight && m_inFlight->entry.id <= id) {
        const Done done = std::move(m_inFlight->entry.done);
        m_inFlight.reset();
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

bool Line::belongs(int host, int node, std::uint8_t mask)
{
    return (host & mask) == (node & mask);
}

void Line::note(int node, const Known &known)
{
    m_nodes[node] = known;
    chooseHost();
}

void Line::forgetNode(int node)
{
    m_nodes.erase(node);
    chooseHost();
}

void Line::chooseHost()
{
    const auto isFree = [this](int host) {
        return std::none_of(m_nodes.begin(), m_nodes.end(),
            [host](const auto &entry) { return entry.first == host || belongs(host, entry.first, entry.second.mask); });
    };
    for (int host = usualHostId; host <= highestNode; ++host) {
        if (isFree(host)) {
            m_hostId = host;
            return;
        }
    }
}

std::vector<int> Line::groupOf(int node) const
{
    std::vector<int> group;
    for (const auto &[other, known] : m_nodes) {
        if (other != node && belongs(node, other, known.mask))
            group.push_back(other);
    }
    return group;
}

void Line::setDriving(int node, bool driving)
{
    if (driving)
        m_driving.insert(node);
    else
        m_driving.erase(node);
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
