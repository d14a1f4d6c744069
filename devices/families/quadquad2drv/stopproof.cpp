// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/stopproof.h"

#include "async/sleep.h"

#include <utility>

namespace mb::quadquad2drv {
namespace {

using namespace std::chrono_literals;

constexpr int stopTries = 20;
constexpr int triesBeforeReset = 2; ///< each of 100 ms, and as long again for a question that waits in between

} // namespace

StopProof::StopProof(Clock &clock, PacketPort &port, std::function<void()> reset, std::function<void()> ended)
    : m_clock(clock)
    , m_port(port)
    , m_reset(std::move(reset))
    , m_ended(std::move(ended))
    , m_scope(clock)
{
}

void StopProof::begin()
{
    ++m_stops;
    if (std::exchange(m_confirmed, false)) {
        m_unanswered = 0;
        m_resetTried = false;
    }
    (void)m_port.urgent(setControlMode(allAxes, ControlMode::Off));
    m_scope.spawn<void>(confirm(), [this, stops = m_stops](const Result<void> &) {
        if (stops == m_stops)
            m_ended();
    });
}

/// Answered twice in a row: the first may be the late answer to an order from before the stop. A stop that is repeated does
/// not put off the last resort.
Task<void> StopProof::confirm()
{
    const std::uint64_t stops = m_stops;
    for (int i = 0, answered = 0; i < stopTries && stops == m_stops; ++i) {
        if (m_unanswered >= triesBeforeReset && !std::exchange(m_resetTried, true))
            m_reset();
        const Result<Packet> reply = co_await m_port.request(setControlMode(allAxes, ControlMode::Off), 1).attempt();
        answered = reply ? answered + 1 : 0;
        m_unanswered = reply ? 0 : m_unanswered + 1;
        if (answered == 2) {
            m_confirmed = stops == m_stops;
            break;
        }
        if (!reply && reply.error().fault == Fault::LinkLost)
            co_return fail(reply.error());
        if (!reply)
            co_await Sleep(m_clock, 10ms);
    }
    co_return {};
}

} // namespace mb::quadquad2drv
