// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/plateau.h"

#include "experiment/envelope.h"
#include "experiment/figures.h"
#include "experiment/localfit.h"

#include <algorithm>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr std::size_t fewestOfPlateau = 10; ///< samples
constexpr double mostSwing = 0.04;          ///< of the step, beyond what counts alone make
constexpr double mostSwingOfEdges = 0.015;  ///< of a velocity that is counted over edges: it shows a part of it
constexpr double latestRest = 0.75;         ///< of a hold
constexpr double shareOfPredicted = 1.25;   ///< that may be more in one run than in another

double deviationOf(const Trace &trace)
{
    if (trace.size() < fewestOfPlateau)
        return 0.0;
    const Line line = fitLine(trace.t, trace.y);
    double sum = 0.0;
    for (std::size_t i = 0; i < trace.size(); ++i) {
        const double off = trace.y[i] - line.at(trace.t[i]);
        sum += off * off;
    }
    return std::sqrt(sum / static_cast<double>(trace.size()));
}

/// Of what comes `seconds` after the edge: the second half, or where it settles later what is left then, a quarter at least.
double swingAtRest(const Trace &response, double target, double seconds)
{
    const double settled = settledWidely(response, target).value_or(0.0);
    const double from = std::clamp(settled, 0.5 * seconds, latestRest * seconds);
    return deviationOf(response.part(from, seconds)) / std::abs(target);
}

} // namespace

std::optional<double> settledWidely(const std::vector<Trial> &trials)
{
    std::optional<double> worst;
    for (const Trial &trial : trials) {
        const Signal *const measured = trial.signal(measuredOf(trial.mode));
        for (const Span &hold : trial.holds) {
            const auto settled = measured
                ? settledWidely(measured->trace.part(hold.from, hold.to, hold.from), trial.stimulus.to)
                : std::nullopt;
            if (!settled)
                return std::nullopt;
            worst = std::max(worst.value_or(0.0), *settled);
        }
    }
    return worst;
}

double swingOf(const Trial &trial)
{
    const Signal *const measured = trial.signal(measuredOf(trial.mode));
    double worst = 0.0;
    for (const Span &hold : trial.holds) {
        if (measured)
            worst = std::max(worst,
                swingAtRest(
                    measured->trace.part(hold.from, hold.to, hold.from), trial.stimulus.to, hold.to - hold.from));
    }
    return worst;
}

double swingOf(const Prediction &predicted, double step)
{
    const Trace &measured = predicted.measured;
    return measured.isEmpty() ? 0.0 : swingAtRest(measured, step, measured.t.back());
}

Message judgePlace(const Trial &trial, double counts)
{
    return swingOf(trial) * std::abs(trial.stimulus.to) <= counts ? Message() : say("it did not settle");
}

Message judgeRest(double measured, const Prediction &prediction, double step)
{
    const double predicted = swingOf(prediction, step);
    const double most = prediction.shape.windowCounts > 0.0 ? mostSwingOfEdges : mostSwing;
    if (measured <= std::max(shareOfPredicted * predicted, std::hypot(predicted, most)))
        return {};
    return say("its speed goes on swinging by %1 where it should rest, whole counts alone would make %2",
        percentText(measured), percentText(predicted));
}

} // namespace mb::tuning
