// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/connection/recentvalues.h"

namespace mb {
namespace {

constexpr Duration recentSpan = std::chrono::seconds(10);

} // namespace

std::deque<double> recentValues(const DeviceView &device, std::string_view channel, Instant now)
{
    const auto found = device.telemetry->find(channel);
    std::deque<double> values;
    const Duration step = recentSpan / recentPoints;
    for (int i = 0; found && i < recentPoints; ++i) {
        const Instant time = now - recentSpan + step * (i + 1);
        const auto point = device.telemetry->at(*found, time);
        values.push_back(point && time - point->time < std::chrono::seconds(1) ? point->value : std::nan(""));
    }
    return values;
}

} // namespace mb
