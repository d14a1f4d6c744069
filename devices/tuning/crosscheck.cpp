// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/crosscheck.h"

#include "tuning/leastsquares.h"

#include <algorithm>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr double shareOfLag = 0.25; ///< that a mean speed is taken over
constexpr double leastWindow = 0.02;
constexpr double leastWindows = 3.5; ///< of the lag: a shorter one is not seen
constexpr double leastCountsOfMean = 50.0;
constexpr std::size_t leastRows = 12;

} // namespace

std::optional<double> lagByRegression(std::span<const PushRecord> records, const PushFit &fit)
{
    if (records.empty() || fit.speeds.size() != records.size())
        return std::nullopt;
    const double window = std::max({samplePeriod(records.front().position), leastWindow, shareOfLag * fit.tau});
    if (fit.tau < leastWindows * window)
        return std::nullopt;
    LeastSquares<3> rows;
    std::size_t count = 0;
    for (std::size_t i = 0; i < records.size(); ++i) {
        const Trace &position = records[i].position;
        if (position.isEmpty() || std::abs(fit.speeds[i]) * window < leastCountsOfMean)
            return std::nullopt;
        const double begin = fit.delay + records[i].growth;
        const double sign = records[i].duty > 0.0 ? 1.0 : -1.0;
        std::optional<double> before;
        for (double t = begin; t + window <= position.t.back(); t += window) {
            const double mean = (valueAt(position, t + window) - valueAt(position, t)) / window;
            if (before) {
                rows.add({*before, records[i].duty, sign}, mean);
                ++count;
            }
            before = mean;
        }
    }
    const auto solution = count >= leastRows ? rows.solve() : std::nullopt;
    if (!solution || solution->values[0] <= 0.0 || solution->values[0] >= 1.0)
        return std::nullopt;
    return -window / std::log(solution->values[0]);
}

} // namespace mb::tuning
