// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/trial.h"

#include <string_view>
#include <vector>

namespace mb {
struct Family;
}

namespace mb::tuning {

constexpr double mostFeedForward = 0.3;   ///< F·K beside an active I; 0.5 has overshot by 6 to 13 %
constexpr double helpOverFriction = 1.25; ///< least output that is advised, over friction

/// What may be behind a response that is not as it should be.
enum class Cause {
    FeedForward,     ///< F as large as the loop needs, and I: the initial lag is paid back. Number: F·K
    Deadband,        ///< P alone does not overcome friction. Number: counts that are left
    Resolution,      ///< a gain of a few steps of its integer. Number: steps
    DerivativeNoise, ///< one count of the sensor makes a large leap of the duty. Number: fraction of full duty
    Ramp,            ///< the drive's own ramp is slower than the loop. Number: seconds to full duty
    Saturation,      ///< the duty was at its limit. Number: seconds
    Windup,          ///< and I went on meanwhile. Number: seconds of it before an overshoot
    FilterDelay,     ///< the measured velocity is late. Number: seconds
    BlockVelocity,   ///< it comes anew only so often. Number: seconds between two values
    Friction,        ///< the motor moves late. Number: duty at which it began to
    Gravity,         ///< a duty is needed to stay in place. Number: duty, signed
    Backlash         ///< position swings without end while the duty changes its sign. Number: counts from end to end
};
[[nodiscard]] std::string_view toString(Cause cause);

/// One cause with its number, and the values to try instead: to be staged, never written by itself.
struct Advice {
    Cause cause = Cause::Saturation;
    double number = 0.0;
    double weight = 0.0;                                 ///< how far it is beyond what is usual: 1 is just notable
    std::vector<std::pair<std::string, double>> changes; ///< by parameter key; empty: nothing a value can do

    friend bool operator==(const Advice &, const Advice &) = default;
};

/// What the numbers of one trial say, weightiest first. Needs the trial's signals; what was not recorded, or what the gains of
/// this family are not known to mean, is not judged. Pure.
[[nodiscard]] std::vector<Advice> advise(const Family &family, const Trial &trial);

} // namespace mb::tuning
