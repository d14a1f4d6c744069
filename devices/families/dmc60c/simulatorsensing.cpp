// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/simulatorsensing.h"

#include <algorithm>
#include <utility>

namespace mb::dmc60c::simulation {
namespace {

constexpr int passesPerWindow = 200; ///< 100 ms

std::int64_t floorDivide(std::int64_t value, std::int64_t by)
{
    return value >= 0 ? value / by : -((-value + by - 1) / by);
}

} // namespace

Sensing::Sensing(Rig &rig, const ParameterBank &bank, VelocityWindow window)
    : m_rig(rig)
    , m_bank(bank)
    , m_window(window)
    , m_history(passesPerWindow)
{
}

void Sensing::start()
{
    m_lastCounts = m_rig.counts();
    m_position = 0;
    m_counter = 0;
    std::ranges::fill(m_history, 0);
    m_velocity = 0;
}

void Sensing::pass(bool reversed, bool forwardHit, bool reverseHit)
{
    const std::int64_t counts = m_rig.counts();
    const std::int64_t moved = reversed ? m_lastCounts - counts : counts - m_lastCounts;
    m_position += static_cast<std::uint32_t>(moved);
    m_counter += moved;
    clearOnIndex(reversed, m_lastCounts, counts);
    const bool cleared = (m_bank.flag(number::clearOnForwardLimit) && forwardHit)
        || (m_bank.flag(number::clearOnReverseLimit) && reverseHit);
    if (cleared)
        m_position = 0;
    m_lastCounts = counts;
    m_velocity = static_cast<std::int32_t>(std::clamp<std::int64_t>(velocityNow(), -2147483647, 2147483647));
    m_current = static_cast<std::int64_t>(m_rig.adcCurrent()) * m_bank.value(number::adcMultiplier);
}

std::int64_t Sensing::velocityNow()
{
    const std::int64_t old = m_history[m_historyAt];
    if (m_window == VelocityWindow::Rolling) {
        m_history[m_historyAt] = m_counter;
        m_historyAt = (m_historyAt + 1) % m_history.size();
        return m_counter - old;
    }
    m_historyAt = (m_historyAt + 1) % m_history.size();
    if (m_historyAt != 0)
        return m_velocity;
    const std::int64_t before = std::exchange(m_history.back(), m_counter);
    return m_counter - before;
}

/// The index is high on one count of a turn: entering it is the rising edge, leaving it the falling one.
void Sensing::clearOnIndex(bool reversed, std::int64_t before, std::int64_t after)
{
    const std::int64_t turn = m_rig.countsPerTurn();
    if (!m_bank.flag(number::clearOnIndex) || before == after || turn <= 0)
        return;
    const bool forward = after > before;
    const std::int64_t edge = m_bank.flag(number::indexEdge) == forward ? 0 : 1;
    const std::int64_t turns = floorDivide(after - edge, turn);
    if (turns == floorDivide(before - edge, turn))
        return;
    const std::int64_t at = (forward ? turns : turns + 1) * turn + edge;
    m_position = static_cast<std::uint32_t>(reversed ? at - after : after - at);
}

EncoderState Sensing::encoder() const
{
    EncoderState state;
    state.position = position();
    state.velocity = m_velocity;
    const auto phase = static_cast<unsigned>(m_lastCounts & 3);
    state.pinA = phase == 1 || phase == 2;
    state.pinB = phase >= 2;
    const std::int64_t turn = m_rig.countsPerTurn();
    state.pinIndex = turn > 0 && m_lastCounts == floorDivide(m_lastCounts, turn) * turn;
    return state;
}

} // namespace mb::dmc60c::simulation
