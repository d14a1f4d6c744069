// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/engine/stationpermit.h"

#include "async/noncopyable.h"
#include "model/device.h"
#include "model/heardsince.h"
#include "model/session.h"

#include <algorithm>
#include <utility>

namespace mb {
namespace {

constexpr Duration armedAgain = std::chrono::milliseconds(100);
constexpr Duration awakeEvery = std::chrono::seconds(1);
constexpr Duration asleep = std::chrono::milliseconds(20); ///< less is two clocks that are not read at one instant

/// One more, as long as it lives.
class Counted : NonCopyable {
public:
    explicit Counted(int &count)
        : m_count(count)
    {
        ++m_count;
    }
    ~Counted() { --m_count; }

private:
    int &m_count;
};

} // namespace

StationPermit::StationPermit(Clock &clock)
    : m_clock(clock)
    , m_until(clock)
{
}

void StationPermit::arm(bool on)
{
    m_armings += on && !isArmed();
    m_slept = m_clock.slept();
    set(on ? MayTurn::Every : MayTurn::Nothing);
}

void StationPermit::set(MayTurn mayTurn)
{
    m_mayTurn = mayTurn;
    if (mayTurn == MayTurn::Nothing)
        takeBack();
    restart();
    m_changed.notify();
}

void StationPermit::describe(ServiceView &view) const
{
    view.mayTurn = m_mayTurn;
    view.armedUntil = m_end;
    view.announced = m_announcing;
    view.waiting = m_waiting;
}

void StationPermit::disarmNext()
{
    if (isArmed())
        set(MayTurn::WhatTurns);
}

void StationPermit::setServed(bool on)
{
    if (std::exchange(m_isServed, on) != on)
        restart();
}

void StationPermit::restart()
{
    m_end = m_clock.now() + armedTime;
    look();
}

/// Whoever armed it has left when the computer has slept.
void StationPermit::look()
{
    if (m_isServed)
        m_end = m_clock.now() + armedTime;
    if (!isArmed())
        m_until.stop();
    else if (m_clock.now() >= m_end || m_clock.slept() - m_slept > asleep)
        arm(false);
    else
        m_until.start(std::min(m_end, m_clock.now() + awakeEvery), [this] { look(); });
}

/// Three seconds in which everybody is told, and somebody can still say no: then it waits again, and tells it anew.
Task<void> StationPermit::beforeMotion(const Device &device, const service::SelfTest &, Progress &progress)
{
    int arming = 0;
    do {
        co_await untilArmed(device, progress);
        arming = m_armings;
        const Counted announcing(m_announcing);
        m_changed.notify();
        co_await Sleep(m_clock, announcement);
        look(); // who sleeps in the last second of it is not there either
    } while (!isArmed() || arming != m_armings);
    m_changed.notify();
    co_return {};
}

/// Everything else is done by then, and nothing is lost while it waits.
Task<void> StationPermit::untilArmed(const Device &device, Progress &progress)
{
    const Counted waiting(m_waiting);
    const bool isFollowed = device.liveness().heard;
    Instant heardAt = m_clock.now();
    while (!isArmed()) {
        if (m_isLeaving)
            co_return fail(Fault::Cancelled, say("left before the station was armed"));
        if (device.link().state() != LinkState::Open)
            co_return fail(
                Fault::LinkLost, say("%1: %2", device.link().address().shortName(), device.link().loss().message()));
        if (device.liveness().heard)
            heardAt = m_clock.now();
        if (isFollowed && m_clock.now() - heardAt >= exchangeTime)
            co_return fail(Fault::Timeout, say("the unit was taken off while it waited for the station to be armed"),
                say("hold Arm, then put it on again"));
        progress.step(say("waits until the station is armed"), 0, 0);
        co_await Sleep(m_clock, armedAgain);
    }
    co_return {};
}

} // namespace mb
