// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"
#include "experiment/envelope.h"
#include "tuning/firstmotion.h"
#include "tuning/rawstep.h"

namespace mb::tuning {

/// What the steps of a two-point identification are chosen from.
struct StepGround {
    RawGains stored;      ///< before the tuning; P at least 1
    bool isKnown = false; ///< what raw gains make is: `full`
    double full = 0.0;    ///< raw P times counts of full output
    double cycle = 0.0;   ///< s between two passes of its loop
    double room = 0.0;    ///< counts that a step may go
    Envelope envelope;
    FirstMotion moves; ///< where its gains have an unknown scale

    /// Raw P times counts that its current allows; infinite where that is not known.
    [[nodiscard]] double mostDrive() const;
    /// counts/s of a profile with which what this D makes of its beginning draws less than the limit.
    [[nodiscard]] double profileRate(double d) const;
};

/// Gains and sizes of these steps.
struct TwoPointSteps {
    /// P of the second and third point, of the first; D of the third.
    static constexpr double firmer = 2.5;
    static constexpr double damper = 2.0;
    static constexpr double leastRoom = 20.0;      ///< counts, of the smallest step
    static constexpr double tried = 0.5;           ///< of full output that P makes of each step
    static constexpr double trustedCounts = 200.0; ///< of the smallest step where nobody knows what full output is
    static constexpr double mostRaw = 30000.0;     ///< of a gain
    static constexpr double noiseShare = 0.1;      ///< of full output that one count may make through D
    static constexpr double mostFriction = 0.6;    ///< of what P makes of a step

    RawGains first;          ///< the calmest that is tried
    double drive = 0.0;      ///< raw P times counts of each step
    double rate = 0.0;       ///< counts/s, at which the unit's profile leads to the targets; 0: they are steps
    bool isLed = false;      ///< by the unit's own profile, at `rate`
    bool isGrown = false;    ///< they were made larger because friction took much of them
    bool isEnlarged = false; ///< it was asked for larger ones because play took much of them

    /// OutOfRange where room or current leave too little.
    [[nodiscard]] static Result<TwoPointSteps> chosenFrom(const StepGround &ground);
    /// More drive where friction held so much of it (share), once; false where that is little, or where the output is known.
    [[nodiscard]] bool grow(const StepGround &ground, double held);
    /// Steps in which play and whole counts are less: the same output of a weaker P, once; false where there is no room.
    [[nodiscard]] bool enlarge(const StepGround &ground);
};

} // namespace mb::tuning
