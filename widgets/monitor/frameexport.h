// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"
#include "async/wallclock.h"
#include "traffic/trafficlog.h"

#include <QString>

#include <functional>
#include <string>

namespace mb {

/// One record as text: a line of candump -L, or `(t) LINK tx|rx HEX…` for bytes, as `motorbenchctl monitor` prints them.
/// `clock` turns the time stamp into the time of the text.
[[nodiscard]] std::string trafficLine(const TrafficRecord &record, const std::string &link, const WallClock &clock);

/// Writes `count` records, which `at` hands out in order, as such lines. The file appears only when all of it is written.
[[nodiscard]] Result<void> exportTraffic(const QString &path, int count,
    const std::function<const TrafficRecord &(int)> &at, const std::string &link, const WallClock &clock);

} // namespace mb
