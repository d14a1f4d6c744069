// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/uncertainty.h"

#include "tuning/currentsearch.h"

#include <algorithm>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr double smallestShare = 0.05; ///< of a delay or a lag that stays, however large its error is

double off(double value, double error)
{
    return std::max(value + error, smallestShare * value);
}

} // namespace

PlantErrors errorsOf(const TuneReport &report)
{
    if (!report.motor)
        return {};
    const MotorFound &motor = *report.motor;
    const PlantModel &now = report.plant;
    const auto with = [&](double error, double PlantModel::*number) {
        const bool isKnown = motor.plant.gain > 0.0;
        return isKnown ? std::max(error, std::abs(now.*number - motor.plant.*number)) : error;
    };
    PlantErrors errors{with(motor.line.gainError, &PlantModel::gain), with(motor.pushes.tauError, &PlantModel::tau),
        with(motor.pushes.delayError, &PlantModel::delay), with(motor.line.frictionError, &PlantModel::friction)};
    if (report.loop == Mode::Current) { // nobody pushes long enough to see its lag
        errors.tau
            = now.lagDoubt > 0.0 ? now.lagDoubt * now.tau : std::max(longestLag - now.tau, now.tau - shortestLag);
        errors.leastTau = now.lagDoubt > 0.0 ? 0.0 : shortestLag;
    }
    return errors;
}

PredictionBand bandOf(const Prediction &predicted, Mode loop, const PlantModel &plant, const PlantErrors &errors,
    const ContinuousGains &gains, double to, double mostDuty, double period)
{
    LoopShape shape = predicted.shape;
    shape.mostDuty = mostDuty;
    shape.period = period;
    PredictionBand band{predicted.measured, predicted.measured};
    const double seconds = predicted.measured.isEmpty() ? 0.0 : predicted.measured.t.back() + period;
    for (int corner = 0; corner < 8; ++corner) {
        const auto sign = [corner](int bit) { return (corner >> bit & 1) != 0 ? 1.0 : -1.0; };
        PlantModel other = plant;
        other.gain = off(plant.gain, sign(0) * errors.gain);
        other.tau = std::max(off(plant.tau, sign(1) * errors.tau), errors.leastTau);
        other.delay = off(plant.delay, sign(2) * errors.delay);
        const Trace moved = predictStep(loop, other, gains, 0.0, to, seconds, shape).measured;
        for (std::size_t i = 0; i < std::min(moved.size(), band.low.size()); ++i) {
            band.low.y[i] = std::min(band.low.y[i], moved.y[i]);
            band.high.y[i] = std::max(band.high.y[i], moved.y[i]);
        }
    }
    return band;
}

} // namespace mb::tuning
