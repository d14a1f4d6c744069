// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/logpoller.h"

#include "async/seconds.h"
#include "families/abstractdc/answertime.h"

#include <algorithm>

namespace mb::abstractdc {
namespace {

using namespace std::chrono_literals;

constexpr Duration silentPeriod = 500ms;
constexpr Duration pollerMemory = 3s;
constexpr Duration longestWait = 1s; ///< for one answer, however much is sent
/// Where one frame of fifty is lost, three on end without an answer are nothing special within a minute; five are.
constexpr int silentAfter = 5;
constexpr int longSilence = 20; ///< questions in a row without an answer, until it is asked less often

std::size_t at(Log log)
{
    return static_cast<std::size_t>(log);
}

} // namespace

LogPoller::LogPoller(CanLink &link, Clock &clock, Events events)
    : m_link(link)
    , m_clock(clock)
    , m_events(std::move(events))
    , m_isRecording(link.address().isRecording())
    , m_questions(link, clock)
    , m_timer(clock)
    , m_traffic(link.traffic().add([this](const Traffic &traffic) {
        if (!traffic.can)
            return;
        if (traffic.direction == Direction::Sent && traffic.can->extended && m_link.bitrate() > 0) // not our own orders
            m_wireFreeAt = std::max(m_wireFreeAt, m_clock.now()) + m_link.wireTime(*traffic.can);
        count(*traffic.can);
    }))
    , m_received(link.received().add([this](const CanFrame &frame) { receive(frame); }))
{
}

void LogPoller::speak(const Dialect *dialect, int offset)
{
    m_dialect = dialect;
    m_offset = offset;
    m_open.reset();
    schedule();
}

void LogPoller::wish(Log log, double hertz)
{
    Wish &wish = m_wishes.at(at(log));
    const auto period = hertz > 0.0 ? fromSeconds(1.0 / hertz) : Duration::zero();
    if (std::exchange(wish.period, period) == period)
        return;
    wish.due = std::min(std::max(wish.due, m_clock.now()), m_clock.now() + period);
    schedule();
}

/// Who else is polled here.
void LogPoller::count(const CanFrame &frame)
{
    if (!frame.extended && frame.size == 1 && frame.id >= id::logRequest && frame.id <= id::logRequest + maxOffset)
        m_askedSeen.at(frame.id - id::logRequest) = frame.time;
    if (m_isRecording)
        followRequest(frame);
}

void LogPoller::followRequest(const CanFrame &frame)
{
    if (!m_dialect || frame.extended || frame.size != 1)
        return;
    for (std::size_t i = 0; i < logCount; ++i) {
        const auto log = static_cast<Log>(i);
        if (!m_dialect->has(log) || !sameContent(frame, encodeLogRequest(*m_dialect, m_offset, log)))
            continue;
        if (m_open)
            timedOut();
        m_open = log;
        m_timer.startIn(answerTime(m_link), [this] { timedOut(); });
        return;
    }
}

std::size_t LogPoller::pollers() const
{
    const Instant since = m_clock.now() - pollerMemory;
    const auto others
        = std::ranges::count_if(m_askedSeen, [since](Instant time) { return time != Instant{} && time > since; });
    return std::max<std::size_t>(1, static_cast<std::size_t>(others));
}

/// From the end of an answer to the next question.
Duration LogPoller::gap() const
{
    return roundTrip(m_link) * static_cast<int>(2 * pollers() - 1);
}

Log LogPoller::mostUrgent() const
{
    std::size_t best = at(Log::Velocity);
    Instant soonest = Instant::max();
    const bool isShared = reachesOthers();
    for (std::size_t i = 0; i < logCount; ++i) {
        const Wish &wish = m_wishes.at(i);
        const bool possible = wish.period > Duration::zero() && m_dialect && m_dialect->has(static_cast<Log>(i))
            && !(isShared && static_cast<Log>(i) == Log::Voltage);
        if (!possible || wish.due >= soonest)
            continue;
        best = i;
        soonest = wish.due;
    }
    return static_cast<Log>(best);
}

void LogPoller::schedule()
{
    if (m_open)
        return;
    if (m_isRecording) {
        m_timer.stop();
        return;
    }
    const Wish &wish = m_wishes.at(at(mostUrgent()));
    Instant next = m_dialect && wish.period > Duration::zero() ? wish.due : m_freeAt + silentPeriod;
    next = std::max({next, m_freeAt, m_clock.now()});
    m_timer.start(next, [this] { ask(); });
}

void LogPoller::ask()
{
    if (m_link.state() != LinkState::Open) {
        m_freeAt = m_clock.now() + silentPeriod;
        if (m_heard)
            timedOut();
        else
            schedule();
        return;
    }
    if (m_wireFreeAt > m_clock.now() + roundTrip(m_link)) { // behind a page of firmware, an answer would seem lost
        m_freeAt = m_wireFreeAt;
        schedule();
        return;
    }
    const Log log = mostUrgent();
    Wish &wish = m_wishes.at(at(log));
    const Dialect &spoken = m_dialect ? *m_dialect : dialectF;
    const Question question{m_offset, spoken.request, static_cast<std::uint8_t>(spoken.codeOf(log))};
    if (!m_questions.isFree(question, replyId(spoken, m_offset, log))) {
        (m_dialect ? wish.due : m_freeAt) = m_clock.now() + roundTrip(m_link); // somebody else is answered there
        schedule();
        return;
    }
    wish.due = std::max(wish.due + wish.period, m_clock.now());
    m_askedAt = m_clock.now();
    m_timer.startIn(answerTime(m_link), [this] { expired(); });
    if (m_link.send(encodeLogRequest(spoken, m_offset, log)))
        m_open = log; // else nobody was asked and no answer is missing
}

/// What this program sends to other families after a question may win over its answer on the wire: a page of firmware is 50 ms.
void LogPoller::expired()
{
    const Instant fair = std::min(m_wireFreeAt + answerTime(m_link), m_askedAt + longestWait);
    if (m_open && m_wireFreeAt > m_askedAt && fair > m_clock.now())
        m_timer.start(fair, [this] { expired(); });
    else
        timedOut();
}

void LogPoller::timedOut()
{
    const auto open = std::exchange(m_open, std::nullopt);
    m_missed = std::min(m_missed + 1, longSilence);
    if (open && m_heard)
        m_events.missed(*open);
    if (m_missed >= silentAfter) {
        m_freeAt = m_clock.now() + (m_missed < longSilence ? answerTime(m_link) : silentPeriod);
        if (std::exchange(m_heard, false))
            m_events.silent();
    }
    schedule();
}

std::optional<LogReply> LogPoller::replyIn(const CanFrame &frame) const
{
    if (!m_questions.isOf(m_offset, m_dialect))
        return std::nullopt;
    if (m_dialect)
        return decodeLog(*m_dialect, m_offset, frame);
    for (const Dialect *dialect : {&dialectF, &dialectL}) {
        const auto reply = decodeLog(*dialect, m_offset, frame);
        if (reply && reply->log == Log::Velocity)
            return reply;
    }
    return std::nullopt;
}

void LogPoller::receive(const CanFrame &frame)
{
    if (frame.extended || frame.size != 4)
        return;
    if (const auto reply = replyIn(frame))
        arrived(reply->log, reply->value, frame.time);
}

void LogPoller::arrived(Log log, std::int32_t value, Instant time)
{
    m_missed = 0;
    m_heard = true;
    if (m_open == log) {
        m_open.reset();
        m_freeAt = m_clock.now() + gap();
    }
    m_events.answered(log, value, time);
    schedule();
}

} // namespace mb::abstractdc
