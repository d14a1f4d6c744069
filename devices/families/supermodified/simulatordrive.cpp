// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/simulatordrive.h"

#include <algorithm>
#include <cmath>

namespace mb::supermodified::simulation {
namespace {

constexpr Duration loopPeriod = std::chrono::microseconds(1024);
constexpr double loopSeconds = 1.0 / loopsPerSecond;
constexpr std::int64_t stallError = 200; ///< ticks
constexpr int stallLoops = 1953;         ///< 2 s
constexpr int measureLoops = 98;         ///< 10 Hz
constexpr std::int64_t overflow = 0x7FFFFC00;
constexpr std::int64_t underflow = -0x7FFFFC00;
constexpr double fullDuty = 255.0;
constexpr int restTicks = 1;
constexpr Duration encoderTime = std::chrono::nanoseconds(25'600); ///< of one transfer over SPI
constexpr double kneeWidth = 2.0;

/// 32-bit arithmetic of the AVR: what overflows wraps.
std::int32_t wrapped(std::int64_t value)
{
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(static_cast<std::uint64_t>(value) & 0xFFFFFFFFU));
}

} // namespace

Drive::Drive(Dialect dialect, const MotorParameters &motor, double load, std::uint64_t seed)
    : m_dialect(dialect)
    , m_motor(motor, load)
    , m_gear(motor.gearRatio)
    , m_offset(static_cast<std::int64_t>(seed * 997U % static_cast<std::uint64_t>(ticksPerTurn(dialect))))
{
}

double Drive::ticksPerRadian() const
{
    return ticksPerTurn(m_dialect) / (2.0 * std::numbers::pi * m_gear);
}

double Drive::believedRate() const
{
    return m_dialect == Dialect::D3 ? loopsPerSecond : assumedLoopsPerSecond;
}

std::int64_t Drive::ticks() const
{
    if (m_dead)
        return *m_dead;
    const double exact = m_motor.angle() * ticksPerRadian();
    return static_cast<std::int64_t>(std::floor(m_reversed ? -exact : exact));
}

int Drive::absolutePosition() const
{
    const std::int64_t turn = ticksPerTurn(m_dialect);
    return static_cast<int>(((ticks() + m_offset) % turn + turn) % turn);
}

bool Drive::isResting() const
{
    return !m_on && m_motor.speed() == 0.0;
}

void Drive::restart(const LoopSettings &settings, Instant now)
{
    m_settings = settings;
    m_windup = settings.p > 0 ? 65535 / settings.p * 255 : 0;
    m_next = now + loopPeriod;
    m_zero = ticks();
    hold(0);
    setOn(false);
}

void Drive::hold(std::int64_t position)
{
    m_target = Target::Position;
    m_setPoint = position;
    m_exact = static_cast<double>(position);
    m_goal = m_exact;
    m_pace = 0.0;
    m_leastError = 0;
    m_stuckLoops = 0;
}

void Drive::setOn(bool on)
{
    m_duty = 0.0;
    m_sum = 0;
    m_lastError = 0;
    if (std::exchange(m_on, on) != on && switched)
        switched(on);
}

void Drive::start()
{
    m_zero = ticks();
    hold(0);
    setOn(true);
}

void Drive::halt()
{
    hold(position());
}

void Drive::resetPosition()
{
    m_zero = ticks();
    if (m_dialect == Dialect::D3)
        hold(0);
}

void Drive::moveTo(std::int64_t position, bool profiled)
{
    if (!profiled) {
        hold(position);
        return;
    }
    m_target = Target::ProfiledPosition;
    m_goal = static_cast<double>(position);
    setKnee();
}

/// As if the move began at rest: D1 and D2 compute it once.
void Drive::setKnee()
{
    const double distance = std::abs(m_goal - m_exact);
    const double velocity = m_settings.velocity;
    const double stopping = velocity * velocity / (2.0 * std::max<double>(m_settings.acceleration, 1.0));
    m_knee = m_goal - std::copysign(std::min(stopping, distance / 2.0), m_goal - m_exact);
    m_braking = false;
}

bool Drive::isAboutToLoop(Instant now) const
{
    return m_on && m_next - now <= encoderTime;
}

void Drive::moveAt(std::int64_t velocity, bool profiled)
{
    m_target = profiled ? Target::ProfiledVelocity : Target::Velocity;
    m_goal = static_cast<double>(velocity);
    if (!profiled)
        m_pace = m_goal;
}

void Drive::advance(Instant now)
{
    if (isResting() && m_next <= now) { // nothing changes until somebody asks
        const auto loops = (now - m_next) / loopPeriod;
        m_next += loops * loopPeriod;
    }
    while (m_next <= now) {
        m_motor.step(m_duty, m_on ? Bridge::Drive : Bridge::Coast, loopSeconds);
        m_next += loopPeriod;
        loop();
    }
}

void Drive::loop()
{
    measure();
    if (!m_on)
        return;
    profile();
    m_duty = control();
    watchEncoder();
}

void Drive::approach(double target, double most)
{
    m_pace = target > m_pace ? std::min(target, m_pace + most) : std::max(target, m_pace - most);
}

void Drive::profile()
{
    const double step = 1.0 / believedRate();
    const double most = m_settings.acceleration * step;
    switch (m_target) {
    case Target::Position: return;
    case Target::Velocity: break;
    case Target::ProfiledVelocity: approach(m_goal, most); break;
    case Target::ProfiledPosition: m_dialect == Dialect::D3 ? profilePosition(step) : profileByKnee(step); break;
    }
    m_exact += m_pace * step;
    m_setPoint = static_cast<std::int64_t>(std::llround(m_exact));
}

/// A trapezoid: as fast as allowed, and no faster than what can still be braked.
void Drive::profilePosition(double step)
{
    const double left = m_goal - m_exact;
    const double acceleration = std::max<double>(m_settings.acceleration, 1.0);
    if (std::abs(left) <= std::max(1.0, std::abs(m_pace) * step)) {
        m_exact = m_goal;
        m_pace = 0.0;
        m_target = Target::Position;
        return;
    }
    const double braking = std::sqrt(2.0 * acceleration * std::abs(left));
    approach(std::copysign(std::min<double>(m_settings.velocity, braking), left), acceleration * step);
}

/// D1, D2: braking begins only in a loop that finds the set-point at the knee. Fast ones step over it, and go on (README.md#passed-target).
void Drive::profileByKnee(double step)
{
    const double acceleration = std::max<double>(m_settings.acceleration, 1.0);
    const double ahead = std::copysign(1.0, m_goal - m_knee);
    const double left = (m_goal - m_exact) * ahead;
    m_braking = m_braking || std::abs(m_exact - m_knee) < kneeWidth;
    if (m_braking && (left <= 1.0 || m_pace == 0.0)) {
        m_exact = m_goal;
        m_pace = 0.0;
        m_target = Target::Position;
        return;
    }
    const double pace = m_braking ? std::sqrt(2.0 * acceleration * left) : static_cast<double>(m_settings.velocity);
    approach(std::copysign(std::min<double>(m_settings.velocity, pace), ahead), acceleration * step);
}

double Drive::control()
{
    const std::int64_t error = position() - m_setPoint;
    m_sum = std::clamp(m_sum + error, -m_windup, m_windup);
    const std::int64_t scale = m_dialect == Dialect::D3 ? ticksPerTurn(Dialect::D3) / ticksPerTurn(Dialect::D1) : 1;
    const std::int64_t proportional = m_settings.p * error / scale;
    const std::int64_t derivative = m_settings.d * (error - m_lastError) / scale;
    const std::int64_t integral = m_settings.i * m_sum / scale / 256;
    const std::int32_t out = wrapped(proportional + derivative + integral);
    m_lastError = error;
    watchStall(std::abs(error));
    if (!m_on)
        return 0.0;
    const double magnitude = std::min(std::abs(static_cast<double>(out)) / 256.0, fullDuty);
    return std::copysign(std::floor(magnitude) / fullDuty, -static_cast<double>(out));
}

void Drive::watchStall(std::int64_t error)
{
    if (error < stallError || m_leastError == 0 || error < m_leastError) {
        m_leastError = error < stallError ? 0 : error;
        m_stuckLoops = 0;
        return;
    }
    if (++m_stuckLoops < stallLoops)
        return;
    m_stuckLoops = 0;
    m_leastError = 0;
    setOn(false);
    fault(code::motorStalled);
}

void Drive::watchEncoder()
{
    const std::int64_t now = position();
    if (m_dialect == Dialect::D3 || (now < overflow && now > underflow))
        return;
    setOn(false);
    fault(now >= overflow ? code::encoderOverflow : code::encoderUnderflow);
}

void Drive::measure()
{
    if (++m_sinceMeasure < measureLoops)
        return;
    const std::int64_t now = position();
    const double moved = static_cast<double>(now - m_measuredAt);
    const bool rest = std::abs(moved) <= restTicks && m_motor.speed() == 0.0;
    m_reported = rest ? 0 : static_cast<std::int32_t>(std::lround(moved * believedRate() / m_sinceMeasure));
    m_measuredAt = now;
    m_sinceMeasure = 0;
}

} // namespace mb::supermodified::simulation
