// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/motiontimes.h"

#include "experiment/seconds.h"

#include <algorithm>
#include <cmath>

namespace mb::tuning {

double secondsBefore(double lag)
{
    const double settles = std::log(1.0 / (2.0 * MotionTimes::restShare)) / (1.0 - MotionTimes::levelShare) * lag;
    return std::min(std::max(settles, inSeconds(MotionTimes::stillBefore)), inSeconds(MotionTimes::approachLimit))
        + inSeconds(MotionTimes::stillBefore);
}

double secondsAfter(double lag, double length)
{
    const double settles = std::log(1.0 / MotionTimes::restShare) / (1.0 - MotionTimes::returnedShare) * lag;
    return std::min(std::max(settles, inSeconds(MotionTimes::leastHold)), std::min(length, MotionTimes::longestReturn));
}

double secondsAtStart(double lag, double length, int repeat)
{
    const double once = inSeconds(MotionTimes::stillBefore) + secondsAfter(lag, length);
    return secondsBefore(lag) - inSeconds(MotionTimes::stillBefore) + once * repeat;
}

double longestSeconds(double length, int repeat)
{
    const double once
        = 2.0 * inSeconds(MotionTimes::stillBefore) + length + std::min(length, MotionTimes::longestReturn);
    return inSeconds(MotionTimes::approachLimit) + once * repeat;
}

} // namespace mb::tuning
