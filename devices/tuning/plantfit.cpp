// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/plantfit.h"

#include "tuning/leastsquares.h"
#include "tuning/localfit.h"

#include <algorithm>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr std::size_t leastRampSamples = 8;
constexpr std::size_t mostRampSamples = 400; ///< of a ramp; more tell nothing new
constexpr double leastRampMove = 50.0;       ///< counts
constexpr double startedShare = 0.1;         ///< of the last speed: a ramp counts from there

double slopeAround(const Trace &trace, std::size_t at, double half)
{
    std::vector<double> t;
    std::vector<double> y;
    for (std::size_t i = 0; i < trace.size(); ++i) {
        if (std::abs(trace.t[i] - trace.t[at]) <= half) {
            t.push_back(trace.t[i]);
            y.push_back(trace.y[i]);
        }
    }
    return t.size() > 2 ? fitLine(t, y).slope : 0.0;
}

/// ∫ duty dt from its first sample to `time`.
double dutyIntegral(const Trace &duty, double time)
{
    double sum = 0.0;
    for (std::size_t i = 1; i < duty.size() && duty.t[i - 1] < time; ++i) {
        const double end = std::min(duty.t[i], time);
        sum += 0.5 * (duty.y[i - 1] + valueAt(duty, end)) * (end - duty.t[i - 1]);
    }
    return sum;
}

/// Rows of ∫u dt = friction·s·(t−t0) + (1/gain)·[(θ−θ0) + τ(v−v0)]; false where the ramp never got going.
bool addRamp(const RampRecord &ramp, double tau, LeastSquares<2> &fit)
{
    const Trace position = thinned(ramp.position, mostRampSamples);
    const double half = std::max(0.1, 4.0 * samplePeriod(position));
    if (position.size() < leastRampSamples || std::abs(position.y.back() - position.y.front()) < leastRampMove)
        return false;
    const double sign = position.y.back() > position.y.front() ? 1.0 : -1.0;
    std::vector<double> speed(position.size());
    for (std::size_t i = 0; i < position.size(); ++i)
        speed[i] = slopeAround(position, i, half);
    const auto end = static_cast<std::size_t>(
        std::lower_bound(position.t.begin(), position.t.end(), position.t.back() - half) - position.t.begin());
    if (end < leastRampSamples)
        return false;
    std::size_t begin = 0;
    while (begin < end && sign * speed[begin] < startedShare * std::abs(speed[end - 1]))
        ++begin;
    if (end - begin < leastRampSamples)
        return false;
    const double before = dutyIntegral(ramp.duty, position.t[begin]);
    for (std::size_t i = begin + 1; i < end; ++i) {
        const double way = position.y[i] - position.y[begin] + tau * (speed[i] - speed[begin]);
        fit.add({sign * (position.t[i] - position.t[begin]), way}, dutyIntegral(ramp.duty, position.t[i]) - before);
    }
    return true;
}

std::optional<double> oneWayGain(std::span<const RampRecord> ramps, double tau, double sign)
{
    LeastSquares<2> fit;
    bool any = false;
    for (const RampRecord &ramp : ramps) {
        if (!ramp.position.isEmpty() && sign * (ramp.position.y.back() - ramp.position.y.front()) > 0.0)
            any = addRamp(ramp, tau, fit) || any;
    }
    const auto solution = any ? fit.solve() : std::nullopt;
    return solution && solution->values[1] > 0.0 ? std::optional(1.0 / solution->values[1]) : std::nullopt;
}

} // namespace

double GainFit::asymmetry() const
{
    const double mean = 0.5 * (forward + reverse);
    return mean > 0.0 && forward > 0.0 && reverse > 0.0 ? std::abs(forward - reverse) / mean : 0.0;
}

Result<GainFit> fitGain(std::span<const double> duties, std::span<const double> speeds)
{
    LeastSquares<2> fit;
    LeastSquares<3> withLoad;
    std::array<std::pair<double, int>, 2> ways{};
    for (std::size_t i = 0; i < duties.size(); ++i) {
        const double sign = duties[i] > 0.0 ? 1.0 : -1.0;
        if (duties[i] * speeds[i] <= 0.0)
            return fail(Fault::OutOfRange, say("the motor did not turn the way it was pushed"));
        fit.add({1.0, std::abs(speeds[i])}, std::abs(duties[i]));
        withLoad.add({sign, 1.0, speeds[i]}, duties[i]);
    }
    const auto plain = fit.solve();
    if (!plain || plain->values[1] <= 0.0)
        return fail(
            Fault::OutOfRange, say("pushes of one size do not tell friction from gain"), say("push with two sizes"));
    GainFit result;
    result.friction = std::max(plain->values[0], 0.0);
    result.gain = 1.0 / plain->values[1];
    result.gainError = plain->errors[1] * result.gain * result.gain;
    result.frictionError = plain->errors[0];
    if (const auto loaded = withLoad.solve(); loaded && loaded->values[2] > 0.0) {
        result.friction = std::max(loaded->values[0], 0.0);
        result.offset = loaded->values[1];
        result.gain = 1.0 / loaded->values[2];
        result.gainError = loaded->errors[2] * result.gain * result.gain;
        result.frictionError = loaded->errors[0];
    }
    for (std::size_t i = 0; i < duties.size(); ++i) {
        auto &way = ways[duties[i] > 0.0 ? 0 : 1];
        const double pushed = std::abs(duties[i]) - result.friction;
        if (pushed > 0.0) {
            way.first += std::abs(speeds[i]) / pushed;
            ++way.second;
        }
    }
    result.forward = ways[0].second > 0 ? ways[0].first / ways[0].second : 0.0;
    result.reverse = ways[1].second > 0 ? ways[1].first / ways[1].second : 0.0;
    return result;
}

Result<GainFit> fitRamps(std::span<const RampRecord> ramps, double tau)
{
    LeastSquares<2> fit;
    for (const RampRecord &ramp : ramps) {
        if (!addRamp(ramp, tau, fit))
            return fail(Fault::OutOfRange, say("a ramp of duty never got the motor going"), say("raise its end"));
    }
    const auto solution = fit.solve();
    if (!solution || solution->values[1] <= 0.0)
        return fail(Fault::OutOfRange, say("the ramps do not tell friction from gain"));
    GainFit result;
    result.gain = 1.0 / solution->values[1];
    result.friction = std::max(solution->values[0], 0.0);
    result.gainError = solution->errors[1] * result.gain * result.gain;
    result.frictionError = solution->errors[0];
    result.forward = oneWayGain(ramps, tau, 1.0).value_or(0.0);
    result.reverse = oneWayGain(ramps, tau, -1.0).value_or(0.0);
    return result;
}

} // namespace mb::tuning
