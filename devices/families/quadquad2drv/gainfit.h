// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"

#include <vector>

namespace mb::quadquad2drv {

/// Positions of one run in the direction of its motion: seconds and counts from its start.
struct Track {
    std::vector<double> seconds;
    std::vector<double> counts;

    [[nodiscard]] std::size_t size() const { return seconds.size(); }
    /// Slope of the line through the samples of [from, to]; 0 with fewer than three.
    [[nodiscard]] double speed(double from, double to) const;
    [[nodiscard]] double end() const { return seconds.empty() ? 0.0 : seconds.back(); }
    /// The whole way.
    [[nodiscard]] double way() const { return counts.empty() ? 0.0 : counts.back() - counts.front(); }
};

/// A motor while it turns: lag · dv/dt + v = gain · (u − friction), u in power units.
struct Plant {
    double gain = 0.0;     ///< counts/s per power unit
    double friction = 0.0; ///< power units
    double lag = 0.0;      ///< s

    [[nodiscard]] double speedAt(double power) const { return gain * (power - friction); }
};

struct PowerStep {
    double power = 0.0; ///< units, positive
    double speed = 0.0; ///< counts/s in the direction of the power, at the end
    double lag = 0.0;   ///< s, by which the position is behind a motor without inertia
};
/// The line through the steps that moved (README.md#gain-scale). Refused with fewer than two, or when they lie on no line.
[[nodiscard]] Result<Plant> fitPlant(const std::vector<PowerStep> &steps);

/// What a run of a loop is compared with: `terms` of the gain in question times its raw value (counts, counts/s or their sums),
/// and the power of the gains that are known already.
struct Drive {
    std::vector<double> terms;
    std::vector<double> others; ///< power units; empty: none
    double most = 0.0;          ///< power units that the board never exceeds
};

struct ScaleFit {
    double scale = 0.0; ///< power units per term
    int samples = 0;
};
/// The scale whose power moves the plant as the track says, over the samples in which the motor turns and nothing limits it.
/// Refused when there are too few of them.
[[nodiscard]] Result<ScaleFit> fitScale(const Plant &plant, const Track &track, const Drive &drive);

/// Mean of scales found at several gains. Refused when they spread more than `tolerance`: then a gain is not a factor.
[[nodiscard]] Result<double> agreed(const std::vector<double> &scales, double tolerance);

} // namespace mb::quadquad2drv
