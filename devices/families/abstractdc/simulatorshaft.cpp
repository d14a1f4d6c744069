// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/simulatorshaft.h"

#include <algorithm>
#include <cmath>

namespace mb::abstractdc::simulation {
namespace {

using namespace std::chrono_literals;

constexpr Duration physicsStep = 100us;
constexpr double leastCurrent = 1e-3;
constexpr int awakeSteps = 50;

} // namespace

Shaft::Shaft(Clock &clock, const UnitOptions &options, Notify notify)
    : m_clock(clock)
    , m_notify(std::move(notify))
    , m_motor(*options.motor, options.load)
    , m_motorAt(clock.now())
{
    m_motor.setEncoderReversed(options.find(FaultKind::EncoderReversed) != nullptr);
}

void Shaft::zero()
{
    advance();
    m_origin = m_motor.counts();
}

void Shaft::drive(int pwm)
{
    const bool was = isOutputOn();
    m_pwm = pwm;
    if (pwm != 0)
        m_awakeSteps = awakeSteps;
    if (was != isOutputOn())
        m_notify(m_clock.now(), isOutputOn() ? "output-on" : "output-off", static_cast<double>(pwm));
}

/// The motor turns up to now with what the bridge has been set to. A standing one is left alone.
void Shaft::advance()
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

std::int32_t Shaft::encoder() const
{
    const std::int64_t wraps = (counts() >= 0 ? counts() : counts() - 65535) / 65536;
    return static_cast<std::int32_t>(counts() - wraps);
}

bool Shaft::disturb(std::string_view what, double value)
{
    advance();
    m_awakeSteps = awakeSteps;
    return m_motor.disturb(what, value);
}

} // namespace mb::abstractdc::simulation
