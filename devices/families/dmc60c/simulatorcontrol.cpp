// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/simulatorcontrol.h"

#include <algorithm>
#include <cmath>

namespace mb::dmc60c::simulation {
namespace {

constexpr int quietPasses = 400; ///< 200 ms: the window of the last motion, and in blocks one without
constexpr std::int32_t fullReverse = -fullDuty - 1;

double seconds(Duration time)
{
    return std::chrono::duration<double>(time).count();
}

std::int32_t clampDuty(std::int64_t duty)
{
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(duty, fullReverse, fullDuty));
}

} // namespace

Drive::Drive(Rig rig, ParameterBank &bank, VelocityWindow window, Notify notify)
    : m_rig(rig)
    , m_bank(bank)
    , m_notify(std::move(notify))
    , m_sensing(m_rig, bank, window)
    , m_faults(bank, m_notify)
{
}

void Drive::start(Instant now, bool brakeButton)
{
    end(now);
    m_running = true;
    m_brakeButton = brakeButton;
    m_nextPass = now + loopPeriod;
    m_sensing.start();
    m_faults.start(now);
    wake();
    m_limits.read(m_rig, m_bank, m_command, position());
}

void Drive::end(Instant now)
{
    advance(now);
    physics(now);
    apply(0, now);
    m_running = false;
    m_halted = true;
    m_command = ControlWord();
    m_error = 0;
}

void Drive::command(const ControlWord &word, Instant now)
{
    advance(now);
    const bool sameLoop = word.mode == m_command.mode && word.slot == m_command.slot;
    m_command = word;
    if (!sameLoop)
        m_pid.reset();
    if (word.mode == ControlMode::NoDrive) {
        halt(now, false);
    } else if (word.target != 0 && m_halted) {
        m_halted = false;
        m_pid.reset();
        m_limiter.reset();
    }
    wake();
}

void Drive::halt(Instant now, bool busLost)
{
    advance(now);
    physics(now);
    if (!m_halted)
        m_notify(now, "halted", 0.0);
    m_halted = true;
    if (busLost)
        m_command = ControlWord();
    m_error = 0;
    m_pid.reset();
    m_limiter.reset();
    apply(0, now);
    wake();
}

void Drive::masterHeard(std::int32_t duty, Instant now)
{
    advance(now);
    m_master = {duty, now};
    wake();
}

bool Drive::isClosedLoop() const
{
    return m_command.mode == ControlMode::Velocity || m_command.mode == ControlMode::Position
        || m_command.mode == ControlMode::Current;
}

void Drive::advance(Instant now)
{
    if (m_advancing) // a listener of an event asks for the state
        return;
    m_advancing = true;
    while (m_running && m_nextPass <= now && !isIdle()) {
        physics(m_nextPass);
        pass(m_nextPass);
        m_nextPass += loopPeriod;
    }
    if (m_running && m_nextPass <= now)
        m_nextPass += ((now - m_nextPass) / loopPeriod + 1) * Duration(loopPeriod);
    if (!m_running || isIdle())
        physics(now);
    m_advancing = false;
}

void Drive::physics(Instant until)
{
    const Rig::Neutral neutral
        = m_running && !m_faults.holdsBridge() && (m_command.overrideNeutral ? m_command.brake : m_brakeButton)
        ? Rig::Neutral::Brake
        : Rig::Neutral::Coast;
    while (m_physicsAt < until) {
        if (m_duty == 0 && m_rig.isAtRest()) {
            m_rig.rest(seconds(until - m_physicsAt));
            m_physicsAt = until;
            return;
        }
        const Instant next = std::min<Instant>(until, m_physicsAt + loopPeriod);
        m_rig.step(static_cast<double>(m_duty) / fullDuty, neutral, seconds(next - m_physicsAt));
        m_physicsAt = next;
    }
}

bool Drive::isIdle() const
{
    if (m_outputOn || m_quietPasses <= quietPasses || m_faults.any() || !m_rig.isAtRest() || m_faults.isSupplyLow())
        return false;
    if (m_halted)
        return true;
    return !isClosedLoop() && m_command.target == 0;
}

void Drive::pass(Instant at)
{
    m_sensing.pass(m_command.reverseSensor && !isFollowing(), m_limits.forward.hit, m_limits.reverse.hit);
    m_limits.read(m_rig, m_bank, m_command, position());
    m_faults.pass(m_rig, at);
    std::int32_t duty = 0;
    if (isDisabled()) {
        m_pid.reset();
        m_limiter.reset();
        m_error = 0;
    } else {
        duty = demand(at);
        duty = m_limiter.step(m_bank, duty, present(), m_sensing.current());
    }
    m_quietPasses = duty == 0 && m_rig.isAtRest() ? m_quietPasses + 1 : 0;
    apply(m_command.reverseMotor ? clampDuty(-std::int64_t{duty}) : duty, at);
}

std::int32_t Drive::present() const
{
    return m_command.reverseMotor ? clampDuty(-std::int64_t{m_duty}) : m_duty;
}

std::int32_t Drive::demand(Instant at)
{
    switch (m_command.mode) {
    case ControlMode::Voltage: {
        const std::int32_t duty = ramped(present(), m_command.target, m_command.ramp);
        m_error = m_command.target - duty;
        return duty;
    }
    case ControlMode::VoltageCompensated: return compensated();
    case ControlMode::Follower: m_error = 0; return at - m_master.at < heartbeat ? m_master.duty : 0;
    case ControlMode::Velocity:
    case ControlMode::Position:
    case ControlMode::Current: return closedLoop();
    case ControlMode::NoDrive: break;
    }
    return 0;
}

std::int32_t Drive::compensated()
{
    const double bus = std::max(m_rig.measuredBus(), 1.0);
    const double volts = m_command.target / 65536.0;
    const std::int32_t wanted = clampDuty(std::llround(volts / bus * fullDuty));
    const std::int32_t duty = ramped(present(), wanted, m_command.ramp);
    m_error = std::llround((volts - bus * duty / fullDuty) * 65536.0);
    return duty;
}

std::int32_t Drive::closedLoop()
{
    const Slot slot = Slot::of(m_bank, m_command.slot);
    const bool current = m_command.mode == ControlMode::Current;
    std::int64_t feedback = position();
    if (m_command.mode == ControlMode::Velocity)
        feedback = m_sensing.velocity();
    else if (current)
        feedback = m_command.reverseMotor ? -m_sensing.current() : m_sensing.current();
    m_error = m_command.target - feedback;
    const std::int64_t throttle
        = m_pid.step(slot.gains, m_command.target, feedback, slot.allowableError, current ? 16 : 0);
    const bool outside = slot.allowableError == 0 || std::abs(m_error) >= slot.allowableError;
    return shaped(slot, throttle, present(), outside);
}

void Drive::apply(std::int32_t duty, Instant at)
{
    if (m_limits.block(duty, m_command.overrideLimits))
        duty = 0;
    m_duty = duty;
    const bool on = !isDisabled() && (duty != 0 || isClosedLoop());
    if (on != m_outputOn)
        m_notify(at, on ? "output-on" : "output-off", 0.0);
    m_outputOn = on;
}

void Drive::setOutsideFault(std::uint32_t bit, bool present, Instant now)
{
    advance(now);
    m_faults.setOutside(bit, present);
    wake();
    if (!m_running)
        return;
    m_faults.raiseOutside(bit, present, now);
    if (m_faults.holdsBridge()) {
        physics(now);
        apply(0, now);
    }
}

GeneralState Drive::general() const
{
    GeneralState state;
    state.duty = m_duty;
    state.forward = m_limits.forward;
    state.reverse = m_limits.reverse;
    state.limitOverride = m_command.overrideLimits;
    state.currentLimitActive = m_limiter.isActive();
    state.overTemperature = m_faults.has(faultbit::overTemperature);
    state.underVoltage = m_faults.has(faultbit::underVoltage);
    state.gateDriver = m_faults.has(faultbit::gateDriver);
    state.mode = static_cast<int>(isDisabled() ? ControlMode::NoDrive : m_command.mode);
    state.error = m_error;
    return state;
}

AnalogState Drive::analog()
{
    const double perLsb = m_bank.value(number::adcMultiplier) / 65536.0;
    return {m_rig.analogInput(), m_rig.adcCurrent() * perLsb, m_rig.measuredTemperature(), m_rig.measuredBus()};
}

} // namespace mb::dmc60c::simulation
