// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

#include <chrono>

namespace mb::tuning {

/// What a motion waits for, and how long at most.
struct MotionTimes {
    static constexpr Duration approachLimit = std::chrono::seconds(3);
    static constexpr Duration stillBefore = std::chrono::milliseconds(250);
    static constexpr Duration leastHold = std::chrono::milliseconds(400);
    static constexpr double levelShare = 0.5;
    static constexpr double restShare = 0.02;
    static constexpr double longestReturn = 5.0; ///< s
    /// Of a way back, over which it stays where it began: nothing but its next step waits.
    static constexpr double returnedShare = 0.35;
};

/// s from the beginning of a motion at rest to that of its stimulus, and from its end on until it is at X again, of what follows with
/// that lag (s) a duty whose stimulus is `length` s long; at most.
[[nodiscard]] double secondsBefore(double lag);
[[nodiscard]] double secondsAfter(double lag, double length);
/// s at X, or on the way there, of all repeats of such a stimulus together; at most with an endless lag.
[[nodiscard]] double secondsAtStart(double lag, double length, int repeat);
/// s of all of it, at most.
[[nodiscard]] double longestSeconds(double length, int repeat);

} // namespace mb::tuning
