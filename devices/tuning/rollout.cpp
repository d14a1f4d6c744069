// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/rollout.h"

#include "tuning/leastsquares.h"
#include "tuning/pushedge.h"

#include <algorithm>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr double restTime = 0.05;  ///< s without a move, at least
constexpr double leastRoll = 10.0; ///< counts
constexpr double strongestBraking = 4.0;
constexpr double openWindings = 0.8; ///< less than this is no brake at all

/// Where it came to rest before `until`; nothing where that was not seen.
std::optional<double> restOf(const Trace &position, double from, double until)
{
    const Trace rolling = position.part(from, until);
    if (rolling.size() < 4)
        return std::nullopt;
    const double end = rolling.y.back();
    const double since = rolling.t.back() - std::max(restTime, 3.0 * samplePeriod(rolling));
    for (std::size_t i = 0; i < rolling.size(); ++i) {
        if (rolling.t[i] >= since && std::abs(rolling.y[i] - end) > 1.0)
            return std::nullopt;
    }
    return end;
}

double rollOf(double speed, double tau, double friction, double braking)
{
    const double lag = tau / braking;
    const double drag = friction / braking;
    return lag * (drag > 0.0 ? speed - drag * std::log1p(speed / drag) : speed);
}

} // namespace

std::vector<RollOut> rollOutsOf(const Trial &trial, const PushFit &fit, double friction)
{
    std::vector<RollOut> rolls;
    const Signal *const position = trial.signal("position");
    const double target = trial.stimulus.to;
    for (std::size_t i = 0; position && target != 0.0 && i < trial.holds.size(); ++i) {
        const Span &hold = trial.holds[i];
        const double begin = edgeOf(trial, hold.from, friction).at + fit.delay;
        const double end = releaseOf(trial, hold.to) + fit.delay;
        if (position->trace.isEmpty())
            break;
        const double until = i + 1 < trial.holds.size() ? trial.holds[i + 1].from : position->trace.t.back();
        const auto rest = restOf(position->trace, end, until);
        const Trace pushed = position->trace.part(begin, std::min(end, hold.to), begin);
        LeastSquares<2> squares;
        const double tau = fit.tau * sagged(fit.sag, target);
        const auto way = [tau](double t) { return t - tau * (1.0 - std::exp(-t / tau)); };
        for (std::size_t k = 0; k < pushed.size(); ++k)
            squares.add({1.0, way(pushed.t[k])}, pushed.y[k]);
        const auto line = squares.solve();
        if (!rest || !line || pushed.size() < 4)
            continue;
        const auto [from, speed] = line->values;
        const double at = from + speed * way(end - begin);
        const double sign = target > 0.0 ? 1.0 : -1.0;
        const RollOut roll{sign * speed * (1.0 - std::exp(-(end - begin) / tau)), sign * (*rest - at)};
        if (roll.speed > 0.0 && roll.distance >= leastRoll)
            rolls.push_back(roll);
    }
    return rolls;
}

std::optional<double> brakingOf(const std::vector<RollOut> &rolls, double tau, double friction)
{
    std::vector<double> found;
    for (const RollOut &roll : rolls) {
        double low = openWindings;
        double high = strongestBraking;
        if (rollOf(roll.speed, tau, friction, low) < roll.distance)
            continue;
        for (int i = 0; i < 50; ++i) {
            const double middle = 0.5 * (low + high);
            (rollOf(roll.speed, tau, friction, middle) > roll.distance ? low : high) = middle;
        }
        found.push_back(low);
    }
    if (2 * found.size() <= rolls.size())
        return std::nullopt;
    return std::max(median(std::move(found)), 1.0);
}

} // namespace mb::tuning
