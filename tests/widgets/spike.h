// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plots/tracesource.h"

#include <vector>

namespace mb::test {

/// A second of zeros with one other value in it.
inline std::vector<PlotPoint> flatWithSpike(int count, int spikeAt, double spike)
{
    std::vector<PlotPoint> points;
    for (int i = 0; i < count; ++i)
        points.push_back({i * 1.0 / count, i == spikeAt ? spike : 0.0});
    return points;
}

} // namespace mb::test
