// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/presence.h"

#include <algorithm>
#include <utility>

namespace mb::dmc60c {
namespace {

using namespace std::chrono_literals;

constexpr Duration silenceAtLeast = 100ms; ///< README.md#status-frames
constexpr int silencePeriods = 5;
constexpr Duration foreignMemory = 500ms;
constexpr int candidateRounds = 3;
constexpr Duration stallTolerance = 20ms;
constexpr Duration enumeratePeriod = 2s; ///< while the device is silent
/// The latest answer to an enumeration starts after 63.5 ms.
constexpr Duration candidateStep = 70ms;

} // namespace

Presence::Presence(Clock &clock, std::optional<int> session, Owner owner)
    : m_clock(clock)
    , m_owner(std::move(owner))
    , m_session(session)
    , m_enumerateAt(clock.now() + enumeratePeriod)
    , m_timer(clock)
{
    armTick();
}

bool Presence::heard(Instant time)
{
    m_heardAt = time;
    return !std::exchange(m_heard, true);
}

void Presence::commandedByOther(Instant time)
{
    m_foreignAt = time;
    m_owner.looked();
    armTick();
}

void Presence::sessionTold(std::uint16_t session, Instant time, bool judged)
{
    if (m_session == session) {
        m_ownSeenAt = time;
        return;
    }
    if (judged || m_owner.isBusy() || m_candidate)
        return;
    m_candidate = Candidate{session, 0, m_clock.now() + candidateStep};
    m_candidateSince = time;
    armTick();
}

bool Presence::takeSession(std::optional<int> session)
{
    if (session == m_session)
        return false;
    m_session = session;
    m_candidate.reset();
    return true;
}

Duration Presence::silenceLimit() const
{
    return std::max<Duration>(silencePeriods * m_owner.period(), silenceAtLeast);
}

void Presence::armTick()
{
    Instant next = m_heard && m_heardAt ? *m_heardAt + silenceLimit() : m_enumerateAt;
    if (m_foreignAt)
        next = std::min(next, *m_foreignAt + foreignMemory);
    if (m_candidate)
        next = std::min(next, m_candidate->nextAt);
    m_armedFor = std::max(next, m_clock.now());
    m_timer.start(m_armedFor, [this] { tick(); });
}

void Presence::tick()
{
    const Instant now = m_clock.now();
    if (now - m_armedFor > stallTolerance) { // we were stalled: first let the link deliver what came meanwhile
        m_armedFor = now + stallTolerance;
        m_timer.start(m_armedFor, [this] { tick(); });
        return;
    }
    if (m_foreignAt && now - *m_foreignAt >= foreignMemory)
        m_foreignAt.reset();
    if (m_heard && m_heardAt && now - *m_heardAt >= silenceLimit()) {
        m_heard = false;
        m_owner.silent();
        m_enumerateAt = m_clock.now();
    }
    if (m_candidate && now >= m_candidate->nextAt)
        judgeCandidate();
    if (!m_heard && now >= m_enumerateAt)
        enumerate();
    m_owner.looked();
    armTick();
}

void Presence::enumerate()
{
    m_enumerateAt = m_clock.now() + enumeratePeriod;
    if (!m_owner.isBusy())
        m_owner.askWho();
}

/// A new session alone is a restarted unit; with the known one still answering it is a second unit. Answers may be
/// lost, so that the known one gets several chances.
void Presence::judgeCandidate()
{
    if (m_candidate->enumerations < candidateRounds && !m_owner.isBusy()) {
        ++m_candidate->enumerations;
        m_candidate->nextAt = m_clock.now() + candidateStep;
        enumerate();
        return;
    }
    const std::uint16_t session = m_candidate->session;
    m_candidate.reset();
    if (m_owner.isBusy())
        return;
    if (m_session && m_ownSeenAt + candidateStep >= m_candidateSince) {
        m_owner.doubled();
        return;
    }
    m_owner.renewed(session);      // takeSession() follows
    m_enumerateAt = m_clock.now(); // for its versions
}

} // namespace mb::dmc60c
