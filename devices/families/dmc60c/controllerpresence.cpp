// SPDX-License-Identifier: GPL-3.0-or-later
// Controller: what follows from frames and from silence: liveness, restarts, other units under the same number.
#include "families/dmc60c/controller.h"

#include "families/dmc60c/setpoints.h"
#include "families/dmc60c/unitidentity.h"

#include <algorithm>

namespace mb::dmc60c {
namespace {

using namespace std::chrono_literals;

constexpr Duration silenceAtLeast = 100ms; ///< README.md#status-frames
constexpr int silencePeriods = 5;
constexpr Duration foreignMemory = 500ms;
constexpr int candidateRounds = 3;
constexpr Duration stallTolerance = 20ms;
constexpr Duration turningMemory = 500ms;

} // namespace

Duration Controller::silenceLimit() const
{
    return std::max<Duration>(silencePeriods * m_general.period(), silenceAtLeast);
}

void Controller::armTick()
{
    Instant next = m_heard && m_generalAt ? *m_generalAt + silenceLimit() : m_enumerateAt;
    if (m_foreignAt)
        next = std::min(next, *m_foreignAt + foreignMemory);
    if (m_candidate)
        next = std::min(next, m_candidate->nextAt);
    m_armedFor = std::max(next, clock().now());
    m_timer.start(m_armedFor, [this] { tick(); });
}

void Controller::tick()
{
    const Instant now = clock().now();
    if (now - m_armedFor > stallTolerance) { // we were stalled: first let the link deliver what came meanwhile
        m_armedFor = now + stallTolerance;
        m_timer.start(m_armedFor, [this] { tick(); });
        return;
    }
    if (m_foreignAt && now - *m_foreignAt >= foreignMemory)
        m_foreignAt.reset();
    if (m_heard && m_generalAt && now - *m_generalAt >= silenceLimit())
        fallSilent();
    if (m_candidate && now >= m_candidate->nextAt)
        judgeCandidate();
    if (!m_heard && now >= m_enumerateAt)
        enumerate();
    updateLiveness();
    armTick();
}

void Controller::fallSilent()
{
    m_heard = false;
    m_turning = false;
    m_faultWatch.forget();
    m_told = {};
    m_general.interrupt();
    m_encoder.interrupt();
    m_analog.interrupt();
    m_enumerateAt = clock().now();
}

void Controller::enumerate()
{
    m_enumerateAt = clock().now() + enumeratePeriod;
    if (busy().empty() && m_can.state() == LinkState::Open)
        (void)m_can.send(encodeEnumerate());
}

/// A new session alone is a restarted unit; with the known one still answering it is a second unit. Answers may be
/// lost, so that the known one gets several chances.
void Controller::judgeCandidate()
{
    if (m_candidate->enumerations < candidateRounds && busy().empty()) {
        ++m_candidate->enumerations;
        m_candidate->nextAt = clock().now() + candidateStep;
        enumerate();
        return;
    }
    const std::uint16_t session = m_candidate->session;
    m_candidate.reset();
    if (!busy().empty())
        return;
    Identity known = identity();
    if (m_knownSession && m_ownSeenAt + candidateStep >= m_candidateSince) {
        markDuplicate(known, 2);
        setIdentity(std::move(known));
        return;
    }
    known.session = session;
    setIdentity(std::move(known)); // sessionChanged() follows
    m_enumerateAt = clock().now(); // for its versions
}

void Controller::sessionChanged()
{
    if (identity().session == m_knownSession)
        return;
    m_knownSession = identity().session;
    m_candidate.reset();
    restarted();
}

void Controller::restarted()
{
    m_restarted = true;
    m_flashLost = m_flashLost || m_flash.isPending();
    m_flash.restarted();
    for (StatusStream *stream : {&m_general, &m_encoder, &m_analog})
        stream->restart();
    parameters().forgetAll();
    if (busy().empty()) {
        for (const auto &[parameter, period] : m_wantedPeriods)
            (void)m_can.send(encodeParamSet(identity().address, session(), parameter, period));
    }
    updateLiveness();
}

void Controller::setState(DeviceState state, Message detail)
{
    Identity known = identity();
    known.state = state;
    known.detail = std::move(detail);
    setIdentity(std::move(known));
}

void Controller::updateLiveness()
{
    const bool turning
        = m_turning && clock().now() - m_turningAt < std::max<Duration>(turningMemory, 3 * m_encoder.period());
    const bool moving = m_heard && (m_lastGeneral.duty != 0 || turning);
    const std::uint32_t frameless = m_faultWatch.present(clock().now());
    // One frame in ten thousand changes any of this: compare a word before building texts.
    const std::uint32_t key = (m_heard ? 1U : 0U) | (moving ? 2U : 0U) | (m_foreignAt ? 4U : 0U)
        | (m_restarted ? 8U : 0U) | (m_lastGeneral.overTemperature ? 16U : 0U) | (m_lastGeneral.underVoltage ? 32U : 0U)
        | (m_lastGeneral.gateDriver ? 64U : 0U) | (static_cast<std::uint32_t>(m_lastGeneral.mode) << 8U)
        | (frameless << 16U);
    if (key == m_livenessKey) {
        setStates(m_told, m_toldAt);
        return;
    }
    m_livenessKey = key;
    Liveness now;
    now.heard = m_heard;
    now.moving = moving;
    now.foreignMaster = m_foreignAt.has_value();
    now.restarted = m_restarted;
    if (m_heard) {
        now.mode = modeOf(m_lastGeneral.mode);
        if ((frameless & faultbit::overCurrent) != 0U)
            now.faults.emplace_back("over_current");
        if (m_lastGeneral.overTemperature)
            now.faults.emplace_back("over_temperature");
        if (m_lastGeneral.underVoltage)
            now.faults.emplace_back("under_voltage");
        if (m_lastGeneral.gateDriver)
            now.faults.emplace_back("gate_driver");
        if ((frameless & faultbit::communication) != 0U)
            now.faults.emplace_back("communication");
    }
    setLiveness(now, m_told, m_toldAt);
}

} // namespace mb::dmc60c
