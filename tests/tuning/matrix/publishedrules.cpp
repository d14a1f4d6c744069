// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/tuning/matrix/publishedrules.h"

#include "tuning/leastsquares.h"
#include "tuning/margins.h"

#include <cmath>
#include <numbers>

namespace mb::test {
namespace {

using tuning::ContinuousGains;

ContinuousGains parallel(double p, double integralTime, double derivativeTime)
{
    return {p, p / integralTime, p * derivativeTime, 0.0};
}

/// Rows of dv/dt = a·v + b·duty + c·sgn(v).
void addRows(const tuning::Trace &position, double duty, tuning::LeastSquares<3> &fit)
{
    const auto speed = [&position](std::size_t i) {
        return (position.y[i + 1] - position.y[i - 1]) / (position.t[i + 1] - position.t[i - 1]);
    };
    for (std::size_t i = 1; i + 2 < position.size(); ++i) {
        const double v = speed(i);
        const double step = position.t[i + 1] - position.t[i];
        if (v != 0.0 && step > 0.0)
            fit.add({v, duty, v > 0.0 ? 1.0 : -1.0}, (speed(i + 1) - v) / step);
    }
}

} // namespace

Ultimate ultimateOf(Mode loop, const tuning::PlantModel &plant)
{
    const double lost = loop == Mode::Position ? std::numbers::pi / 2.0 : 0.0;
    double low = 1e-3;
    double high = 1e6;
    for (int i = 0; i < 200; ++i) {
        const double omega = std::sqrt(low * high);
        const double phase = lost + std::atan(omega * plant.tau) + omega * plant.delay;
        (phase < std::numbers::pi ? low : high) = omega;
    }
    const double size = std::abs(tuning::openLoop(loop, plant, {1.0, 0.0, 0.0, 0.0}, low));
    return {1.0 / size, 2.0 * std::numbers::pi / low};
}

ContinuousGains zieglerNichols(Mode loop, const Ultimate &u)
{
    if (loop == Mode::Position)
        return parallel(0.6 * u.gain, u.period / 2.0, u.period / 8.0);
    return parallel(0.45 * u.gain, u.period / 1.2, 0.0);
}

ContinuousGains tyreusLuyben(Mode loop, const Ultimate &u)
{
    if (loop == Mode::Position)
        return parallel(u.gain / 2.2, 2.2 * u.period, u.period / 6.3);
    return parallel(u.gain / 3.2, 2.2 * u.period, 0.0);
}

std::optional<tuning::PlantModel> regressed(const std::vector<tuning::Trial> &trials, const tuning::PlantModel &known)
{
    tuning::LeastSquares<3> fit;
    for (const tuning::Trial &trial : trials) {
        const tuning::Signal *const position = trial.signal("position");
        if (trial.mode != Mode::Duty || !position)
            continue;
        for (const tuning::Span &hold : trial.holds)
            addRows(position->trace.part(hold.from, hold.to), trial.stimulus.to, fit);
    }
    const auto solution = fit.solve();
    if (!solution || solution->values[0] >= 0.0 || solution->values[1] <= 0.0)
        return std::nullopt;
    tuning::PlantModel plant = known;
    plant.tau = -1.0 / solution->values[0];
    plant.gain = solution->values[1] * plant.tau;
    return plant;
}

} // namespace mb::test
