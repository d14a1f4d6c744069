// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/simulatedloop.h"

#include "tuning/pushfit.h"

#include <algorithm>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr double patienceForCounts = 0.671; ///< s, that a window of counts waits for them
constexpr double breakawayShare = 1.2;      ///< of a motor's own friction, where no gear loses torque
constexpr double helpBeyondFriction = 0.99; ///< of the help, which is written so that it moves the motor
/// Passes of the plant's delay that are not waited for: half of one is what an output held from pass to pass is late already, and one
/// is counted for a loop that may put out in the next pass what it has measured in this one, which these do at once.
constexpr double promptPasses = 1.5;

constexpr double shortShare = 0.2; ///< of a lag, in which e^−x is a fraction to 1e-7

/// Of a speed, after so many lags.
inline double keptAfter(double lags)
{
    const double square = lags * lags / 12.0;
    return lags < shortShare ? (1.0 - 0.5 * lags + square) / (1.0 + 0.5 * lags + square) : std::exp(-lags);
}

double wholeSteps(double value, double step)
{
    return step > 0.0 ? std::trunc(value / step) * step : value;
}

std::size_t passesOf(double seconds, double period)
{
    return static_cast<std::size_t>(std::lround(std::max(seconds, 0.0) / period));
}

/// Duty that a motor at rest does not follow. Friction is known as it is while the motor moves, when a gear loses torque as well; one at rest
/// loses none. The device's help overcomes it also where friction is doubted: an output that is held back is not what was measured. A velocity
/// that is counted over edges hides what a shaft does within its play: there the motor is taken for one that lets go late.
double heldBelow(const PlantModel &plant, const LoopShape &shape)
{
    const double own = 2.0 / (1.0 + plant.braking); // of the friction while it moves
    const double held = shape.windowCounts > 0.0 ? breakawayShare : std::max(1.0, breakawayShare * own);
    return shape.leastOutput > 0.0 ? std::min(breakawayShare * plant.friction, helpBeyondFriction * shape.leastOutput)
                                   : held * plant.friction;
}

double dutyAt(const PlantModel &plant, const ContinuousGains &gains, double value)
{
    if (value == 0.0)
        return 0.0;
    return value / plant.gain + (value > 0.0 ? plant.friction : -plant.friction) - gains.f * value;
}

} // namespace

SimulatedLoop::SimulatedLoop(
    Mode loop, const PlantModel &plant, const ContinuousGains &gains, const LoopShape &shape, double from)
    : m_integrates(loop == Mode::Position)
    , m_plant(plant)
    , m_gains(gains)
    , m_shape(shape)
    , m_kept(std::exp(-shape.period / plant.tau))
    , m_braked(std::exp(-shape.period * plant.braking / plant.tau))
    , m_current(shape.winding, shape.period)
    , m_held(heldBelow(plant, shape))
    , m_speed(m_integrates ? 0.0 : from)
    , m_place(m_integrates ? from : shape.phase)
    , m_measured(from)
    , m_setPoint(from)
    , m_time(shape.phase * shape.clock)
    , m_elapsed(shape.period)
    , m_integral(m_integrates ? 0.0 : dutyAt(plant, gains, from))
{
    if (loop == Mode::Velocity && shape.window > 0.0)
        m_span = std::max<std::size_t>(
            1, passesOf(shape.windowCounts > 0.0 ? patienceForCounts : shape.window, shape.period));
    m_lag = passesOf(
        plant.delay - shape.winding - (isWindowed() ? 0.5 * shape.window : 0.0) - promptPasses * shape.period,
        shape.period);
    const double before = static_cast<double>(m_lag + m_span);
    for (std::size_t i = 0; i < m_lag + m_span; ++i) {
        const double ago = before - static_cast<double>(i);
        m_late.push_back(isWindowed() ? m_place - from * ago * shape.period : from);
    }
}

void SimulatedLoop::turnInto(const PlantModel &plant)
{
    m_plant = plant;
    m_kept = std::exp(-m_shape.period / plant.tau);
    m_braked = std::exp(-m_shape.period * plant.braking / plant.tau);
    m_held = heldBelow(plant, m_shape);
}

/// A clock of whole milliseconds takes a pass of 20.04 ms for 20, and each 25th for 21.
void SimulatedLoop::lookAtClock()
{
    if (m_shape.clock <= 0.0)
        return;
    const double before = std::floor(m_time / m_shape.clock);
    m_time += m_shape.period;
    m_elapsed = std::max(std::floor(m_time / m_shape.clock) - before, 1.0) * m_shape.clock;
}

double SimulatedLoop::measure()
{
    if (!isWindowed()) {
        m_late.push_back(value());
        const double seen = m_late.front();
        m_late.pop_front();
        return m_integrates && m_shape.isCounted ? std::floor(seen) : seen;
    }
    m_late.push_back(m_shape.isCounted ? std::floor(m_place) : m_place);
    if (m_shape.windowCounts > 0.0)
        return measureByCounts();
    const double past = static_cast<double>(m_span - 1) * m_shape.period + m_elapsed;
    const double seen = (m_late[m_span] - m_late.front()) / past;
    m_late.pop_front();
    return m_shape.clock > 0.0 ? std::trunc(seen) : seen; // a division of whole numbers
}

/// Over the shortest time in which it went so far.
double SimulatedLoop::measureByCounts()
{
    std::size_t newest = m_late.size() - 1 - m_lag;
    const auto isLong
        = [&] { return std::abs(m_late[newest] - m_late[1]) >= m_shape.windowCounts || newest - 1 >= m_span; };
    for (; newest > 1 && isLong(); --newest)
        m_late.pop_front();
    return (m_late[newest] - m_late.front()) / (static_cast<double>(newest) * m_shape.period);
}

double SimulatedLoop::output(double target, double measured)
{
    const double error = target - measured;
    const double slope = (error - m_lastError) / m_elapsed;
    m_lastError = error;
    if (m_shape.goodEnough > 0.0 && std::abs(error) < m_shape.goodEnough) {
        m_integral = 0.0;
        return m_gains.f * target;
    }
    m_integral += wholeSteps(m_gains.i * error * m_elapsed, m_shape.integralStep);
    if (m_shape.integralMost > 0.0)
        m_integral = std::clamp(m_integral, -m_shape.integralMost, m_shape.integralMost);
    const double now = wholeSteps(m_gains.p * error + m_gains.d * slope, m_shape.outputStep);
    double duty = now + m_gains.f * target + m_integral;
    if (duty != 0.0 && std::abs(duty) < m_shape.leastOutput)
        duty = std::copysign(m_shape.leastOutput, duty);
    return std::clamp(duty, -m_shape.mostDuty, m_shape.mostDuty);
}

/// Exact for constant duty, as long as it goes one way; what is left of the time after a turn is yielded.
double SimulatedLoop::advance(double duty, double seconds)
{
    const double push = std::abs(duty);
    if (m_speed == 0.0 && push <= m_held)
        return 0.0;
    const double sign = m_speed != 0.0 ? std::copysign(1.0, m_speed) : std::copysign(1.0, duty);
    const bool brakes = (m_plant.gain * duty - m_speed) * sign < 0.0;
    const double stronger = brakes ? m_plant.braking : 1.0;
    const double longer = m_plant.sag == 0.0 ? 1.0 : sagged(m_plant.sag, duty);
    const double tau = m_plant.tau * longer / stronger;
    const double ends = m_plant.gain * (duty - sign * m_plant.friction / stronger);
    const bool isKnown = m_plant.sag == 0.0 && seconds == m_shape.period;
    double kept = isKnown ? (brakes ? m_braked : m_kept) : keptAfter(seconds / tau);
    double left = 0.0;
    if (m_speed * (ends + (m_speed - ends) * kept) < 0.0) {
        kept = ends / (ends - m_speed); // it stands
        left = seconds + tau * std::log(kept);
    }
    m_place += ends * (seconds - left) + (m_speed - ends) * tau * (1.0 - kept);
    m_speed = left > 0.0 ? 0.0 : ends + (m_speed - ends) * kept;
    return left;
}

void SimulatedLoop::turn(double output)
{
    m_duty = output;
    const double duty = m_current.follow(output);
    const double left = advance(duty, m_shape.period);
    if (left > 0.0 && std::abs(duty) > m_plant.friction)
        (void)advance(duty, left);
}

/// The device's own profile, which accelerates within a few passes.
double SimulatedLoop::follow(double target)
{
    if (m_shape.setPointRate <= 0.0)
        return target;
    const double most = m_shape.setPointRate * m_shape.period;
    m_setPoint += std::clamp(target - m_setPoint, -most, most);
    return m_shape.isCounted ? std::round(m_setPoint) : m_setPoint;
}

double SimulatedLoop::pass(double target)
{
    lookAtClock();
    m_measured = measure();
    const double duty = output(follow(target), m_measured);
    turn(duty);
    return duty;
}

} // namespace mb::tuning
