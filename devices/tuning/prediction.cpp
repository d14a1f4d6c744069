// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/prediction.h"

#include <algorithm>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr double restBefore = 0.05;   ///< s that the loop rests at `from`
constexpr double shownPeriod = 0.001; ///< s between the samples of the result

double leastMoveOf(Mode loop)
{
    return loop == Mode::Current ? 0.0 : 5.0;
}

} // namespace

Prediction predictStep(Mode loop, const PlantModel &plant, const ContinuousGains &gains, double from, double to,
    double seconds, const LoopShape &shape)
{
    Prediction result;
    result.shape = shape;
    SimulatedLoop simulated(loop, plant, gains, withoutClock(shape), from);
    double next = -restBefore;
    double peak = 0.0;
    const double end = std::min(seconds, longestPrediction);
    const auto passes = static_cast<long>(std::ceil((restBefore + end) / shape.period));
    for (long pass = 0; pass < passes; ++pass) {
        const double t = static_cast<double>(pass) * shape.period - restBefore;
        const double duty = simulated.pass(t < 0.0 ? from : to);
        peak = std::max(peak, std::abs(simulated.current()));
        if (t >= next - 1e-9) {
            result.measured.add(t, simulated.measured());
            result.duty.add(t, duty);
            next += shownPeriod;
        }
    }
    result.metrics = readResponse(result.measured, to, leastMoveOf(loop)).metrics;
    if (shape.windowCounts > 0.0)
        result.metrics.settle = settledWidely(result.measured, to);
    if (plant.stallCurrent > 0.0)
        result.metrics.peakCurrent = peak;
    return result;
}

Prediction predictStep(Mode loop, const PlantModel &plant, const ContinuousGains &gains, double from, double to,
    double seconds, double mostDuty, double period)
{
    LoopShape shape;
    shape.period = period;
    shape.mostDuty = mostDuty;
    return predictStep(loop, plant, gains, from, to, seconds, shape);
}

void sumOver(Prediction &prediction, Mode loop, double to, double seconds)
{
    const Metrics metrics = readResponse(prediction.measured.part(-restBefore, seconds), to, leastMoveOf(loop)).metrics;
    prediction.metrics.iae = metrics.iae;
    prediction.metrics.itae = metrics.itae;
}

} // namespace mb::tuning
