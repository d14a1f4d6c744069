// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/plantfit.h"

#include "tuning/leastsquares.h"
#include "tuning/localfit.h"

#include <algorithm>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr std::size_t leastFitSamples = 8;
constexpr std::size_t mostFitSamples = 400; ///< of a record; more tell nothing new
constexpr double leastPushMove = 50.0;      ///< counts
constexpr double shortestFitTau = 0.003;
constexpr double longestFitTau = 1.5;
constexpr double longestDelay = 0.08;
constexpr int tauSteps = 60;
constexpr int delaySteps = 33;
constexpr double latestOrder = 0.15; ///< s
constexpr double lateStep = 0.0005;
constexpr double lateOrder = 0.008;
constexpr double halfCount = 0.5;
constexpr double stampError = 0.001; ///< s, of a busy computer's time stamps
constexpr double startedShare = 0.1; ///< of the last speed: a ramp counts from there

Trace thinned(const Trace &trace)
{
    if (trace.size() <= mostFitSamples)
        return trace;
    Trace few;
    const double step = static_cast<double>(trace.size()) / mostFitSamples;
    for (double at = 0.0; at < static_cast<double>(trace.size()); at += step)
        few.add(trace.t[static_cast<std::size_t>(at)], trace.y[static_cast<std::size_t>(at)]);
    return few;
}

struct Projected {
    double speed = 0.0;
    double residual = 0.0;
};

/// For a given τ and delay, speed and place of one record are a linear fit.
Projected project(const Trace &trace, double tau, double delay)
{
    double s = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0, syy = 0.0;
    const double y0 = trace.y.front();
    for (std::size_t i = 0; i < trace.size(); ++i) {
        const double t = std::max(trace.t[i] - delay, 0.0);
        const double x = t - tau * (1.0 - std::exp(-t / tau));
        const double y = trace.y[i] - y0;
        s += 1.0;
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
        syy += y * y;
    }
    const double determinant = s * sxx - sx * sx;
    if (determinant <= 0.0)
        return {0.0, syy};
    const double speed = (s * sxy - sx * sy) / determinant;
    const double place = (sy - speed * sx) / s;
    return {speed, std::max(syy - speed * sxy - place * sy, 0.0)};
}

/// Sum of squares over all records, in (half counts)².
double costOf(std::span<const Trace> traces, double tau, double delay)
{
    double sum = 0.0;
    for (const Trace &trace : traces)
        sum += project(trace, tau, delay).residual / (halfCount * halfCount);
    return sum;
}

struct Point2 {
    double tau = 0.0;
    double delay = 0.0;
    double cost = 0.0;
};

Point2 coarse(std::span<const Trace> traces)
{
    Point2 best{0.0, 0.0, -1.0};
    const double ratio = std::pow(longestFitTau / shortestFitTau, 1.0 / (tauSteps - 1));
    double tau = shortestFitTau;
    for (int i = 0; i < tauSteps; ++i, tau *= ratio) {
        for (int k = 0; k < delaySteps; ++k) {
            const double delay = longestDelay * k / (delaySteps - 1);
            const double cost = costOf(traces, tau, delay);
            if (best.cost < 0.0 || cost < best.cost)
                best = {tau, delay, cost};
        }
    }
    return best;
}

/// Walks downhill along the axes and the valley of equal τ + delay.
Point2 refined(std::span<const Trace> traces, Point2 best)
{
    constexpr std::array<std::array<double, 2>, 6> ways{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, -1}, {-1, 1}}};
    double wide = 0.06;
    double late = 0.002;
    for (int round = 0; round < 200 && wide > 1e-4; ++round) {
        bool better = false;
        for (const auto &way : ways) {
            const double tau = best.tau * (1.0 + way[0] * wide);
            const double delay = std::clamp(best.delay + way[1] * late, 0.0, longestDelay);
            const double cost = costOf(traces, tau, delay);
            if (cost < best.cost) {
                best = {tau, delay, cost};
                better = true;
            }
        }
        if (!better) {
            wide /= 2.0;
            late /= 2.0;
        }
    }
    return best;
}

/// When this record alone begins, for a given τ.
double ownDelay(const Trace &trace, double tau)
{
    double best = 0.0;
    double least = -1.0;
    for (double delay = 0.0; delay <= latestOrder; delay += lateStep) {
        const double residual = project(trace, tau, delay).residual;
        if (least < 0.0 || residual < least) {
            least = residual;
            best = delay;
        }
    }
    return best;
}

/// Takes back what single records are later than the others: the frame of their order was lost, and the next one moved the motor.
/// Whether there were any.
bool align(std::vector<Trace> &traces, double tau)
{
    std::vector<double> delays;
    for (const Trace &trace : traces)
        delays.push_back(ownDelay(trace, tau));
    const double usual = median(delays);
    bool any = false;
    for (std::size_t i = 0; i < traces.size(); ++i) {
        const double late = delays[i] - usual;
        if (late < lateOrder)
            continue;
        any = true;
        for (double &t : traces[i].t)
            t -= late;
    }
    return any;
}

/// Two standard errors of τ and delay from the curvature of the cost.
std::pair<double, double> uncertainty(std::span<const Trace> traces, const Point2 &best, std::size_t samples)
{
    const double a = 0.01 * best.tau;
    const double b = 0.001;
    const auto cost = [&](double x, double y) { return costOf(traces, best.tau + x, std::max(best.delay + y, -0.01)); };
    const double tt = (cost(a, 0) + cost(-a, 0) - 2.0 * best.cost) / (a * a);
    const double dd = (cost(0, b) + cost(0, -b) - 2.0 * best.cost) / (b * b);
    const double td = (cost(a, b) - cost(a, -b) - cost(-a, b) + cost(-a, -b)) / (4.0 * a * b);
    const double determinant = tt * dd - td * td;
    if (determinant <= 0.0 || samples < 10)
        return {0.1 * best.tau, 0.01};
    const double variance = best.cost / static_cast<double>(samples - 2 - 2 * traces.size());
    return {2.0 * std::sqrt(2.0 * variance * dd / determinant), 2.0 * std::sqrt(2.0 * variance * tt / determinant)};
}

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
    const Trace position = thinned(ramp.position);
    const double half = std::max(0.1, 4.0 * samplePeriod(position));
    if (position.size() < leastFitSamples || std::abs(position.y.back() - position.y.front()) < leastPushMove)
        return false;
    const double sign = position.y.back() > position.y.front() ? 1.0 : -1.0;
    std::vector<double> speed(position.size());
    for (std::size_t i = 0; i < position.size(); ++i)
        speed[i] = slopeAround(position, i, half);
    const auto end = static_cast<std::size_t>(
        std::lower_bound(position.t.begin(), position.t.end(), position.t.back() - half) - position.t.begin());
    if (end < leastFitSamples)
        return false;
    std::size_t begin = 0;
    while (begin < end && sign * speed[begin] < startedShare * std::abs(speed[end - 1]))
        ++begin;
    if (end - begin < leastFitSamples)
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

Result<PushFit> fitPushes(std::span<const PushRecord> records)
{
    std::vector<Trace> traces;
    std::size_t samples = 0;
    for (const PushRecord &record : records) {
        if (record.position.size() < leastFitSamples)
            return fail(Fault::OutOfRange, say("a push has fewer than 8 positions"),
                say("push longer, or ask for faster samples"));
        if (std::abs(record.position.y.back() - record.position.y.front()) < leastPushMove)
            return fail(
                Fault::OutOfRange, say("a push moved the motor by fewer than 50 counts"), say("push harder or longer"));
        traces.push_back(thinned(record.position));
        samples += traces.back().size();
    }
    if (traces.empty())
        return fail(Fault::OutOfRange, say("there is no push to fit"));
    Point2 best = refined(traces, coarse(traces));
    if (align(traces, best.tau))
        best = refined(traces, coarse(traces));
    const auto [tauError, delayError] = uncertainty(traces, best, samples);
    PushFit fit{best.tau, best.delay, tauError, delayError, {}, 0.0};
    double expected = 0.0; // sum of squares that whole counts and late time stamps make
    double left = 0.0;
    for (const Trace &trace : traces) {
        const Projected projected = project(trace, best.tau, best.delay);
        const double blur = projected.speed * stampError;
        expected += static_cast<double>(trace.size()) * (halfCount * halfCount + blur * blur);
        left += projected.residual;
        fit.speeds.push_back(projected.speed);
    }
    fit.cost = left / expected;
    return fit;
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
