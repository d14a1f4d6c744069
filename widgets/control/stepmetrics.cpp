// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/stepmetrics.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace mb {
namespace {

constexpr double usualBand = 0.02;
constexpr double leastMove = 0.05;
constexpr double unsteadyNoise = 0.1;
constexpr double riseLow = 0.1;
constexpr double riseHigh = 0.9;
constexpr double tailPart = 0.25;
constexpr double sigmaOfMad = 1.4826;
constexpr std::size_t leastSamples = 8;
constexpr std::size_t outsideInARow = 2; ///< one sample outside the band may be noise

/// z over seconds: 0 before the step, 1 at its target.
struct Normal {
    double time = 0.0;
    double z = 0.0;
};

double median(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double seconds(Duration time)
{
    return std::chrono::duration<double>(time).count();
}

/// Where the line first passes `level`, in seconds.
std::optional<double> crossing(const std::vector<Normal> &line, double level)
{
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i].z < level)
            continue;
        if (i == 0)
            return line[i].time;
        const Normal &a = line[i - 1];
        const Normal &b = line[i];
        return a.time + (b.time - a.time) * (level - a.z) / (b.z - a.z);
    }
    return std::nullopt;
}

/// The end of the last run outside the band.
double settling(const std::vector<Normal> &line, double final, double band)
{
    std::size_t inARow = 0;
    double settled = 0.0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        inARow = std::abs(line[i].z - final) > band * std::abs(final) ? inARow + 1 : 0;
        if (inARow >= outsideInARow)
            settled = i + 1 < line.size() ? line[i + 1].time : line[i].time;
    }
    return settled;
}

/// σ of what is left when the straight line through the tail is taken away: a slow creep is no noise.
double noiseOf(std::span<const Normal> tail)
{
    double time = 0.0;
    double z = 0.0;
    for (const Normal &point : tail) {
        time += point.time / static_cast<double>(tail.size());
        z += point.z / static_cast<double>(tail.size());
    }
    double across = 0.0;
    double along = 0.0;
    for (const Normal &point : tail) {
        across += (point.time - time) * (point.z - z);
        along += (point.time - time) * (point.time - time);
    }
    const double slope = along > 0.0 ? across / along : 0.0;
    std::vector<double> rest;
    for (const Normal &point : tail)
        rest.push_back(std::abs(point.z - z - slope * (point.time - time)));
    return sigmaOfMad * median(std::move(rest));
}

void measure(const std::vector<Normal> &line, StepMetrics &metrics)
{
    const auto most = static_cast<std::size_t>(static_cast<double>(line.size()) * tailPart);
    const auto tail = std::span(line).last(std::max<std::size_t>(most, 3));
    std::vector<double> values;
    for (const Normal &point : tail)
        values.push_back(point.z);
    const double final = median(std::move(values));
    metrics.noise = noiseOf(tail);
    metrics.unsteady = metrics.noise > unsteadyNoise;
    if (metrics.unsteady)
        return;
    metrics.steadyError = 1.0 - final;
    metrics.moved = final >= leastMove;
    if (!metrics.moved)
        return;
    const auto low = crossing(line, riseLow * final);
    const auto high = crossing(line, riseHigh * final);
    if (low && high)
        metrics.rise = *high - *low;
    const auto peak
        = std::max_element(line.begin(), line.end(), [](const Normal &a, const Normal &b) { return a.z < b.z; });
    const double over = (peak->z - final) / final;
    metrics.overshoot = over < 2.0 * metrics.noise ? 0.0 : over;
    metrics.band = std::max(usualBand, 3.0 * metrics.noise);
    const double settled = settling(line, final, metrics.band);
    if (settled < line.back().time)
        metrics.settle = settled;
}

} // namespace

StepMetrics measureStep(std::span<const Point> samples, Instant start, std::optional<double> from, double target)
{
    StepMetrics metrics;
    std::vector<double> before;
    for (const Point &point : samples) {
        if (!point.isGap() && point.time < start)
            before.push_back(point.value);
    }
    if (!from && !before.empty())
        from = median(before);
    const double height = from ? target - *from : 0.0;
    if (height == 0.0)
        return metrics;
    std::vector<Normal> line;
    for (const Point &point : samples) {
        if (!point.isGap() && point.time >= start)
            line.push_back({seconds(point.time - start), (point.value - *from) / height});
    }
    if (line.size() < leastSamples)
        return metrics;
    measure(line, metrics);
    const auto peak
        = std::max_element(line.begin(), line.end(), [](const Normal &a, const Normal &b) { return a.z < b.z; });
    metrics.peak = *from + peak->z * height;
    metrics.peakAt = start + std::chrono::duration_cast<Duration>(std::chrono::duration<double>(peak->time));
    return metrics;
}

} // namespace mb
