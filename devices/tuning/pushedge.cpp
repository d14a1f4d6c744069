// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/pushedge.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace mb::tuning {
namespace {

constexpr double edgeSearch = 0.5;  ///< s after the order in which the device's own duty shows the edge
constexpr double edgeBefore = 0.15; ///< s before it, by another clock
constexpr double leastShare = 0.05; ///< of the duty ordered
constexpr double wholeShare = 0.95;
constexpr int fewestSteps = 2;           ///< between, of a duty that grows slowly
constexpr double answerTime = 0.0005;    ///< s, that a sample which was asked for before an order may come after it
constexpr double shortestPeriod = 0.001; ///< s, between orders
constexpr double mostOfDuty = 0.9;       ///< that friction may take, when it is told where a slow push began

/// What of a duty moves the motor, as a share of all that does: friction takes its share of the target first.
double movingShare(double duty, double target, double friction)
{
    const double held = std::min(friction / std::abs(target), mostOfDuty);
    return std::clamp((duty / target - held) / (1.0 - held), 0.0, 1.0);
}

/// A push whose duty grows slowly is one that came at once, but later: by what was missing beyond friction.
double centre(const Trace &duty, double ordered, std::size_t whole, double target, double friction)
{
    double missing = 0.0;
    double before = ordered;
    double last = 0.0;
    for (std::size_t i = 0; i <= whole; ++i) {
        if (duty.t[i] <= ordered)
            continue;
        const double now = movingShare(duty.y[i], target, friction);
        missing += (1.0 - 0.5 * (last + now)) * (duty.t[i] - before);
        before = duty.t[i];
        last = now;
    }
    return ordered + missing;
}

/// By samples of the output, each of which may be as old as the one before it.
Edge edgeOf(const Trace &duty, double ordered, double target, double friction)
{
    int between = 0;
    std::optional<double> half;
    for (std::size_t i = 1; i < duty.size() && duty.t[i] <= ordered + edgeSearch; ++i) {
        const double share = duty.y[i] / target;
        if (duty.t[i] < ordered - edgeBefore || share < leastShare)
            continue;
        if (!half && share >= 0.5)
            half = std::clamp(ordered, duty.t[i - 1], duty.t[i]);
        if (share >= wholeShare) {
            if (between < fewestSteps)
                return {half.value_or(ordered), half.value_or(ordered)};
            return {centre(duty, ordered, i, target, friction), duty.t[i]};
        }
        ++between;
    }
    return {half.value_or(ordered), half.value_or(ordered)};
}

/// When an order of `t` was carried out that takes the output from one share of its way to the next: then, or where a sample since
/// shows it without, for its frame was lost, with one of those that came later, a period each.
template <class Arrived>
double carriedOut(const Trace &duty, double t, double middle, double period, const Arrived &arrived)
{
    double without = t;
    for (std::size_t i = 0; i < duty.size() && duty.t[i] <= t + edgeSearch; ++i) {
        if (duty.t[i] <= t + answerTime)
            continue;
        if (arrived(duty.y[i]) >= middle)
            break;
        without = duty.t[i];
    }
    return t + period * std::ceil((without - t) / period);
}

/// The orders by which the program has led the set-point there: each with the share of its way that is gone by then.
template <class Arrived> Trace ordersOf(const Trace &told, double ordered, const Arrived &arrived)
{
    Trace orders;
    for (std::size_t i = 0; i < told.size() && told.t[i] <= ordered + edgeSearch; ++i) {
        if (told.t[i] < ordered)
            continue;
        orders.add(told.t[i], arrived(told.y[i]));
        if (orders.y.back() >= wholeShare)
            return orders;
    }
    return {};
}

/// By the steps in which the program has led the set-point there, as the samples show them carried out; nothing where it has not.
/// `arrived`: share of its way that a duty has gone; `moving`: what the motor feels of such a share.
template <class Arrived, class Moving>
std::optional<Edge> ledEdge(
    const Trace &told, const Trace &duty, double ordered, const Arrived &arrived, const Moving &moving)
{
    const Trace orders = ordersOf(told, ordered, arrived);
    if (orders.size() < 2)
        return std::nullopt;
    double period = shortestPeriod;
    for (std::size_t i = 1; i < orders.size(); ++i)
        period = std::max(period, orders.t[i] - orders.t[i - 1]);
    Edge edge;
    double before = 0.0;
    double felt = 0.0;
    for (std::size_t i = 0; i < orders.size(); ++i) {
        const double at = carriedOut(duty, orders.t[i], 0.5 * (before + orders.y[i]), period, arrived);
        const double feels = i + 1 < orders.size() ? moving(orders.y[i]) : 1.0;
        edge.steps.push_back({at, feels - felt});
        edge.at += (feels - felt) * at;
        edge.whole = std::max(edge.whole, at);
        before = orders.y[i];
        felt = feels;
    }
    for (DutyStep &step : edge.steps)
        step.at -= edge.at;
    return edge;
}

/// As edgeOf(), of the end of a push; `whole`: when all of its duty was gone.
Edge releaseOf(const Trace &duty, double ordered, double target)
{
    double area = 0.0; // of the share that is still there, since it was ordered
    double before = ordered;
    double last = 1.0;
    int between = 0;
    for (std::size_t i = 1; i < duty.size() && duty.t[i] <= ordered + edgeSearch; ++i) {
        const double share = std::clamp(duty.y[i] / target, 0.0, 1.0);
        if (duty.t[i] < ordered - edgeBefore || (duty.t[i] < ordered && share >= wholeShare))
            continue;
        if (share < leastShare && between == 0) {
            const double at = std::clamp(ordered, duty.t[i - 1], duty.t[i]);
            return {at, at};
        }
        const double now = std::max(duty.t[i], ordered);
        area += 0.5 * (last + share) * (now - before);
        if (share < leastShare)
            return {ordered + area, now};
        before = now;
        last = share;
        between += share < wholeShare ? 1 : 0;
    }
    return {ordered, ordered};
}

} // namespace

Edge edgeOf(const Trial &trial, double ordered, double friction)
{
    const Signal *const duty = trial.signal("duty");
    if (!duty)
        return {ordered, ordered};
    const double target = trial.stimulus.to;
    const Edge sampled = edgeOf(duty->trace, ordered, target, friction);
    const Signal *const told = trial.signal("setpoint");
    const auto arrived = [target](double y) { return y / target; };
    const auto moving = [=](double share) { return movingShare(share * target, target, friction); };
    const auto led = told ? ledEdge(told->trace, duty->trace, ordered, arrived, moving) : std::nullopt;
    return led.value_or(sampled);
}

double releaseOf(const Trial &trial, double ordered)
{
    const Signal *const duty = trial.signal("duty");
    if (!duty)
        return ordered;
    const double target = trial.stimulus.to;
    const Edge sampled = releaseOf(duty->trace, ordered, target);
    const Signal *const told = trial.signal("setpoint");
    const auto gone = [target](double y) { return 1.0 - std::clamp(y / target, 0.0, 1.0); };
    const auto led
        = told ? ledEdge(told->trace, duty->trace, ordered, gone, [](double share) { return share; }) : std::nullopt;
    return led.value_or(sampled).at;
}

} // namespace mb::tuning
