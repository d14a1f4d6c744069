// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/stepcomparison.h"

#include "experiment/envelope.h"
#include "experiment/equivalenttime.h"
#include "experiment/figures.h"
#include "experiment/verdict.h"
#include "tuning/gainsearch.h"
#include "tuning/leastsquares.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mb::tuning {
namespace {

constexpr double clearly = 2.0;       ///< standard deviations, by which noise alone may tell two currents apart
constexpr double laterIsLonger = 0.2; ///< of the time since an edge, over which a current is taken
constexpr double restFrom = 0.75;     ///< of a step
constexpr double wholeHold = 10.0;    ///< s

/// The shortest hold of all steps, s.
double shortestHold(const std::vector<Trial> &proof, double shortest)
{
    for (const Trial &trial : proof) {
        for (const Span &hold : trial.holds)
            shortest = std::min(shortest, hold.to - hold.from);
    }
    return shortest;
}

/// Those of a trial, seconds since the edge of each.
std::vector<Trace> heldStepsOf(const Trial &trial, double seconds)
{
    const Signal *const measured = trial.signal(measuredOf(trial.mode));
    std::vector<Trace> steps;
    for (std::size_t i = 0; measured && i < trial.holds.size(); ++i) {
        const double from = trial.holds[i].from;
        steps.push_back(measured->trace.part(from, from + seconds, from));
    }
    return steps;
}

/// How steps are compared.
struct Look {
    double seconds = 0.0; ///< of each
    bool isExact = true;  ///< what the integral adds: it brings a velocity to its target
};

/// What nobody asks to be mended of a position, and cannot be told of a velocity that comes to its target: less than half a step of its
/// reading. Currents are means of many steps.
double nearOf(const Trial &trial, const Trace &step, bool isExact)
{
    if (trial.mode == Mode::Velocity && isExact)
        return 0.5 * resolutionOf(step);
    return trial.mode == Mode::Position ? nearTarget : 0.0;
}

/// s², integral of time times error over the step, of one of them; but of a current, with the error that it rests with, for as long again;
/// of a position and a velocity beyond what is near enough.
double errorOfStep(const Trial &trial, const Trace &step, const Look &look)
{
    const double way = std::abs(trial.stimulus.to - trial.stimulus.from);
    const double near = nearOf(trial, step, look.isExact) / way;
    double sum = 0.0;
    LeastSquares<1> rest;
    for (std::size_t k = 1; k < step.size(); ++k) {
        const double error = (trial.stimulus.to - step.y[k]) / way;
        sum += step.t[k] * std::max(std::abs(error) - near, 0.0) * (step.t[k] - step.t[k - 1]);
        if (step.t[k] > restFrom * look.seconds && trial.mode != Mode::Current)
            rest.add({1.0}, error);
    }
    if (const auto mean = rest.solve())
        sum += std::max(std::abs(mean->values[0]) - near, 0.0) * 1.5 * look.seconds * look.seconds;
    return sum;
}

/// That of what was measured in the first `seconds` of each step; of a current of the mean of all steps of a trial, over ever longer times,
/// for one sample is mostly noise, and what is late is slow. Noise adds to it, the same to all steps of a loop.
double errorOf(const std::vector<Trial> &proof, const Look &look)
{
    double sum = 0.0;
    std::size_t count = 0;
    for (const Trial &trial : proof) {
        std::vector<Trace> steps = heldStepsOf(trial, look.seconds);
        if (trial.mode == Mode::Current && !steps.empty())
            steps = {meanOf(steps, samplePeriod(steps.front()), laterIsLonger)};
        for (const Trace &step : steps)
            sum += errorOfStep(trial, step, look);
        count += steps.size();
    }
    return count > 0 ? sum / static_cast<double>(count) : std::numeric_limits<double>::infinity();
}

/// Standard error of that of a current, as its steps differ; of other loops nothing is forgiven.
double doubtOfError(const std::vector<Trial> &proof, const Look &look)
{
    double squares = 0.0;
    for (const Trial &trial : proof) {
        double sum = 0.0;
        double sumOfSquares = 0.0;
        const std::vector<Trace> steps = heldStepsOf(trial, look.seconds);
        const auto count = static_cast<double>(steps.size());
        if (trial.mode != Mode::Current || count < 2.0)
            return 0.0;
        for (const Trace &step : steps) {
            const double error = errorOfStep(trial, step, look);
            sum += error;
            sumOfSquares += error * error;
        }
        squares += std::max(sumOfSquares - sum * sum / count, 0.0) / (count - 1.0) / count;
    }
    return proof.empty() ? 0.0 : std::sqrt(squares) / static_cast<double>(proof.size());
}

/// Over what both have, as this loop is.
Look lookAt(const std::vector<Trial> &now, const std::vector<Trial> &before, const LoopShape &shape)
{
    return {shortestHold(now, shortestHold(before, wholeHold)), shape.integralStep == 0.0};
}

} // namespace

double errorRatio(const std::vector<Trial> &now, const std::vector<Trial> &before, const LoopShape &shape)
{
    const Look look = lookAt(now, before, shape);
    return errorOf(now, look) / errorOf(before, look);
}

bool isBetter(const std::vector<Trial> &now, const std::vector<Trial> &before, const LoopShape &shape, double times)
{
    const Look look = lookAt(now, before, shape);
    const double doubt = std::hypot(doubtOfError(now, look), doubtOfError(before, look));
    return errorOf(now, look) < times * errorOf(before, look) + clearly * doubt;
}

} // namespace mb::tuning
