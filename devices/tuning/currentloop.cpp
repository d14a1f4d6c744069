// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/currentloop.h"

#include <algorithm>
#include <cmath>

namespace mb::tuning {

CurrentLoop::CurrentLoop(const PlantModel &plant, const ContinuousGains &gains, const LoopShape &shape, int parts)
    : m_plant(plant)
    , m_gains(gains)
    , m_shape(shape)
    , m_part(shape.period / parts)
    , m_kept(std::exp(-m_part / plant.tau))
{
}

void CurrentLoop::look(double target)
{
    const double reading = m_plant.reading;
    const double error = target - (reading > 0.0 ? std::round(m_current / reading) * reading : m_current);
    m_integral += m_gains.i * error * m_shape.period;
    double duty = m_gains.p * error + m_integral;
    if (m_shape.outputStep > 0.0)
        duty = std::floor(duty / m_shape.outputStep) * m_shape.outputStep;
    m_duty = std::clamp(duty, -m_shape.mostDuty, m_shape.mostDuty);
}

void CurrentLoop::turn()
{
    const double ends = m_plant.gain * (m_duty - m_plant.backDuty * m_speed);
    const double before = m_current;
    m_current = ends + (m_current - ends) * m_kept;
    const double drives = 0.5 * (before + m_current) - m_plant.idle; // it stands until friction is overcome
    m_speed = std::max(m_speed + m_plant.pickUp * drives * m_part, 0.0);
}

std::vector<double> currentResponse(const PlantModel &plant, const ContinuousGains &gains, const LoopShape &shape,
    double step, double seconds, int parts)
{
    CurrentLoop loop(plant, gains, shape, parts);
    std::vector<double> response;
    for (double t = 0.0; t < seconds; t += shape.period) {
        loop.look(step);
        for (int part = 0; part < parts; ++part) {
            loop.turn();
            response.push_back(loop.value());
        }
    }
    return response;
}

CurrentError errorOfCurrent(const PlantModel &plant, const ContinuousGains &gains, const LoopShape &shape, double step,
    double seconds, double most)
{
    CurrentLoop loop(plant, gains, shape);
    CurrentError error;
    for (double t = shape.period; t <= seconds && error.itae < most; t += shape.period) {
        loop.look(step);
        loop.turn();
        const double value = loop.value() / step;
        error.itae += t * std::abs(1.0 - value) * shape.period;
        error.overshoot = std::max(error.overshoot, value - 1.0);
    }
    return error;
}

} // namespace mb::tuning
