// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/experiment.h"

#include <array>
#include <span>
#include <vector>

namespace mb::tuning {

/// Steps of several sizes in both directions, one guarded experiment each: gains that hold at one size may not at another, where friction
/// or the supply has a greater share.
struct Battery {
    std::vector<ExperimentPlan> steps; ///< small ones first, each size forwards and backwards
};

/// Five sizes up to that of `largest`, whose gains and slot hold for all; in a position loop around `here`, counts. `counted`: each
/// step counts from its own start (Capabilities::zeroPosition).
[[nodiscard]] Battery batteryOf(const ExperimentPlan &largest, double here, bool counted);

/// Of each metric the worst of the trials, and which trial it was: of the time to settle one that did not settle, which has none.
struct BatteryWorst {
    Metrics metrics;
    std::array<std::optional<std::size_t>, 11> where; ///< in the order of metricKeys()
};
[[nodiscard]] BatteryWorst worstOf(std::span<const Trial> trials);

} // namespace mb::tuning
