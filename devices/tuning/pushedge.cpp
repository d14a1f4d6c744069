// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/pushedge.h"

#include <algorithm>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr double edgeSearch = 0.5;  ///< s after the order in which the device's own duty shows the edge
constexpr double edgeBefore = 0.15; ///< s before it, by another clock
constexpr double leastShare = 0.05; ///< of the duty ordered
constexpr double wholeShare = 0.95;
constexpr double mostOfDuty = 0.9; ///< that friction may take, when it is told where a slow push began

/// A push whose duty grows slowly is one that came at once, but later: by what was missing beyond friction (a share of the duty).
double centre(const Trace &duty, double ordered, std::size_t whole, double target, double friction)
{
    const auto moving = [&](double y) { return std::clamp((y / target - friction) / (1.0 - friction), 0.0, 1.0); };
    double missing = 0.0;
    double before = ordered;
    double last = 0.0;
    for (std::size_t i = 0; i <= whole; ++i) {
        if (duty.t[i] <= ordered)
            continue;
        const double now = moving(duty.y[i]);
        missing += (1.0 - 0.5 * (last + now)) * (duty.t[i] - before);
        before = duty.t[i];
        last = now;
    }
    return ordered + missing;
}

} // namespace

Edge edgeOf(const Signal *duty, double ordered, double target, double friction)
{
    if (!duty)
        return {ordered, ordered};
    const double held = std::min(friction / std::abs(target), mostOfDuty);
    const Trace &trace = duty->trace;
    int between = 0;
    std::optional<double> half;
    for (std::size_t i = 1; i < trace.size() && trace.t[i] <= ordered + edgeSearch; ++i) {
        const double share = trace.y[i] / target;
        if (trace.t[i] < ordered - edgeBefore || share < leastShare)
            continue;
        if (!half && share >= 0.5)
            half = std::clamp(ordered, trace.t[i - 1], trace.t[i]);
        if (share >= wholeShare) {
            if (between < 2)
                return {half.value_or(ordered), half.value_or(ordered)};
            return {centre(trace, ordered, i, target, held), trace.t[i]};
        }
        ++between;
    }
    return {half.value_or(ordered), half.value_or(ordered)};
}

double releaseOf(const Signal *duty, double ordered, double target)
{
    if (!duty)
        return ordered;
    const Trace &trace = duty->trace;
    double area = 0.0; // of the share that is still there, since it was ordered
    double before = ordered;
    double last = 1.0;
    int between = 0;
    for (std::size_t i = 1; i < trace.size() && trace.t[i] <= ordered + edgeSearch; ++i) {
        const double share = std::clamp(trace.y[i] / target, 0.0, 1.0);
        if (trace.t[i] < ordered - edgeBefore || (trace.t[i] < ordered && share >= wholeShare))
            continue;
        if (share < leastShare && between == 0)
            return std::clamp(ordered, trace.t[i - 1], trace.t[i]);
        const double now = std::max(trace.t[i], ordered);
        area += 0.5 * (last + share) * (now - before);
        if (share < leastShare)
            return ordered + area;
        before = now;
        last = share;
        between += share < wholeShare ? 1 : 0;
    }
    return ordered;
}

} // namespace mb::tuning
