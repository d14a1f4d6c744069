// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/simulatorcontrol.h"

#include "wire/bytes.h"

#include <algorithm>
#include <cmath>

namespace mb::dmc60c::simulation {
namespace {

constexpr int passesPerWindow = 200; ///< 100 ms
constexpr std::int32_t fullReverse = -fullDuty - 1;

double seconds(Duration time)
{
    return std::chrono::duration<double>(time).count();
}

std::int32_t clampDuty(std::int64_t duty)
{
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(duty, fullReverse, fullDuty));
}

ControlMode modeOf(std::uint8_t code)
{
    return code <= static_cast<std::uint8_t>(ControlMode::Follower) ? static_cast<ControlMode>(code)
                                                                    : ControlMode::NoDrive;
}

} // namespace

ControlWord ControlWord::decode(std::span<const std::uint8_t> bytes)
{
    ControlWord word;
    word.mode = modeOf(bytes[0] & 0x0FU);
    word.overrideNeutral = (bytes[0] & 0x10U) != 0U;
    word.brake = (bytes[0] & 0x20U) != 0U;
    word.slot = (bytes[0] & 0x40U) != 0U ? 1 : 0;
    word.reverseSensor = (bytes[0] & 0x80U) != 0U;
    word.reverseMotor = (bytes[1] & 0x01U) != 0U;
    word.forwardLimitOff = (bytes[1] & 0x02U) != 0U;
    word.reverseLimitOff = (bytes[1] & 0x04U) != 0U;
    word.overrideLimits = (bytes[1] & 0x08U) != 0U;
    const std::uint32_t high = bytes[3];
    const std::uint32_t low = bytes[4];
    const std::uint32_t middle = bytes[5];
    if (word.mode == ControlMode::Follower)
        word.target = static_cast<std::int32_t>(low & id::deviceMask);
    else if (word.mode == ControlMode::Voltage)
        word.target = signExtend((middle << 8U) | low, 16);
    else if (word.mode != ControlMode::NoDrive)
        word.target = signExtend((high << 16U) | (middle << 8U) | low, 24);
    word.ramp = readU16le(bytes, 6);
    return word;
}

Drive::Drive(Rig &rig, ParameterBank &bank, VelocityWindow window, Notify notify)
    : m_rig(rig)
    , m_bank(bank)
    , m_window(window)
    , m_notify(std::move(notify))
    , m_history(passesPerWindow)
{
}

void Drive::start(Instant now, bool brakeButton)
{
    end(now);
    m_running = true;
    m_brakeButton = brakeButton;
    m_nextPass = now + loopPeriod;
    m_lastCounts = m_rig.counts();
    m_position = 0;
    m_counter = 0;
    std::fill(m_history.begin(), m_history.end(), 0);
    m_velocity = 0;
    m_outsideFaults &= faultbit::gateDriver;
    m_faults = 0;
    m_faulted = false;
    m_faultUntil = now;
    m_lowPasses = 0;
    m_overCurrentPasses = 0;
    wake();
    readLimits();
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
    m_masterDuty = duty;
    m_masterAt = now;
    wake();
}

int Drive::master() const
{
    return m_running && isFollowing() ? m_command.target : 0;
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
        = m_running && !m_faulted && (m_command.overrideNeutral ? m_command.brake : m_brakeButton)
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
    if (m_outputOn || m_quietPasses <= passesPerWindow || m_faults != 0 || !m_rig.isAtRest() || m_lowPasses != 0)
        return false;
    if (m_halted)
        return true;
    return !isClosedLoop() && m_command.target == 0;
}

void Drive::pass(Instant at)
{
    sense();
    readLimits();
    checkFaults(at);
    std::int32_t duty = 0;
    if (isDisabled()) {
        m_pid.reset();
        m_limiter.reset();
        m_error = 0;
    } else {
        duty = demand(at);
        duty = m_limiter.step(m_bank, duty, present(), m_current);
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
    case ControlMode::Follower: m_error = 0; return at - m_masterAt < heartbeat ? m_masterDuty : 0;
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
        feedback = m_velocity;
    else if (current)
        feedback = m_command.reverseMotor ? -m_current : m_current;
    m_error = m_command.target - feedback;
    const std::int64_t throttle
        = m_pid.step(slot.gains, m_command.target, feedback, slot.allowableError, current ? 16 : 0);
    const bool outside = slot.allowableError == 0 || std::abs(m_error) >= slot.allowableError;
    return shaped(slot, throttle, present(), outside);
}

void Drive::apply(std::int32_t duty, Instant at)
{
    const auto isBlocked = [](const LimitPin &pin, bool overridden) {
        return (pin.hit && !(overridden ? pin.disabledByFrame : pin.disabled)) || pin.softHit;
    };
    if (duty > 0 && isBlocked(m_forward, m_command.overrideLimits))
        duty = 0;
    if (duty < 0 && isBlocked(m_reverse, m_command.overrideLimits))
        duty = 0;
    m_duty = duty;
    const bool on = !isDisabled() && (duty != 0 || isClosedLoop());
    if (on != m_outputOn)
        m_notify(at, on ? "output-on" : "output-off", 0.0);
    m_outputOn = on;
}

} // namespace mb::dmc60c::simulation
