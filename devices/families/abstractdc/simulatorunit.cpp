// SPDX-License-Identifier: GPL-3.0-or-later
// Power, faults, and the motor.
#include "families/abstractdc/simulatorunit.h"

#include <algorithm>
#include <cmath>

namespace mb::abstractdc::simulation {
namespace {

using namespace std::chrono_literals;

constexpr Duration physicsStep = 100us;
constexpr Duration powerBack = 200ms;
constexpr double brownoutVolts = 5.0;
constexpr double brownoutSeconds = 6.0;
constexpr double leastCurrent = 1e-3;
constexpr int awakeSteps = 50;

Duration fromSeconds(double seconds)
{
    return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds));
}

} // namespace

Unit::Unit(CanLink &link, Clock &clock, const UnitOptions &options, Notify notify)
    : m_link(link)
    , m_clock(clock)
    , m_options(options)
    , m_notify(std::move(notify))
    , m_dialect(*options.dialect)
    , m_motor(*options.motor, options.load)
    , m_motorAt(clock.now())
    , m_cycle(clock)
    , m_restart(clock)
    , m_received(link.received().add([this](const CanFrame &frame) { hear(frame); }))
{
    const auto stored = storedGains(options);
    for (int page = 0; options.gains != StoredGains::Default && page < 3; ++page)
        m_flash.save(page, stored.at(static_cast<std::size_t>(page)));
    m_motor.setEncoderReversed(options.find("encoder-reversed") != nullptr);
    start();
    scheduleFaults();
}

void Unit::start()
{
    advance();
    m_powered = true;
    m_startedAt = m_clock.now();
    m_origin = m_motor.counts();
    m_mode = Loop::None;
    m_target = 0;
    for (std::size_t page = 0; page < m_gains.size(); ++page)
        m_gains.at(page) = m_flash.load(static_cast<int>(page));
    m_pids = {};
    m_output = 0;
    m_velocity = 0;
    m_velocityFrom = 0;
    m_velocityTime = 0;
    m_current = {};
    m_overrunTold = false;
    m_cycle.startIn(loopPeriod, [this] { cycle(); });
    m_notify(m_startedAt, "power-on", 0.0);
}

void Unit::stop()
{
    advance();
    m_powered = false;
    m_cycle.stop();
    m_replies.clear();
    m_pending = 0;
    drive(0);
}

void Unit::setPowered(bool powered)
{
    m_restart.stop();
    if (powered == m_powered)
        return;
    if (powered) {
        start();
        return;
    }
    stop();
    m_notify(m_clock.now(), "power-lost", 0.0);
}

void Unit::losePower()
{
    setPowered(false);
    m_restart.startIn(powerBack, [this] { setPowered(true); });
}

void Unit::at(double seconds, std::function<void()> work)
{
    m_timers.emplace_back(m_clock).startIn(fromSeconds(seconds), std::move(work));
}

void Unit::scheduleFaults()
{
    for (const SimulatedFault &fault : m_options.faults) {
        if (fault.kind == "reset")
            at(fault.at, [this] {
                stop();
                m_notify(m_clock.now(), "reset", 0.0);
                start();
            });
        else if (fault.kind == "encoder-dead")
            at(fault.at, [this] { m_motor.setEncoderDead(true); });
        else if (fault.kind == "stall")
            at(fault.at, [this] { (void)disturb("stall", 1.0); });
        else if (fault.kind == "brownout") {
            at(fault.at, [this] { (void)disturb("bus-voltage", brownoutVolts); });
            at(fault.at + brownoutSeconds, [this] { (void)disturb("bus-voltage", MotorSupply().voltage); });
        }
    }
}

double Unit::speed()
{
    advance();
    return m_motor.countSpeed();
}

double Unit::position()
{
    advance();
    return m_motor.countPosition();
}

bool Unit::disturb(std::string_view what, double value)
{
    advance();
    m_awakeSteps = awakeSteps;
    if (what != "glitch")
        return m_motor.disturb(what, value);
    m_glitchNext = true;
    return true;
}

/// The motor turns up to now with what the bridge has been set to. A standing one is left alone.
void Unit::advance()
{
    const Instant now = m_clock.now();
    while (m_motorAt < now) {
        const bool rests
            = m_pwm == 0 && m_awakeSteps == 0 && m_motor.isStuck() && std::abs(m_motor.current()) < leastCurrent;
        if (rests) {
            m_motorAt = now;
            return;
        }
        m_awakeSteps = std::max(0, m_awakeSteps - 1);
        const Duration step = std::min<Duration>(physicsStep, now - m_motorAt);
        const double duty = static_cast<double>(m_pwm) / fullPwm;
        m_motor.step(duty, m_pwm == 0 ? Bridge::Brake : Bridge::Drive, std::chrono::duration<double>(step).count());
        m_motorAt += step;
    }
}

void Unit::drive(int pwm)
{
    const bool was = isOutputOn();
    m_pwm = pwm;
    if (pwm != 0)
        m_awakeSteps = awakeSteps;
    if (was != isOutputOn())
        m_notify(m_clock.now(), isOutputOn() ? "output-on" : "output-off", static_cast<double>(pwm));
}

/// README.md#position: a wrap of the 16-bit timer is counted as 65 535.
std::int32_t Unit::encoder() const
{
    const std::int64_t counts = m_motor.counts() - m_origin;
    const std::int64_t wraps = (counts >= 0 ? counts : counts - 65535) / 65536;
    return static_cast<std::int32_t>(counts - wraps);
}

std::int64_t Unit::milliseconds() const
{
    return (m_clock.now() - m_startedAt) / 1ms;
}

} // namespace mb::abstractdc::simulation
