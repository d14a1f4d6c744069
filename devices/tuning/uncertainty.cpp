// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/uncertainty.h"

#include <algorithm>

namespace mb::tuning {
namespace {

constexpr double smallestShare = 0.05; ///< of a delay or a lag that stays, however large its error is

double off(double value, double error)
{
    return std::max(value + error, smallestShare * value);
}

} // namespace

PlantErrors errorsOf(const std::optional<MotorFound> &motor)
{
    return motor ? PlantErrors{motor->line.gainError, motor->pushes.tauError, motor->pushes.delayError} : PlantErrors();
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
        other.tau = off(plant.tau, sign(1) * errors.tau);
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
