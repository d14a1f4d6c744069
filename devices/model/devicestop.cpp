// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/devicestop.h"

#include "model/stoppable.h"

#include <utility>

namespace mb {
namespace {

using namespace std::chrono_literals;

constexpr Duration confirmEvery = 10ms;
constexpr Duration confirmRarely = 250ms;
constexpr Duration stopAgain = 250ms; ///< longer than a family's own confirmation of one stop
constexpr Duration stopRarely = 1s;
constexpr Duration noSignLimit = 1s;
constexpr Duration coastLimit = 10s; ///< of a device that is heard: a heavy load runs out

} // namespace

DeviceStop::DeviceStop(Stoppable &device)
    : m_device(device)
    , m_look(device.clock())
{
}

bool DeviceStop::mayTurn() const
{
    return m_forMotion && (m_state == StopState::Owed || m_state == StopState::Unconfirmed);
}

bool DeviceStop::mayStillTurn() const
{
    const bool isTold = m_state != StopState::None;
    return (m_moved || mayTurn()) && (!isTold || isStillOwed(m_toldAt, m_device.clock().now()));
}

bool DeviceStop::isDue() const
{
    return m_state == StopState::Stopping || m_state == StopState::Owed
        || (m_state == StopState::Unconfirmed && isStillOwed(m_toldAt, m_device.clock().now()));
}

void DeviceStop::driven()
{
    m_moved = true;
    m_look.stop();
    enter(StopState::None);
    m_forMotion = false;
}

void DeviceStop::told()
{
    m_forMotion = m_forMotion || m_moved || m_device.liveness().moving;
    m_toldAt = m_sentAt = m_device.clock().now();
    m_isGivenUp = false;
    const bool cut = m_device.link().state() != LinkState::Open && !m_device.hasWatchdog();
    m_look.startIn(confirmEvery, [this] { look(); });
    enter(cut ? StopState::Owed : StopState::Stopping);
}

void DeviceStop::inherit(Instant since)
{
    m_forMotion = true;
    if (isStillOwed(since, m_device.clock().now())) {
        m_device.stop();
        return;
    }
    m_toldAt = since;
    m_isGivenUp = true;
    m_look.startIn(confirmEvery, [this] { look(); });
    enter(StopState::Unconfirmed);
}

void DeviceStop::dismiss()
{
    m_look.stop();
    m_moved = m_forMotion = false;
    enter(StopState::None);
}

void DeviceStop::linkIsBack()
{
    if (!isDue() || !m_device.mayStop())
        return;
    sendScript(m_device.link(), m_device.stopScript()); // before what the family waits for, such as a quiet line
    m_device.stop();
}

void DeviceStop::look()
{
    if (m_device.isSeenStopped()) {
        m_moved = m_forMotion = false;
        enter(StopState::Seen);
    } else if (m_device.link().state() != LinkState::Open) {
        lookAtCutLine();
    } else {
        lookAtOpenLine();
    }
}

void DeviceStop::lookAtCutLine()
{
    const Instant now = m_device.clock().now();
    m_look.startIn(m_state == StopState::Stopping ? confirmEvery : confirmRarely, [this] { look(); });
    if (!m_device.hasWatchdog()) {
        m_isGivenUp = !isStillOwed(m_toldAt, now);
        enter(m_isGivenUp ? StopState::Unconfirmed : StopState::Owed);
    } else if (now - m_toldAt >= m_device.watchdogLimit())
        enter(StopState::ByWatchdog);
}

void DeviceStop::lookAtOpenLine()
{
    const Instant now = m_device.clock().now();
    const Duration since = now - m_toldAt;
    const bool heard = m_device.liveness().heard;
    if (m_state == StopState::Stopping && since >= (heard ? coastLimit : noSignLimit)) {
        if (!m_forMotion) { // one that cannot be told is owed no answer
            enter(m_device.mayStop() ? StopState::Silent : StopState::None);
            return;
        }
        enter(!heard && m_device.hasWatchdog() ? StopState::ByWatchdog : StopState::Unconfirmed);
    }
    if (m_state == StopState::Unconfirmed && !isDue() && !std::exchange(m_isGivenUp, true))
        m_changed.notify();
    const Duration pause = m_state == StopState::Stopping ? stopAgain : stopRarely;
    if (isDue() && now - m_sentAt >= pause && m_device.mayStop()) {
        m_sentAt = now;
        m_device.repeatStop();
    }
    m_look.startIn(m_state == StopState::Stopping ? confirmEvery : confirmRarely, [this] { look(); });
}

void DeviceStop::enter(StopState state)
{
    if (state == m_state)
        return;
    m_state = state;
    m_changed.notify();
}

} // namespace mb
