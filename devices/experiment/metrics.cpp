// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/metrics.h"

#include "experiment/figures.h"
#include "experiment/localfit.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace mb::tuning {
namespace {

constexpr double band = 0.02;
constexpr double tailFrom = 0.75;  ///< of all the time, from which on it is where it ends
constexpr double quiet = 1e-3;     ///< σ of the step below which nothing is smoothed
constexpr double muchNoise = 0.05; ///< σ with which one sample says little
constexpr int manyRepeats = 6;
constexpr int enoughRepeats = 4;       ///< that tell a settling time in unreadableNoise
constexpr double fewSamples = 1.6;     ///< periods either side: where it is steep, or without noise
constexpr double manySamples = 4.2;    ///< where it is flat
constexpr double riseTime = 0.35;      ///< of the rise to a half, over which noise is taken out of it
constexpr double slowTime = 1.0;       ///< times the rise to a half
constexpr double wideMean = 3.0;       ///< times the rise to a half
constexpr double lateOvershoot = 12.0; ///< times that, after which a mean is of noise alone
constexpr double leastEnd = 0.05;
constexpr double sureRise = 3.0; ///< σ of a line's rise
constexpr double madToSigma = 1.4826;
constexpr double quadraticGain = 2.25; ///< noise that a local quadratic leaves, in its middle

/// A response over its step: 0 before, 1 at the target.
struct Normal {
    Trace z;               ///< smoothed where noise is
    Trace raw;             ///< as it was measured
    std::size_t begin = 0; ///< first sample at or after the edge
    double period = 0.0;
    double end = 0.0;
    double sigma = 0.0;       ///< of one sample
    bool isMean = false;      ///< only the mean of its many repeats says anything
    double half = 0.0;        ///< width of the smoothing, s; 0: none
    double smoothSigma = 0.0; ///< what is left of it
    double rising = 0.0;
};

double startOf(const Trace &measured, std::size_t begin)
{
    const auto edge = measured.y.begin() + static_cast<std::ptrdiff_t>(begin);
    if (begin >= 3)
        return median(std::vector<double>(measured.y.begin(), edge));
    return measured.y.front();
}

std::vector<double> tailOf(const Trace &trace, std::vector<double> *times = nullptr)
{
    std::vector<double> values;
    const double from = trace.t.back() * tailFrom;
    for (std::size_t i = 0; i < trace.size(); ++i) {
        if (trace.t[i] <= from)
            continue;
        values.push_back(trace.y[i]);
        if (times)
            times->push_back(trace.t[i]);
    }
    return values;
}

double meanOf(const std::vector<double> &values)
{
    return std::accumulate(values.begin(), values.end(), 0.0)
        / static_cast<double>(std::max<std::size_t>(values.size(), 1));
}

double noiseOf(const Trace &trace, int repeats)
{
    std::vector<double> times;
    std::vector<double> values = tailOf(trace, &times);
    const Line line = fitLine(times, values);
    double squares = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = std::abs(values[i] - line.at(times[i]));
        squares += values[i] * values[i] / static_cast<double>(values.size());
    }
    // the median of the differences from their middle, which the line has taken to 0
    const double sigma = madToSigma * median(std::move(values));
    return repeats < manyRepeats || sigma < muchNoise
        ? sigma
        : std::sqrt(squares); // of a few steps of a coarse reading, a median is one of them
}

/// When it has come half of its way. In much noise the first sample beyond it says nothing: there it is where those before are below
/// it and those after above it, all together.
double risingOf(const Normal &normal)
{
    const auto &[t, y] = normal.z;
    double below = 0.0;
    double most = 0.0;
    double risen = t.back();
    for (std::size_t i = normal.begin; i < t.size(); ++i) {
        if (!normal.isMean && y[i] >= 0.5 * normal.end)
            return t[i];
        below += 0.5 - y[i] / normal.end;
        if (below > most) {
            most = below;
            risen = t[i];
        }
    }
    return risen;
}

void smooth(Normal &normal)
{
    normal.rising = risingOf(normal);
    normal.smoothSigma = normal.sigma;
    if (normal.sigma < quiet)
        return;
    normal.half = std::max(2.5 * normal.period, (normal.isMean ? slowTime : riseTime) * normal.rising);
    normal.smoothSigma = normal.sigma / std::sqrt(std::max(1.0, 2.0 * normal.half / normal.period / quadraticGain));
    normal.z.y = smoothed(normal.z, normal.begin, normal.half);
}

/// Where the parabola through the samples around `guess` passes a level; the guess where it does not.
double refined(const Trace &raw, std::size_t begin, double guess, double level, double half)
{
    const auto fit = fitParabola(raw, guess, half, begin);
    if (!fit)
        return guess;
    const double root = fit->b * fit->b - 4.0 * fit->c * (fit->a - level);
    if (root < 0.0 || fit->b <= 0.0)
        return guess;
    const double moved = 2.0 * (level - fit->a) / (fit->b + std::sqrt(root)); // the root near 0, also of a line
    return std::abs(moved) <= half ? std::max(0.0, guess + moved) : guess;
}

/// The first time at which the response reaches a level, between samples, out of those `width` periods around it.
std::optional<double> crossing(const Normal &normal, double level, double width)
{
    const auto &[t, y] = normal.z;
    const double half = width * normal.period;
    for (std::size_t i = normal.begin; i < t.size(); ++i) {
        if (y[i] < level)
            continue;
        const double guess = i == normal.begin ? t[i] * level / std::max(y[i], 1e-9)
                                               : t[i - 1] + (level - y[i - 1]) / (y[i] - y[i - 1]) * (t[i] - t[i - 1]);
        return refined(normal.raw, normal.begin, guess, level, half);
    }
    return std::nullopt;
}

/// In much noise: the largest mean over three times its rise, not long after it, where it is more than the largest of so many means would be by noise alone.
double overshootOfMeans(const Normal &normal)
{
    const auto &[t, y] = normal.raw;
    const double width = wideMean * normal.rising;
    double sum = 0.0;
    double most = 0.0;
    double fewest = 1.0;
    std::size_t from = normal.begin;
    for (std::size_t i = normal.begin; i < t.size() && t[i] - t[normal.begin] < lateOvershoot * normal.rising; ++i) {
        sum += y[i];
        for (; t[i] - t[from] > width; ++from)
            sum -= y[from];
        const auto count = static_cast<double>(i + 1 - from);
        if (t[i] - t[normal.begin] < width)
            continue;
        most = std::max(most, sum / count);
        fewest = std::max(fewest, count);
    }
    const double means = std::max(std::min((t.back() - t[normal.begin]) / width, lateOvershoot / wideMean), 1.0);
    const double sure = std::max(2.0, std::sqrt(2.0 * std::log(means)));
    const double over = most / normal.end - 1.0;
    return over > sure * normal.sigma / std::sqrt(fewest) / std::abs(normal.end) ? over : 0.0;
}

double overshootOf(const Normal &normal)
{
    if (normal.isMean)
        return overshootOfMeans(normal);
    const auto first = normal.z.y.begin() + static_cast<std::ptrdiff_t>(normal.begin);
    const auto at = static_cast<std::size_t>(std::max_element(first, normal.z.y.end()) - normal.z.y.begin());
    const double reach = std::max((normal.half > 0.0 ? 2.5 : 1.1) * normal.period, normal.half);
    const double peak = vertexNear(normal.z, at, normal.begin, reach).value_or(normal.z.y[at]);
    const double over = (peak - normal.end) / normal.end;
    return over > 2.0 * normal.smoothSigma / std::abs(normal.end) ? over : 0.0;
}

/// When a response that is outside its band at sample `i` has come into it.
double entryAfter(const Trace &response, std::size_t i, double end, double width)
{
    const double before = std::abs(response.y[i] - end) - width;
    const double after = std::abs(response.y[i + 1] - end) - width;
    const double share = after < 0.0 ? before / (before - after) : 1.0;
    return response.t[i] + share * (response.t[i + 1] - response.t[i]);
}

/// Nothing where it has not settled when the samples end.
std::optional<double> settleOf(const Normal &normal, double width)
{
    const double run = normal.sigma > quiet ? std::max(2.0, std::ceil(0.08 * normal.rising / normal.period)) : 1.0;
    // what happens near its end is slower than its rise, so noise can be taken out of it over a longer time
    const Trace slow = normal.sigma > quiet
        ? Trace{normal.z.t, smoothed(normal.raw, normal.begin, std::max(normal.half, slowTime * normal.rising))}
        : normal.z;
    double settled = 0.0;
    double outside = 0.0;
    for (std::size_t i = normal.begin; i < slow.size(); ++i) {
        outside = std::abs(slow.y[i] - normal.end) > width ? outside + 1.0 : 0.0;
        if (outside < run)
            continue;
        if (i + 1 >= slow.size())
            return std::nullopt;
        settled = entryAfter(slow, i, normal.end, width);
    }
    if (settled > 0.0 && normal.z.t.back() - settled < 2.0 * normal.period)
        return std::nullopt;
    return settled;
}

/// It rises all over its tail, by more than that, and was nowhere higher before: what it has come to is not where it ends.
bool stillRises(const Normal &normal, double width)
{
    std::vector<double> times;
    const std::vector<double> tail = tailOf(normal.raw, &times);
    const Line line = fitLine(times, tail);
    const double rise = line.at(times.back()) - line.at(times.front());
    const double doubt = sureRise * normal.sigma * std::sqrt(12.0 / static_cast<double>(tail.size()));
    const auto first = normal.z.y.begin() + static_cast<std::ptrdiff_t>(normal.begin);
    const auto last = normal.z.y.end() - static_cast<std::ptrdiff_t>(tail.size());
    return rise > std::max(width, doubt) && (first >= last || *std::max_element(first, last) < normal.end);
}

/// Sums of the error, from the edge, where it is the whole step; in noise only to a while after it has settled.
void integrate(Metrics &metrics, const Normal &normal)
{
    const double settled = metrics.settle.value_or(0.0);
    const bool whole = normal.sigma < quiet || settled == 0.0;
    const double last = whole ? normal.z.t.back() : 1.5 * settled + 2.0 * normal.period;
    double before = 0.0;
    double error = 1.0;
    double iae = 0.0;
    double itae = 0.0;
    for (std::size_t i = normal.begin; i < normal.z.size() && normal.z.t[i] <= last; ++i) {
        const double now = normal.z.t[i];
        const double present = std::abs(1.0 - normal.z.y[i]);
        iae += (error + present) / 2.0 * (now - before);
        itae += (before * error + now * present) / 2.0 * (now - before);
        before = now;
        error = present;
    }
    metrics.iae = iae;
    metrics.itae = itae;
}

Normal normalized(const Trace &measured, std::size_t begin, double start, double step, int repeats)
{
    Normal normal;
    normal.begin = begin;
    normal.z.t = measured.t;
    for (const double value : measured.y)
        normal.z.y.push_back((value - start) / step);
    normal.raw = normal.z;
    normal.sigma = noiseOf(normal.z, repeats);
    normal.isMean = repeats >= manyRepeats && normal.sigma >= muchNoise; // a loop that swings looks noisy, too
    normal.end = !normal.isMean ? median(tailOf(normal.z)) : meanOf(tailOf(normal.z));
    return normal;
}

} // namespace

const std::array<MetricKey, 11> &metricKeys()
{
    static constexpr std::array<MetricKey, 11> keys{{
        {"rise", &Metrics::rise, 1e3, 0, "ms"},
        {"settle", &Metrics::settle, 1e3, 0, "ms"},
        {"overshoot", &Metrics::overshoot, 100.0, 1, "%"},
        {"undershoot", &Metrics::undershoot, 100.0, 1, "%"},
        {"sse", &Metrics::sse, 100.0, 2, "%"},
        {"iae", &Metrics::iae, 1e3, 0, "ms"},
        {"itae", &Metrics::itae, 1e3, 1, "ms·s"},
        {"peak_current", &Metrics::peakCurrent, 1.0, 1, "A"},
        {"rms_duty", &Metrics::dutyChatter, 100.0, 2, "%"},
        {"saturated", &Metrics::saturated, 100.0, 1, "%"},
        {"noise", &Metrics::noise, 100.0, 2, "%"},
    }};
    return keys;
}

const MetricKey *findMetric(std::string_view key)
{
    const auto &keys = metricKeys();
    const auto *const found = std::ranges::find(keys, key, &MetricKey::key);
    return found == keys.end() ? nullptr : found;
}

std::optional<double> metricOf(const Metrics &metrics, std::string_view key)
{
    const MetricKey *const metric = findMetric(key);
    return metric ? metrics.*metric->value : std::nullopt;
}

Message shortfallOf(const Metrics &metrics)
{
    if (metrics.overshoot || metrics.sse.value_or(0.0) <= band)
        return {};
    return say("it came to %1 of its step while that was held", percentText(std::max(1.0 - *metrics.sse, 0.0)));
}

Response readResponse(const Trace &measured, std::optional<double> target, double leastMove, int repeats)
{
    Response response;
    const auto edge = std::lower_bound(measured.t.begin(), measured.t.end(), 0.0);
    const auto begin = static_cast<std::size_t>(edge - measured.t.begin());
    if (measured.size() < begin + 8)
        return response;
    const double start = startOf(measured, begin);
    const double step = target.value_or(median(tailOf(measured))) - start;
    if (step == 0.0)
        return response;
    Normal normal = normalized(measured, begin, start, step, repeats);
    normal.period = (measured.t.back() - measured.t.front()) / static_cast<double>(measured.size() - 1);
    smooth(normal);
    response.end = normal.end;
    response.rising = normal.rising;
    response.moved = normal.end >= leastEnd && std::abs(normal.end * step) >= leastMove;
    response.band = std::max(band * std::abs(normal.end), 3.0 * normal.smoothSigma);
    response.widened = response.band > band * std::abs(normal.end);
    Metrics &metrics = response.metrics;
    metrics.noise = normal.sigma;
    if (response.moved && (normal.sigma <= unreadableNoise || repeats >= enoughRepeats))
        metrics.settle = settleOf(normal, response.band);
    if (response.moved && !stillRises(normal, 2.0 * response.band)) { // both sides of it
        const auto low = crossing(normal, 0.1 * normal.end, fewSamples);
        const auto high = crossing(normal, 0.9 * normal.end, normal.half > 0.0 ? manySamples : fewSamples);
        if (low && high)
            metrics.rise = *high - *low;
        metrics.overshoot = overshootOf(normal);
    }
    if (target) {
        metrics.sse = 1.0 - normal.end;
        integrate(metrics, normal);
    }
    return response;
}

Response cutShort(Response response, double seconds)
{
    const auto settled = response.metrics.settle;
    if (!settled || *settled > tailFrom * seconds)
        response.metrics = Metrics();
    return response;
}

std::optional<double> settledWidely(const Trace &response, double target)
{
    double settled = 0.0;
    for (std::size_t i = 0; i < response.size(); ++i) {
        if (response.t[i] >= 0.0 && std::abs(response.y[i] - target) > wideBand * std::abs(target))
            settled = response.t[i];
    }
    const bool ends = !response.isEmpty() && settled < response.t.back();
    return ends ? std::optional(settled) : std::nullopt;
}

Metrics errorsOf(const std::vector<Metrics> &runs)
{
    Metrics errors;
    for (const MetricKey &key : metricKeys()) {
        double sum = 0.0;
        double squares = 0.0;
        std::size_t count = 0;
        for (const Metrics &run : runs) {
            if (!(run.*key.value))
                continue;
            sum += *(run.*key.value);
            squares += *(run.*key.value) * *(run.*key.value);
            ++count;
        }
        if (count < 2 || count < runs.size())
            continue;
        const auto n = static_cast<double>(count);
        const double variance = std::max(0.0, (squares - sum * sum / n) / (n - 1.0));
        errors.*key.value = 2.0 * std::sqrt(variance / n);
    }
    return errors;
}

} // namespace mb::tuning
