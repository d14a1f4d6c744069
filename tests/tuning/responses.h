// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/trace.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace mb::test {

/// Exact unit step response of a second-order system, 0 before t = 0.
inline double secondOrder(double damping, double frequency, double t)
{
    t = std::max(t, 0.0);
    const double decay = std::exp(-damping * frequency * t);
    if (damping >= 1.0)
        return 1.0 - std::exp(-frequency * t) * (1.0 + frequency * t);
    const double damped = frequency * std::sqrt(1.0 - damping * damping);
    return 1.0 - decay * (std::cos(damped * t) + damping * frequency / damped * std::sin(damped * t));
}

/// Samples of it every `period` from 0.3 s before the edge to 2 s after it, first one `phase` late, with white noise.
inline tuning::Trace sampledStep(
    double damping, double frequency, double period, double phase, double noise, std::mt19937_64 &random)
{
    tuning::Trace trace;
    std::normal_distribution<double> error(0.0, 1.0);
    const auto count = static_cast<int>(std::lround(2.3 / period));
    for (int i = 0; i < count; ++i) {
        const double t = -0.3 + phase + i * period;
        trace.add(t, secondOrder(damping, frequency, t) + noise * error(random));
    }
    return trace;
}

} // namespace mb::test
