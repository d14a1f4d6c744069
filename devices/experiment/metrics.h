// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/message.h"
#include "experiment/trace.h"

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace mb::tuning {

/// What is told of a response. Times in seconds, shares as fractions; nothing where it cannot be measured.
struct Metrics {
    std::optional<double> rise;        ///< 10 → 90 % of where it ends
    std::optional<double> settle;      ///< from the edge until it stays within 2 % of where it ends
    std::optional<double> overshoot;   ///< of where it ends
    std::optional<double> undershoot;  ///< the same of the way back
    std::optional<double> sse;         ///< 1 − where it ends, signed, of the step
    std::optional<double> iae;         ///< s, of the error over the step
    std::optional<double> itae;        ///< s²
    std::optional<double> peakCurrent; ///< A
    std::optional<double> dutyChatter; ///< RMS of duty minus its mean over 100 ms, last quarter
    std::optional<double> saturated;   ///< share of time
    std::optional<double> noise;       ///< σ over the step

    friend bool operator==(const Metrics &, const Metrics &) = default;
};
/// How far a response came that was not where it ends when its hold was over; empty where it was, or none was read.
[[nodiscard]] Message shortfallOf(const Metrics &metrics);

/// The keys of Metrics in JSON, CSV and journals, in their order; and how people read them: times `scale` in `unit`, with so many
/// decimals.
struct MetricKey {
    std::string_view key;
    std::optional<double> Metrics::*value;
    double scale;
    int decimals;
    std::string_view unit;
};
[[nodiscard]] const std::array<MetricKey, 11> &metricKeys();
/// nullptr where no metric has this key.
[[nodiscard]] const MetricKey *findMetric(std::string_view key);
/// Nothing where it was not measured, or no metric has this key.
[[nodiscard]] std::optional<double> metricOf(const Metrics &metrics, std::string_view key);

/// How a response may be read.
struct Response {
    Metrics metrics;
    double end = 0.0;   ///< where it ends, as a fraction of the step
    double band = 0.02; ///< half width of the band it settles in, of the step; wider than 2 % of the end where noise is
    bool moved = false; ///< it moved by 5 % of the step and 5 counts at least
    bool widened = false; ///< the band is wider than 2 %
    double rising = 0.0;  ///< s, edge → half of the end
};

/// Reads one response: samples of the measured value, t = 0 at the edge, some of them before it; from where it was then to
/// `target`. `repeats`: how many runs are merged in it (equivalenttime.h). Rise, overshoot, settle, sse, iae, itae, noise.
/// One that still rises when the samples end has not come to where it ends: no rise and no overshoot is told of it.
/// Without a target (the output of an open loop) it ends where it ends, and nothing is told of its error.
[[nodiscard]] Response readResponse(
    const Trace &measured, std::optional<double> target, double leastMove, int repeats = 1);

/// The same of a hold that was cut short after `seconds`: where it would have ended is known only if it had settled before the last
/// quarter of them; if not, nothing is told that depends on it.
[[nodiscard]] Response cutShort(Response response, double seconds);

/// Of the step, in which a velocity has settled that is counted over so few edges that one of them leaves a narrower band.
constexpr double wideBand = 0.05;
constexpr double unreadableNoise = 0.015; ///< σ, as Metrics::noise, above which one run tells no settling time
/// Seconds from t = 0 until `response`, on its way from 0 to `target`, stays within wideBand; nothing where it does not.
[[nodiscard]] std::optional<double> settledWidely(const Trace &response, double target);

/// ± of each metric that all runs have, at 95 %: two standard errors of the mean. Nothing for fewer than two runs.
[[nodiscard]] Metrics errorsOf(const std::vector<Metrics> &runs);

} // namespace mb::tuning
