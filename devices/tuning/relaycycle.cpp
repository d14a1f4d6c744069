// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/relaycycle.h"

#include <algorithm>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr std::size_t firstCycle = 2; ///< the first two still settle
constexpr std::size_t lastCycle = 8;
constexpr std::size_t leastCycles = 3;
constexpr double mostScatter = 0.1;
constexpr double bounceShare = 0.3; ///< of the median: a crossing that count noise made
constexpr double longestRelayTau = 20.0;

std::vector<double> risingCrossings(const Trace &position, double middle)
{
    std::vector<double> times;
    for (std::size_t i = 1; i < position.size(); ++i) {
        const double before = position.y[i - 1] - middle;
        const double after = position.y[i] - middle;
        if (before < 0.0 && after >= 0.0)
            times.push_back(position.t[i - 1] - before * (position.t[i] - position.t[i - 1]) / (after - before));
    }
    return times;
}

/// Without the crossings that follow another at once.
std::vector<double> withoutBounces(const std::vector<double> &times)
{
    std::vector<double> gaps;
    for (std::size_t i = 1; i < times.size(); ++i)
        gaps.push_back(times[i] - times[i - 1]);
    const double least = bounceShare * median(gaps);
    std::vector<double> kept;
    for (const double time : times) {
        if (kept.empty() || time - kept.back() > least)
            kept.push_back(time);
    }
    return kept;
}

} // namespace

std::optional<RelayCycle> readRelay(const Trace &position)
{
    if (position.size() < leastCycles * 4)
        return std::nullopt;
    const auto [low, high]
        = std::minmax_element(position.y.begin() + static_cast<std::ptrdiff_t>(position.size() / 3), position.y.end());
    const std::vector<double> crossings = withoutBounces(risingCrossings(position, 0.5 * (*low + *high)));
    std::vector<double> periods;
    std::vector<double> amplitudes;
    for (std::size_t i = firstCycle; i + 1 < crossings.size() && i < lastCycle; ++i) {
        periods.push_back(crossings[i + 1] - crossings[i]);
        const Trace cycle = position.part(crossings[i], crossings[i + 1]);
        if (cycle.size() < 4)
            return std::nullopt;
        const auto [bottom, top] = std::minmax_element(cycle.y.begin(), cycle.y.end());
        amplitudes.push_back(0.5 * (*top - *bottom));
    }
    if (periods.size() < leastCycles)
        return std::nullopt;
    RelayCycle result;
    result.period = median(periods);
    result.amplitude = median(amplitudes);
    result.cycles = static_cast<int>(periods.size());
    double squares = 0.0;
    for (const double period : periods)
        squares += (period - result.period) * (period - result.period);
    result.scatter = std::sqrt(squares / static_cast<double>(periods.size())) / result.period;
    if (result.scatter > mostScatter)
        return std::nullopt;
    return result;
}

ExactCycle exactCycle(double gain, double duty, double friction, double tau, double half, double braking)
{
    if (friction <= 0.0 && braking == 1.0) {
        const double th = std::tanh(half / (2.0 * tau));
        return {gain * duty * (half / 2.0 - tau * std::log1p(th)), gain * duty * th};
    }
    const double braked = gain * (duty + friction / braking); // friction helps while it slows down
    const double brakedTau = tau / braking;
    const double driven = gain * (duty - friction);
    const auto slowing = [&](double speed) { return brakedTau * std::log1p(speed / braked); };
    double low = 0.0;
    double high = driven;
    for (int i = 0; i < 100; ++i) {
        const double speed = 0.5 * (low + high);
        const double tz = slowing(speed);
        const bool tooFast = tz >= half || speed > driven * (1.0 - std::exp(-(half - tz) / tau));
        (tooFast ? high : low) = speed;
    }
    const double speed = 0.5 * (low + high);
    const double tz = slowing(speed);
    return {0.5 * (driven * (half - tz) - braked * tz + (brakedTau - tau) * speed), speed};
}

std::optional<double> tauFromRelay(const RelayCycle &cycle, double gain, double duty, double friction, double braking)
{
    const double half = cycle.period / 2.0;
    const auto tooLarge
        = [&](double tau) { return exactCycle(gain, duty, friction, tau, half, braking).amplitude > cycle.amplitude; };
    double low = 1e-4;
    double high = longestRelayTau;
    if (!tooLarge(low) || tooLarge(high))
        return std::nullopt;
    for (int i = 0; i < 100; ++i) {
        const double middle = std::sqrt(low * high);
        (tooLarge(middle) ? low : high) = middle;
    }
    return std::sqrt(low * high);
}

} // namespace mb::tuning
