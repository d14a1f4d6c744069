// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/prediction.h"

#include <algorithm>
#include <cmath>
#include <deque>

namespace mb::tuning {
namespace {

constexpr double restBefore = 0.05;   ///< s that the loop rests at `from`
constexpr double shownPeriod = 0.001; ///< s between the samples of the result
constexpr double leastShownMove = 5.0;

/// The motor of a model: exact for constant duty.
class Motor {
public:
    Motor(Mode loop, const PlantModel &plant, double value)
        : m_integrates(loop == Mode::Position)
        , m_plant(plant)
        , m_speed(m_integrates ? 0.0 : value)
        , m_place(m_integrates ? value : 0.0)
    {
    }
    [[nodiscard]] double value() const { return m_integrates ? m_place : m_speed; }
    void step(double duty, double seconds)
    {
        const double push = std::abs(duty);
        const bool stuck = m_speed == 0.0 && push <= m_plant.friction;
        const double sign = m_speed != 0.0 ? (m_speed > 0.0 ? 1.0 : -1.0) : (duty > 0.0 ? 1.0 : -1.0);
        const double ends = stuck ? 0.0 : m_plant.gain * (duty - sign * m_plant.friction);
        const double kept = std::exp(-seconds / m_plant.tau);
        const double next = ends + (m_speed - ends) * kept;
        m_place += ends * seconds + (m_speed - ends) * m_plant.tau * (1.0 - kept);
        m_speed = m_speed * next < 0.0 && push <= m_plant.friction ? 0.0 : next;
    }

private:
    bool m_integrates;
    PlantModel m_plant;
    double m_speed;
    double m_place;
};

/// The device's loop: an integral that waits while the output is at its end.
class Controller {
public:
    Controller(const ContinuousGains &gains, double mostDuty, double period)
        : m_gains(gains)
        , m_most(mostDuty)
        , m_period(period)
    {
    }
    void rest(double duty) { m_integral = duty; }
    double output(double target, double measured)
    {
        const double error = target - measured;
        const double slope = (error - m_lastError) / m_period;
        m_lastError = error;
        const double next = m_integral + m_gains.i * error * m_period;
        const double rest = m_gains.p * error + m_gains.d * slope + m_gains.f * target;
        const double wanted = rest + next;
        const bool winds = (wanted > m_most && error > 0.0) || (wanted < -m_most && error < 0.0);
        if (!winds)
            m_integral = next;
        return std::clamp(rest + m_integral, -m_most, m_most);
    }

private:
    ContinuousGains m_gains;
    double m_most;
    double m_period;
    double m_integral = 0.0;
    double m_lastError = 0.0; ///< it begins at rest
};

double dutyAt(Mode loop, const PlantModel &plant, const ContinuousGains &gains, double value)
{
    if (loop == Mode::Position || value == 0.0)
        return 0.0;
    return value / plant.gain + (value > 0.0 ? plant.friction : -plant.friction) - gains.f * value;
}

} // namespace

Prediction predictStep(Mode loop, const PlantModel &plant, const ContinuousGains &gains, double from, double to,
    double seconds, double mostDuty, double period)
{
    Prediction result;
    Motor motor(loop, plant, from);
    Controller controller(gains, mostDuty, period);
    controller.rest(dutyAt(loop, plant, gains, from));
    std::deque<double> late(static_cast<std::size_t>(std::lround(plant.delay / period)), from);
    double next = -restBefore;
    for (double t = -restBefore; t < seconds; t += period) {
        late.push_back(motor.value());
        const double measured = late.front();
        late.pop_front();
        const double duty = controller.output(t < 0.0 ? from : to, measured);
        if (t >= next - 1e-9) {
            result.measured.add(t, measured);
            result.duty.add(t, duty);
            next += shownPeriod;
        }
        motor.step(duty, period);
    }
    result.metrics = readResponse(result.measured, to, loop == Mode::Current ? 0.0 : leastShownMove).metrics;
    return result;
}

} // namespace mb::tuning
