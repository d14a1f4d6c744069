// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/simulatordrive.h"

#include <cmath>

namespace mb::supermodified::simulation {
namespace {

constexpr Duration loopPeriod = std::chrono::microseconds(1024);
constexpr double loopSeconds = 1.0 / loopsPerSecond;
constexpr int measureLoops = 98; ///< 10 Hz
constexpr std::int64_t counterOverflow = 0x7FFFFC00;
constexpr std::int64_t counterUnderflow = -0x7FFFFC00;
constexpr int restTicks = 1;
constexpr Duration encoderTime = std::chrono::nanoseconds(25'600); ///< of one transfer over SPI

} // namespace

Drive::Drive(Dialect dialect, const MotorParameters &motor, double load, std::uint64_t seed)
    : m_dialect(dialect)
    , m_encoder(dialect, motor, load, seed)
    , m_profile(dialect, m_settings)
    , m_control(dialect, m_settings)
{
}

void Drive::restart(const LoopSettings &settings, Instant now)
{
    m_settings = settings;
    m_control.restart();
    m_next = now + loopPeriod;
    zero();
    m_measuredAt = 0;
    m_sinceMeasure = 0;
    m_reported = 0;
    hold(0);
    setOn(false);
}

void Drive::hold(std::int64_t position)
{
    m_profile.hold(position);
    m_control.hold();
}

void Drive::setOn(bool on)
{
    m_duty = 0.0;
    m_control.clear();
    if (std::exchange(m_on, on) != on && switched)
        switched(on);
}

/// The counter jumps, which is no motion.
void Drive::zero()
{
    m_measuredAt -= position();
    m_zero = m_encoder.ticks();
}

void Drive::start()
{
    zero();
    hold(0);
    setOn(true);
}

void Drive::halt()
{
    hold(position());
}

void Drive::resetPosition()
{
    zero();
    if (m_dialect == Dialect::D3)
        hold(0);
}

void Drive::moveTo(std::int64_t position, bool profiled)
{
    if (profiled)
        m_profile.moveTo(position);
    else
        hold(position);
}

bool Drive::isAboutToLoop(Instant now) const
{
    return m_on && m_next - now <= encoderTime;
}

void Drive::advance(Instant now)
{
    if (isResting() && m_next <= now) { // nothing changes until somebody asks
        const auto loops = (now - m_next) / loopPeriod;
        m_next += loops * loopPeriod;
    }
    while (m_next <= now) {
        m_encoder.motor().step(m_duty, m_on ? Bridge::Drive : Bridge::Coast, loopSeconds);
        m_next += loopPeriod;
        loop();
    }
}

void Drive::loop()
{
    measure();
    if (!m_on)
        return;
    m_profile.step();
    m_duty = m_control.step(position() - setPoint());
    if (m_control.takeStall()) {
        setOn(false);
        fault(code::motorStalled);
    }
    watchEncoder();
}

void Drive::watchEncoder()
{
    const std::int64_t now = position();
    if (m_dialect == Dialect::D3 || (now < counterOverflow && now > counterUnderflow))
        return;
    setOn(false);
    fault(now >= counterOverflow ? code::encoderOverflow : code::encoderUnderflow);
}

void Drive::measure()
{
    if (++m_sinceMeasure < measureLoops)
        return;
    const std::int64_t now = position();
    const double moved = static_cast<double>(now - m_measuredAt);
    const bool rest = std::abs(moved) <= restTicks && m_encoder.motor().speed() == 0.0;
    m_reported = rest ? 0 : static_cast<std::int32_t>(std::lround(moved * believedRate(m_dialect) / m_sinceMeasure));
    m_measuredAt = now;
    m_sinceMeasure = 0;
}

} // namespace mb::supermodified::simulation
