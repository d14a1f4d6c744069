// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/effort.h"

#include <algorithm>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr double nearLimit = 0.98;
constexpr double window = 0.1; ///< s, of the mean that is no chatter

std::optional<double> chatterOf(const Trace &duty, double from, double to)
{
    double squares = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < duty.size(); ++i) {
        if (duty.t[i] < from || duty.t[i] > to)
            continue;
        const Trace around = duty.part(duty.t[i] - window / 2.0, duty.t[i] + window / 2.0);
        double mean = 0.0;
        for (const double value : around.y)
            mean += value / static_cast<double>(around.size());
        squares += (duty.y[i] - mean) * (duty.y[i] - mean);
        ++count;
    }
    return count > 0 ? std::optional(std::sqrt(squares / static_cast<double>(count))) : std::nullopt;
}

/// Each sample counts for the time to the next one.
double shareAbove(const Trace &duty, double level, double end)
{
    double above = 0.0;
    for (std::size_t i = 0; i < duty.size(); ++i) {
        const double next = i + 1 < duty.size() ? duty.t[i + 1] : end;
        above += std::abs(duty.y[i]) >= level ? next - duty.t[i] : 0.0;
    }
    return above / (end - duty.t.front());
}

} // namespace

void readEffort(Metrics &metrics, const Trace &current, const Trace &duty, double hold, double limit)
{
    const Trace drawn = current.part(0.0, hold);
    if (!drawn.isEmpty()) {
        const auto [least, most] = std::minmax_element(drawn.y.begin(), drawn.y.end());
        metrics.peakCurrent = std::max(std::abs(*least), std::abs(*most));
    }
    const Trace driven = duty.part(0.0, hold);
    if (driven.isEmpty())
        return;
    metrics.dutyChatter = chatterOf(driven, 0.75 * hold, hold);
    if (driven.t.front() < hold)
        metrics.saturated = shareAbove(driven, nearLimit * limit, hold);
}

} // namespace mb::tuning
