// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/velocityfilter.h"

#include <algorithm>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr double shortestWindow = 0.005;
constexpr double longestWindow = 0.3;
constexpr double windowStep = 0.0025;
constexpr double lastLag = 0.1;
constexpr double lagStep = 0.0025;
constexpr std::size_t leastPrintSamples = 40;
constexpr std::size_t mostPrintSamples = 600;
constexpr double leastChange = 0.1; ///< of the fastest speed, between the slowest and the fastest tenth
constexpr double blockShare = 0.6;  ///< a hold as long as this share of the window is a block

/// Mean square of what the velocity differs from the positions' difference over this window, this late.
double misfit(const Trace &position, const Trace &velocity, std::size_t stride, double window, double lag)
{
    double sum = 0.0;
    std::size_t n = 0;
    for (std::size_t i = 0; i < velocity.size(); i += stride) {
        const double t = velocity.t[i] - lag;
        if (t - window < position.t.front() || t > position.t.back())
            continue;
        const double made = (valueAt(position, t) - valueAt(position, t - window)) / window;
        sum += (made - velocity.y[i]) * (made - velocity.y[i]);
        ++n;
    }
    return n >= leastPrintSamples / 2 ? sum / static_cast<double>(n) : -1.0;
}

double holdOf(const Trace &velocity)
{
    std::vector<double> times;
    for (std::size_t i = 1; i < velocity.size(); ++i) {
        if (velocity.y[i] != velocity.y[i - 1])
            times.push_back(velocity.t[i]);
    }
    std::vector<double> gaps;
    for (std::size_t i = 1; i < times.size(); ++i)
        gaps.push_back(times[i] - times[i - 1]);
    return median(std::move(gaps));
}

bool changes(const Trace &velocity)
{
    std::vector<double> sorted = velocity.y;
    std::ranges::sort(sorted);
    const double low = sorted[sorted.size() / 10];
    const double high = sorted[sorted.size() - 1 - sorted.size() / 10];
    return high - low > leastChange * std::max(std::abs(low), std::abs(high)) && high > low;
}

} // namespace

std::string_view toString(VelocityFilter::Kind kind)
{
    switch (kind) {
    case VelocityFilter::Kind::Rolling: return "rolling";
    case VelocityFilter::Kind::Block: return "block";
    case VelocityFilter::Kind::None: break;
    }
    return "none";
}

std::optional<VelocityFilter> fingerprint(const Trace &position, const Trace &velocity)
{
    if (position.size() < leastPrintSamples || velocity.size() < leastPrintSamples || !changes(velocity))
        return std::nullopt;
    const std::size_t stride = std::max<std::size_t>(1, velocity.size() / mostPrintSamples);
    VelocityFilter filter;
    double best = -1.0;
    double lateness = 0.0;
    for (double window = shortestWindow; window <= longestWindow + 1e-9; window += windowStep) {
        for (double lag = 0.0; lag <= lastLag + 1e-9; lag += lagStep) {
            const double residual = misfit(position, velocity, stride, window, lag);
            if (residual >= 0.0 && (best < 0.0 || residual < best)) {
                best = residual;
                filter.window = window;
                lateness = lag;
            }
        }
    }
    if (best < 0.0)
        return std::nullopt;
    filter.delay = filter.window / 2.0 + lateness;
    filter.hold = holdOf(velocity);
    const double period = std::max(samplePeriod(velocity), samplePeriod(position));
    if (filter.hold > 1.5 * period && filter.hold >= blockShare * filter.window)
        filter.kind = VelocityFilter::Kind::Block;
    else if (filter.window > std::max(2.0 * period, 2.0 * shortestWindow))
        filter.kind = VelocityFilter::Kind::Rolling;
    return filter;
}

} // namespace mb::tuning
