// SPDX-License-Identifier: GPL-3.0-or-later
// What the drive measures, and what it says about it.
#include "families/dmc60c/simulatorcontrol.h"

#include <algorithm>
#include <cmath>

namespace mb::dmc60c::simulation {
namespace {

constexpr int passesPerSecond = 2000;
constexpr int lowPassesForFault = 5 * passesPerSecond;
constexpr double lowVolts = 5.75;
constexpr double overCurrentAmperes = 100.0; ///< the rating: 2 s
constexpr int overCurrentPasses = 2 * passesPerSecond;
constexpr double hotCelsius = 100.0; ///< not documented
constexpr double coolCelsius = 90.0;
constexpr std::uint32_t drivingFaults
    = faultbit::overCurrent | faultbit::overTemperature | faultbit::underVoltage | faultbit::gateDriver;

std::int64_t floorDivide(std::int64_t value, std::int64_t by)
{
    return value >= 0 ? value / by : -((-value + by - 1) / by);
}

} // namespace

void Drive::sense()
{
    const std::int64_t counts = m_rig.counts();
    const bool reversed = m_command.reverseSensor && !isFollowing();
    const std::int64_t moved = reversed ? m_lastCounts - counts : counts - m_lastCounts;
    m_position += static_cast<std::uint32_t>(moved);
    m_counter += moved;
    clearPosition(m_lastCounts, counts);
    m_lastCounts = counts;
    m_velocity = static_cast<std::int32_t>(std::clamp<std::int64_t>(velocityNow(), -2147483647, 2147483647));
    m_current = static_cast<std::int64_t>(m_rig.adcCurrent()) * m_bank.value(number::adcMultiplier);
}

std::int64_t Drive::velocityNow()
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

void Drive::clearPosition(std::int64_t before, std::int64_t after)
{
    const std::int64_t turn = m_rig.countsPerTurn();
    if (m_bank.flag(number::clearOnIndex) && before != after && turn > 0) {
        // The index is high on one count of a turn: entering it is the rising edge, leaving it the falling one.
        const bool forward = after > before;
        const std::int64_t edge = m_bank.flag(number::indexEdge) == forward ? 0 : 1;
        const std::int64_t turns = floorDivide(after - edge, turn);
        if (turns != floorDivide(before - edge, turn)) {
            const std::int64_t at = (forward ? turns : turns + 1) * turn + edge;
            m_position
                = static_cast<std::uint32_t>(m_command.reverseSensor && !isFollowing() ? at - after : after - at);
        }
    }
    if (m_bank.flag(number::clearOnForwardLimit) && m_forward.hit)
        m_position = 0;
    if (m_bank.flag(number::clearOnReverseLimit) && m_reverse.hit)
        m_position = 0;
}

void Drive::readLimits()
{
    m_forward.level = !m_rig.isForwardSwitchClosed();
    m_forward.normallyClosed = m_bank.flag(number::forwardNormallyClosed);
    m_forward.disabled = m_bank.flag(number::forwardDisabled);
    m_forward.disabledByFrame = m_command.forwardLimitOff;
    m_forward.softEnabled = m_bank.flag(number::softForwardEnable);
    m_forward.softHit = m_forward.softEnabled && position() >= m_bank.value(number::softForwardThreshold);
    m_reverse.level = !m_rig.isReverseSwitchClosed();
    m_reverse.normallyClosed = m_bank.flag(number::reverseNormallyClosed);
    m_reverse.disabled = m_bank.flag(number::reverseDisabled);
    m_reverse.disabledByFrame = m_command.reverseLimitOff;
    m_reverse.softEnabled = m_bank.flag(number::softReverseEnable);
    m_reverse.softHit = m_reverse.softEnabled && position() <= m_bank.value(number::softReverseThreshold);
    for (LimitPin *pin : {&m_forward, &m_reverse})
        pin->hit = pin->level == pin->normallyClosed;
}

void Drive::checkFaults(Instant at)
{
    m_lowPasses = m_rig.bus() < lowVolts ? std::min(m_lowPasses + 1, lowPassesForFault) : 0;
    const bool much = std::abs(m_rig.current()) > overCurrentAmperes;
    m_overCurrentPasses = much ? std::min(m_overCurrentPasses + 1, overCurrentPasses) : 0;
    const bool wasHot = (m_faults & faultbit::overTemperature) != 0U;
    std::uint32_t present = m_outsideFaults;
    if (m_overCurrentPasses == overCurrentPasses)
        present |= faultbit::overCurrent;
    if (m_lowPasses == lowPassesForFault)
        present |= faultbit::underVoltage;
    if (m_rig.caseTemperature() > (wasHot ? coolCelsius : hotCelsius))
        present |= faultbit::overTemperature;
    raise(present, at);
}

void Drive::raise(std::uint32_t present, Instant at)
{
    const std::uint32_t fresh = present & ~m_faults;
    m_faults = present;
    m_bank.set(param::activeFaults, present);
    if (fresh != 0) {
        m_bank.set(param::stickyFaults, m_bank.raw(param::stickyFaults) | fresh);
        for (unsigned bit = 0; bit < 5; ++bit) {
            const auto count = static_cast<std::uint8_t>(param::overCurrentCount + bit);
            if ((fresh >> bit & 1U) != 0U)
                m_bank.set(count, m_bank.raw(count) + 1);
        }
        m_notify(at, "fault", static_cast<double>(present));
    }
    if ((present & drivingFaults) != 0U)
        m_faultUntil = at + faultHold;
    m_faulted = at < m_faultUntil;
}

void Drive::setOutsideFault(std::uint32_t bit, bool present, Instant now)
{
    advance(now);
    m_outsideFaults = present ? m_outsideFaults | bit : m_outsideFaults & ~bit;
    wake();
    if (!m_running)
        return;
    raise(present ? m_faults | bit : m_faults & ~bit, now);
    if (m_faulted) {
        physics(now);
        apply(0, now);
    }
}

GeneralState Drive::general() const
{
    GeneralState state;
    state.duty = m_duty;
    state.forward = m_forward;
    state.reverse = m_reverse;
    state.limitOverride = m_command.overrideLimits;
    state.currentLimitActive = m_limiter.isActive();
    state.overTemperature = (m_faults & faultbit::overTemperature) != 0U;
    state.underVoltage = (m_faults & faultbit::underVoltage) != 0U;
    state.gateDriver = (m_faults & faultbit::gateDriver) != 0U;
    state.mode = static_cast<int>(isDisabled() ? ControlMode::NoDrive : m_command.mode);
    state.error = m_error;
    return state;
}

EncoderState Drive::encoder() const
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

AnalogState Drive::analog()
{
    const double perLsb = m_bank.value(number::adcMultiplier) / 65536.0;
    return {m_rig.analogInput(), m_rig.adcCurrent() * perLsb, m_rig.measuredTemperature(), m_rig.measuredBus()};
}

} // namespace mb::dmc60c::simulation
