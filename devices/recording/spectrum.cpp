// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/spectrum.h"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <span>

namespace mb {
namespace {

constexpr std::size_t leastSamples = 16;
constexpr std::size_t mostSamples = 1U << 20U;

double inSeconds(Duration duration)
{
    return std::chrono::duration<double>(duration).count();
}

std::span<const Point> longestStretch(const std::vector<Point> &points)
{
    std::span<const Point> longest;
    auto begin = points.begin();
    while (begin != points.end()) {
        const auto end = std::find_if(begin, points.end(), [](const Point &point) { return point.isGap(); });
        if (static_cast<std::size_t>(end - begin) > longest.size())
            longest = {begin, end};
        begin = std::find_if(end, points.end(), [](const Point &point) { return !point.isGap(); });
    }
    return longest;
}

Duration medianStep(std::span<const Point> points)
{
    std::vector<Duration> steps;
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (points[i].time > points[i - 1].time)
            steps.push_back(points[i].time - points[i - 1].time);
    }
    if (steps.empty())
        return {};
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    return *middle;
}

std::vector<double> resampled(std::span<const Point> points, std::size_t count, Duration step)
{
    std::vector<double> even;
    even.reserve(count);
    std::size_t right = 1;
    for (std::size_t i = 0; i < count; ++i) {
        const Instant time = points.front().time + step * static_cast<std::int64_t>(i);
        while (right + 1 < points.size() && points[right].time < time)
            ++right;
        const Point &a = points[right - 1];
        const Point &b = points[right];
        const double span = inSeconds(b.time - a.time);
        const double part = span > 0.0 ? std::clamp(inSeconds(time - a.time) / span, 0.0, 1.0) : 1.0;
        even.push_back(a.value + (b.value - a.value) * part);
    }
    return even;
}

double hann(std::size_t i, std::size_t count)
{
    return 0.5 * (1.0 - std::cos(2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count)));
}

/// Takes the line of least squares off, under the window, which is even about its middle.
void flatten(std::vector<double> &even)
{
    constexpr double rounding = 1e-9;
    const std::size_t count = even.size();
    const auto place = [count](std::size_t i) { return static_cast<double>(i) / static_cast<double>(count) - 0.5; };
    double weights = 0.0;
    double mean = 0.0;
    double slope = 0.0;
    double squares = 0.0;
    double greatest = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const double weight = hann(i, count);
        weights += weight;
        mean += weight * even[i];
        slope += weight * place(i) * even[i];
        squares += weight * place(i) * place(i);
        greatest = std::max(greatest, std::abs(even[i]));
    }
    for (std::size_t i = 0; i < count; ++i)
        even[i] -= mean / weights + slope / squares * place(i);
    if (std::ranges::all_of(even, [greatest](double rest) { return std::abs(rest) <= rounding * greatest; }))
        std::ranges::fill(even, 0.0); // a line, or nothing at all
}

/// Of the amplitudes from `first` to `last`.
double middleOf(const std::vector<double> &amplitude, std::size_t first, std::size_t last)
{
    std::vector<double> some(amplitude.begin() + static_cast<std::ptrdiff_t>(first),
        amplitude.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    const auto middle = some.begin() + static_cast<std::ptrdiff_t>(some.size() / 2);
    std::nth_element(some.begin(), middle, some.end());
    return *middle;
}

/// Amplitudes of the waves in `even`, whose line is gone: an amplitude of 1 gives 1, window and all.
std::vector<double> amplitudes(std::vector<double> even)
{
    const std::size_t count = even.size();
    double gain = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        gain += hann(i, count);
        even[i] *= hann(i, count);
    }
    struct Free {
        void operator()(fftw_complex *memory) const { fftw_free(memory); }
    };
    const std::unique_ptr<fftw_complex[], Free> waves(fftw_alloc_complex(count / 2 + 1));
    fftw_plan plan = fftw_plan_dft_r2c_1d(static_cast<int>(count), even.data(), waves.get(), FFTW_ESTIMATE);
    fftw_execute(plan);
    fftw_destroy_plan(plan);
    std::vector<double> found(count / 2 + 1);
    for (std::size_t i = 1; i < found.size(); ++i)
        found[i] = std::hypot(waves[i][0], waves[i][1]) * 2.0 / gain;
    return found;
}

} // namespace

std::optional<std::size_t> Spectrum::peak() const
{
    constexpr double standsOut = 5.0;  // times the middle of its neighbours, which noise does not reach
    constexpr std::size_t foot = 2;    // what the window makes of one wave ends there
    constexpr std::size_t around = 32; // neighbours on each side, no more than an octave
    constexpr std::size_t leastAbove = 8;
    std::optional<std::size_t> found;
    for (std::size_t i = firstWave; i + foot < amplitude.size(); ++i) {
        const double wave = amplitude[i];
        if (wave <= amplitude[i - 1] || wave < amplitude[i + 1] || wave <= (found ? amplitude[*found] : 0.0))
            continue;
        const std::size_t low = std::max({std::size_t{1}, i / 2, i - std::min(i, foot + around)});
        const std::size_t high = std::min(amplitude.size() - 1, i + std::max(leastAbove, std::min(i, foot + around)));
        if (wave > standsOut * middleOf(amplitude, low, i - foot)
            && wave > standsOut * middleOf(amplitude, i + foot, high))
            found = i;
    }
    return found;
}

Result<Spectrum> spectrumOf(const std::vector<Point> &points)
{
    const std::span<const Point> stretch = longestStretch(points);
    const Duration step = medianStep(stretch);
    if (stretch.size() < leastSamples || step <= Duration::zero())
        return fail(Fault::OutOfRange, say("fewer than 16 samples connect"), say("select a longer stretch"));
    const auto fitting = static_cast<std::size_t>((stretch.back().time - stretch.front().time) / step) + 1;
    const std::size_t count = std::min(fitting, mostSamples);
    if (count < leastSamples)
        return fail(Fault::OutOfRange, say("fewer than 16 samples connect"), say("select a longer stretch"));
    std::vector<double> even = resampled(stretch, count, step);
    flatten(even);
    Spectrum spectrum;
    spectrum.rate = 1.0 / inSeconds(step);
    spectrum.resolution = spectrum.rate / static_cast<double>(count);
    spectrum.amplitude = amplitudes(std::move(even));
    spectrum.from = stretch.front().time;
    spectrum.to = stretch.front().time + step * static_cast<std::int64_t>(count - 1);
    spectrum.shortened = stretch.size() != points.size() || fitting > count;
    return spectrum;
}

} // namespace mb
