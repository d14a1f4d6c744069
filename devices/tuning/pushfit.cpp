// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/pushfit.h"

#include "tuning/marquardt.h"
#include "tuning/windingheat.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

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
constexpr double mostWait = 0.001; ///< s, early or late
constexpr double finestWait = 0.00005;
constexpr int roundsOfWaits = 4;
constexpr std::size_t leastOfWaits = 3; ///< records that tell a wait from the delay of all
constexpr double halfCount = 0.5;
constexpr double stampError = 0.001; ///< s, of a busy computer's time stamps
constexpr double wholePush = 3.0;    ///< lags that a push lasts that tells its lag by itself
constexpr double unitOfDelay = 0.01; ///< s
constexpr double mostSag = 0.8;
constexpr double mostWarming = 0.4;
constexpr double clearlyLess = 0.75; ///< of the squares that are left over: the pushes tell sag and warming

struct FittedPush {
    Trace trace;
    std::vector<DutyStep> steps;
    double duty = 0.0;
    double heat = 0.0;
};

/// What is searched; speeds and places follow from it.
struct Point {
    double tau = 0.0;
    double delay = 0.0;
    double sag = 0.0;
    double warming = 0.0;
    double cost = -1.0;

    [[nodiscard]] double tauOf(const FittedPush &push) const
    {
        return tau * sagged(sag, push.duty) * (1.0 + warming * push.heat);
    }
};

struct Projected {
    double speed = 0.0;
    double residual = 0.0;
};

/// s, that a motor which speeds up to one count a second has gone by in counts.
double wayAfter(double t, double tau)
{
    return t > 0.0 ? t - tau * (1.0 - std::exp(-t / tau)) : 0.0;
}

/// The same of a duty that came in steps.
double wayOf(const std::vector<DutyStep> &steps, double t, double tau)
{
    double way = 0.0;
    for (const DutyStep &step : steps)
        way += step.share * wayAfter(t - step.at, tau);
    return way;
}

/// For a given τ and delay, speed and place of one record are a linear fit. `left`: gets what is left over of each sample.
Projected project(const FittedPush &push, double tau, double delay, std::vector<double> *left = nullptr)
{
    const Trace &trace = push.trace;
    double s = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0, syy = 0.0;
    const double y0 = trace.y.front();
    for (std::size_t i = 0; i < trace.size(); ++i) {
        const double x = wayOf(push.steps, trace.t[i] - delay, tau);
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
    for (std::size_t i = 0; left && i < trace.size(); ++i)
        left->push_back(trace.y[i] - y0 - place - speed * wayOf(push.steps, trace.t[i] - delay, tau));
    return {speed, std::max(syy - speed * sxy - place * sy, 0.0)};
}

/// Sum of squares over all records, in (half counts)².
double costOf(std::span<const FittedPush> pushes, const Point &at)
{
    double sum = 0.0;
    for (const FittedPush &push : pushes)
        sum += project(push, at.tauOf(push), at.delay).residual / (halfCount * halfCount);
    return sum;
}

Point coarse(std::span<const FittedPush> pushes)
{
    Point best;
    const double ratio = std::pow(longestFitTau / shortestFitTau, 1.0 / (tauSteps - 1));
    double tau = shortestFitTau;
    for (int i = 0; i < tauSteps; ++i, tau *= ratio) {
        for (int k = 0; k < delaySteps; ++k) {
            Point point{tau, longestDelay * k / (delaySteps - 1)};
            point.cost = costOf(pushes, point);
            if (best.cost < 0.0 || point.cost < best.cost)
                best = point;
        }
    }
    return best;
}

/// Walks downhill along the axes, and the valleys of equal τ + delay and of equal lags of a warm motor.
Point refined(std::span<const FittedPush> pushes, Point best, bool changes)
{
    struct Way {
        double tau;
        double delay;
        double sag;
        double warming;
    };
    static constexpr std::array<Way, 12> ways{{{1, 0, 0, 0}, {-1, 0, 0, 0}, {0, 1, 0, 0}, {0, -1, 0, 0}, {1, -1, 0, 0},
        {-1, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, -1, 0}, {0, 0, 0, 1}, {0, 0, 0, -1}, {-1, 0, 0, 1}, {1, 0, 0, -1}}};
    const std::size_t used = changes ? ways.size() : 6;
    double wide = 0.06;
    double late = 0.002;
    for (int round = 0; round < 200 && wide > 1e-4; ++round) {
        bool better = false;
        for (std::size_t i = 0; i < used; ++i) {
            const Way &way = ways[i];
            Point point{best.tau * (1.0 + way.tau * wide), std::clamp(best.delay + way.delay * late, 0.0, longestDelay),
                std::clamp(best.sag + way.sag * 4.0 * wide, 0.0, mostSag),
                std::clamp(best.warming + way.warming * 2.0 * wide, 0.0, mostWarming)};
            point.cost = costOf(pushes, point);
            if (point.cost < best.cost) {
                best = point;
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

bool isWhole(const FittedPush &push, double tau)
{
    return push.trace.t.back() >= wholePush * tau;
}

/// When this record alone begins, for a given τ; where it tells its own, with that: who is warm is not late.
double ownDelay(const FittedPush &push, double tau)
{
    double best = 0.0;
    double least = -1.0;
    for (double delay = 0.0; delay <= latestOrder; delay += lateStep) {
        const double residual = project(push, tau, delay).residual;
        if (least < 0.0 || residual < least) {
            least = residual;
            best = delay;
        }
    }
    if (!isWhole(push, tau))
        return best;
    using Fit = Marquardt<2>;
    const Fit::Minimum own = Fit::from({0.0, best / unitOfDelay}, [&](const auto &at, std::vector<double> &left) {
        left.clear();
        (void)project(push, tau * std::exp(at[0]), at[1] * unitOfDelay, &left);
        left.resize(push.trace.size());
    });
    return own.values[1] * unitOfDelay;
}

/// Takes back what single records are later than the others: the frame of their order was lost, and the next one moved the motor.
/// Whether there were any.
bool align(std::vector<FittedPush> &pushes, double tau)
{
    std::vector<double> delays;
    for (const FittedPush &push : pushes)
        delays.push_back(ownDelay(push, tau));
    const double usual = median(delays);
    bool any = false;
    for (std::size_t i = 0; i < pushes.size(); ++i) {
        const double late = delays[i] - usual;
        if (late < lateOrder)
            continue;
        any = true;
        for (double &t : pushes[i].trace.t)
            t -= late;
    }
    return any;
}

/// How much later than all this record alone began.
double waitOf(const FittedPush &push, const Point &at)
{
    const auto left = [&](double wait) { return project(push, at.tauOf(push), at.delay + wait).residual; };
    double best = 0.0;
    double least = left(best);
    for (double step = mostWait; step > finestWait; step /= 2.0) {
        for (const double wait : {best - step, best + step}) {
            if (const double residual = left(wait); residual < least) {
                least = residual;
                best = wait;
            }
        }
    }
    return best;
}

struct Settled {
    std::vector<FittedPush> pushes;
    Point point;
};

/// What each record is early or late by is taken back: an order waits for the next pass of the device's loop, and so may its counts.
Settled settled(std::vector<FittedPush> pushes, Point best, bool changes, double longest)
{
    std::vector<double> taken(pushes.size(), 0.0);
    for (int round = 0; round < roundsOfWaits && longest > 0.0 && pushes.size() >= leastOfWaits; ++round) {
        std::vector<double> waits;
        for (const FittedPush &push : pushes)
            waits.push_back(waitOf(push, best));
        const double usual = std::accumulate(waits.begin(), waits.end(), 0.0) / static_cast<double>(waits.size());
        for (std::size_t i = 0; i < pushes.size(); ++i) {
            const double before = std::exchange(taken[i], std::clamp(taken[i] + waits[i] - usual, -longest, longest));
            for (double &t : pushes[i].trace.t)
                t -= taken[i] - before;
        }
        best.cost = costOf(pushes, best);
        best = refined(pushes, best, changes);
    }
    return {std::move(pushes), best};
}

/// One lag for all; where the pushes clearly tell that it changes with duty and heat, that too.
Settled fitted(std::vector<FittedPush> pushes, double longest)
{
    Point best = refined(pushes, coarse(pushes), false);
    if (align(pushes, best.tau))
        best = refined(pushes, coarse(pushes), false);
    Settled same = settled(pushes, best, false, longest);
    if (!std::ranges::all_of(pushes, [&](const FittedPush &push) { return isWhole(push, best.tau); }))
        return same;
    Settled changing = settled(pushes, refined(pushes, best, true), true, longest);
    return changing.point.cost < clearlyLess * same.point.cost ? std::move(changing) : std::move(same);
}

/// Two standard errors of τ and delay from the curvature of the cost.
std::pair<double, double> uncertainty(std::span<const FittedPush> pushes, const Point &best, std::size_t samples)
{
    const double a = 0.01 * best.tau;
    const double b = 0.001;
    const auto cost = [&](double x, double y) {
        return costOf(pushes, {best.tau + x, std::max(best.delay + y, -0.01), best.sag, best.warming});
    };
    const double tt = (cost(a, 0) + cost(-a, 0) - 2.0 * best.cost) / (a * a);
    const double dd = (cost(0, b) + cost(0, -b) - 2.0 * best.cost) / (b * b);
    const double td = (cost(a, b) - cost(a, -b) - cost(-a, b) + cost(-a, -b)) / (4.0 * a * b);
    const double determinant = tt * dd - td * td;
    if (determinant <= 0.0 || samples < 10)
        return {0.1 * best.tau, 0.01};
    const double variance = best.cost / static_cast<double>(samples - 2 - 2 * pushes.size());
    return {2.0 * std::sqrt(2.0 * variance * dd / determinant), 2.0 * std::sqrt(2.0 * variance * tt / determinant)};
}

} // namespace

Result<PushFit> fitPushes(std::span<const PushRecord> records, double pass)
{
    std::vector<FittedPush> pushes;
    std::size_t samples = 0;
    for (const PushRecord &record : records) {
        if (record.position.size() < leastFitSamples)
            return fail(Fault::OutOfRange, say("a push has fewer than 8 positions"),
                say("push longer, or ask for faster samples"));
        if (std::abs(record.position.y.back() - record.position.y.front()) < leastPushMove)
            return fail(
                Fault::OutOfRange, say("a push moved the motor by fewer than 50 counts"), say("push harder or longer"));
        const std::vector<DutyStep> atOnce{DutyStep()};
        pushes.push_back({thinned(record.position, mostFitSamples), record.steps.empty() ? atOnce : record.steps,
            record.duty, record.heat});
        samples += pushes.back().trace.size();
    }
    if (pushes.empty())
        return fail(Fault::OutOfRange, say("the pushes that its limits leave hardly moved the motor"),
            say("allow more duty, speed or travel"));
    const auto [settledPushes, best]
        = fitted(std::move(pushes), pass > stampError ? std::min(0.5 * pass, mostWait) : 0.0);
    const auto [tauError, delayError] = uncertainty(settledPushes, best, samples);
    PushFit fit{best.tau, best.delay, tauError, delayError, {}, 0.0, best.sag, best.warming};
    double expected = 0.0; // sum of squares that whole counts and late time stamps make
    double left = 0.0;
    for (const FittedPush &push : settledPushes) {
        const Projected projected = project(push, best.tauOf(push), best.delay);
        const double blur = projected.speed * stampError;
        expected += static_cast<double>(push.trace.size()) * (halfCount * halfCount + blur * blur);
        left += projected.residual;
        fit.speeds.push_back(projected.speed / (1.0 + speedOfWarming * best.warming * push.heat));
    }
    fit.cost = left / expected;
    return fit;
}

} // namespace mb::tuning
