// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/gainfit.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace mb::quadquad2drv {
namespace {

constexpr double halfWindow = 0.04; ///< s, around a sample whose speed is wanted
constexpr double least = 0.08;      ///< of the fastest: slower does not count as turning
constexpr double clear = 0.92;      ///< of the limit: above it the board may have cut the power
constexpr int fewest = 12;          ///< samples
constexpr double straight = 0.1;    ///< a step may lie off the line by so much of the fastest

struct Line {
    double slope = 0.0;
    double offset = 0.0;
};

std::optional<Line> lineThrough(const std::vector<double> &x, const std::vector<double> &y)
{
    const auto n = static_cast<double>(x.size());
    double sx = 0.0;
    double sy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        sx += x[i];
        sy += y[i];
    }
    double xx = 0.0;
    double xy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += (x[i] - sx / n) * (x[i] - sx / n);
        xy += (x[i] - sx / n) * (y[i] - sy / n);
    }
    if (x.size() < 2 || xx <= 0.0)
        return std::nullopt;
    return Line{xy / xx, sy / n - xy / xx * sx / n};
}

/// The samples to compare: the longest stretch in which the motor turns and the limit cannot have cut the power.
struct Span {
    std::size_t first = 0;
    std::size_t last = 0;
};

Span usable(const Plant &plant, const std::vector<double> &speeds, const Track &track, const Drive &drive)
{
    const double slow = least * plant.speedAt(drive.most);
    const auto power = [&](std::size_t i) {
        const double change = i == 0 || i + 1 >= speeds.size()
            ? 0.0
            : (speeds[i + 1] - speeds[i - 1]) / (track.seconds[i + 1] - track.seconds[i - 1]);
        return (speeds[i] + plant.lag * change) / plant.gain + plant.friction;
    };
    const auto good = [&](std::size_t i) { return speeds[i] >= slow && power(i) <= clear * drive.most; };
    Span longest;
    for (std::size_t first = 0; first < speeds.size();) {
        std::size_t last = first;
        while (last < speeds.size() && good(last))
            ++last;
        if (last - first > longest.last - longest.first)
            longest = {first, last};
        first = last + 1;
    }
    return longest;
}

} // namespace

double Track::speed(double from, double to) const
{
    std::vector<double> x;
    std::vector<double> y;
    for (std::size_t i = 0; i < size(); ++i) {
        if (seconds[i] >= from && seconds[i] <= to) {
            x.push_back(seconds[i]);
            y.push_back(counts[i]);
        }
    }
    const auto line = x.size() < 3 ? std::nullopt : lineThrough(x, y);
    return line ? line->slope : 0.0;
}

Result<Plant> fitPlant(const std::vector<PowerStep> &steps)
{
    std::vector<double> powers;
    std::vector<double> speeds;
    double lag = 0.0;
    for (const PowerStep &step : steps) {
        if (step.speed <= 0.0)
            continue;
        powers.push_back(step.power);
        speeds.push_back(step.speed);
        lag += step.lag;
    }
    const auto line = lineThrough(powers, speeds);
    if (!line || line->slope <= 0.0)
        return fail(Fault::Refused, say("the motor did not turn at two of the powers"),
            say("allow it more power, or free its shaft"));
    const double fastestSeen = *std::ranges::max_element(speeds);
    for (std::size_t i = 0; i < powers.size(); ++i) {
        if (std::abs(speeds[i] - line->slope * powers[i] - line->offset) > straight * fastestSeen)
            return fail(Fault::Refused, say("the speed does not grow evenly with the power"),
                say("look whether something brakes or limits the motor"));
    }
    return Plant{line->slope, -line->offset / line->slope, std::max(0.0, lag / static_cast<double>(powers.size()))};
}

Result<ScaleFit> fitScale(const Plant &plant, const Track &track, const Drive &drive)
{
    std::vector<double> speeds;
    for (const double time : track.seconds)
        speeds.push_back(track.speed(time - halfWindow, time + halfWindow));
    const Span span = usable(plant, speeds, track, drive);
    if (span.last < span.first + fewest)
        return fail(Fault::Refused, say("the motor turned too short a time below the power limit to be measured"));
    double terms = 0.0;
    double others = 0.0;
    double yz = 0.0;
    double zz = 0.0;
    const std::size_t a = span.first;
    for (std::size_t i = a + 1; i < span.last; ++i) {
        const double step = track.seconds[i] - track.seconds[i - 1];
        terms += step * (drive.terms[i] + drive.terms[i - 1]) / 2.0;
        if (!drive.others.empty())
            others += step * (drive.others[i] + drive.others[i - 1]) / 2.0;
        const double y = plant.lag * (speeds[i] - speeds[a]) + track.counts[i] - track.counts[a]
            + plant.gain * (plant.friction * (track.seconds[i] - track.seconds[a]) - others);
        const double z = plant.gain * terms;
        yz += y * z;
        zz += z * z;
    }
    if (zz <= 0.0)
        return fail(Fault::Refused, say("the gain had nothing to act on"));
    return ScaleFit{yz / zz, static_cast<int>(span.last - span.first)};
}

Result<double> agreed(const std::vector<double> &scales, double tolerance)
{
    double sum = 0.0;
    for (const double scale : scales)
        sum += scale;
    const double mean = scales.empty() ? 0.0 : sum / static_cast<double>(scales.size());
    for (const double scale : scales) {
        if (!(scale > 0.0) || std::abs(scale - mean) > tolerance * mean)
            return fail(Fault::Refused,
                say("the gains found at different values do not agree, so that a gain is no simple factor"));
    }
    if (scales.empty())
        return fail(Fault::Refused, say("nothing was measured"));
    return mean;
}

} // namespace mb::quadquad2drv
