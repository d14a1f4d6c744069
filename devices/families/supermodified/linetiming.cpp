// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/linetiming.h"

#include "families/supermodified/codec.h"

#include <algorithm>
#include <utility>

namespace mb::supermodified {
namespace {

using namespace std::chrono_literals;

/// A node needs this long for a broadcast before it listens again.
constexpr Duration broadcastPause = 1ms;
/// An answer this late belongs to no question any more.
constexpr Duration forgottenAfter = 1s;
/// After a known node missed a question the next ones wait twice as long each, so often.
constexpr int doublings = 2;
/// After that it is silent: one question in so many waits as long as any node may take.
constexpr int patientEvery = 8;

} // namespace

Duration LineTiming::patienceFor(const LineRequest &request) const
{
    if (!request.answered)
        return broadcastPause;
    if (const Patience &forced = m_link.settings().patience; forced.timeout && request.rank == LineRequest::Rank::Task)
        return request.patience > answerTime ? forced.work(request.patience) : forced.answer(request.patience);
    const Duration usual = m_times.patience(request.patience);
    const Duration longest = std::max(usual, AnswerTime::ceiling);
    const auto missed = m_misses.find(request.frame.to);
    const int misses = missed == m_misses.end() ? 0 : missed->second;
    if (misses <= doublings)
        return std::min(usual * (1 << misses), longest);
    return request.rank == LineRequest::Rank::Poll && misses % patientEvery == 0 ? longest : usual;
}

void LineTiming::measure(const Frame &reply, Instant sentEnd)
{
    const Duration wire = m_link.byteTime() * static_cast<int>(frameOverhead + reply.size);
    const Duration took = std::max<Duration>(m_clock.now() - sentEnd - wire, Duration::zero());
    m_times.add(took);
    m_link.noteRoundTrip(took);
}

void LineTiming::answered(const Frame &question, Instant sentEnd, const Frame &reply)
{
    const auto missed = std::exchange(m_missed, std::nullopt);
    m_misses.erase(question.to);
    const bool again = missed && missed->frame.to == question.to && missed->frame.command == question.command;
    if (!again) // else which of the two it answers cannot be told
        measure(reply, sentEnd);
}

/// A node answers in order, and with an error to any question.
bool LineTiming::mayBeEarlier(const Frame &question, const Frame &reply) const
{
    return m_missed && m_missed->frame.to == question.to && m_clock.now() - m_missed->sentEnd <= forgottenAfter
        && (m_missed->frame.command == question.command || reply.is(Command::Error));
}

void LineTiming::gaveUp(const Frame &question, Instant sentEnd, bool known)
{
    m_missed = Missed{question, sentEnd};
    if (known)
        ++m_misses[question.to];
}

void LineTiming::late(const Frame &reply)
{
    if (!m_missed || m_clock.now() - m_missed->sentEnd > forgottenAfter)
        return;
    const Frame &asked = m_missed->frame;
    if (answers(reply, asked.to, asked.from, static_cast<Command>(asked.command)))
        measure(reply, std::exchange(m_missed, std::nullopt)->sentEnd);
}

} // namespace mb::supermodified
