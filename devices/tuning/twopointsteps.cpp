// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/twopointsteps.h"

#include "experiment/figures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace mb::tuning {
namespace {

constexpr double smallestStep = 60.0;   ///< counts, of the smallest step
constexpr double larger = 4.0;          ///< times, of steps that play spoils
constexpr double fewestP = 10.0;        ///< raw
constexpr double fewestDamping = 8.0;   ///< D for 1 of P, where the unit has none
constexpr double easyFriction = 0.15;   ///< of what P makes of a step
constexpr double mostGrowth = 2.5;      ///< of steps whose output is not known, where friction takes more of them
constexpr double shareOfCurrent = 0.7;  ///< of its limit, that P makes a step draw
constexpr double breakawayOver = 1.4;   ///< times friction, of what was seen to move it
constexpr double easilyDrawn = 0.6;     ///< of what its current allows, from which on it is led
constexpr double gentlestP = 12.0;      ///< raw, that its steps are still fine enough of
constexpr double gentleCounts = 2000.0; ///< of a step that is led
constexpr double fastestProfile = 1e6;  ///< counts/s
constexpr double rateShare = 0.8;       ///< of its current limit, that D makes of a profile that begins

/// A motor that draws more than it may long before its output is at its end: P makes less than that of its steps, D less than a tenth of
/// it of a count, and a profile leads to their ends, for of the edge of a step D makes more than P.
Result<TwoPointSteps> gentleSteps(const StepGround &ground)
{
    TwoPointSteps steps;
    const double most = ground.mostDrive();
    const double counts = std::min({gentleCounts, ground.room, most / gentlestP});
    steps.first.p = std::clamp(std::round(most / counts), 1.0, ground.stored.p);
    steps.drive = std::min(most, steps.first.p * ground.room);
    if (const double friction = ground.moves.push / breakawayOver; friction > steps.mostFriction * steps.drive)
        return fail(Fault::OutOfRange,
            say("friction takes %1 of what its current limit and its room allow, at most 60 %",
                percentText(friction / steps.drive)),
            say("see whether the motor is too strong for this unit"));
    const double likely = 0.5 * ground.stored.d * std::sqrt(steps.first.p / ground.stored.p);
    const double stiffest = steps.noiseShare * *ground.envelope.current / ground.moves.current;
    steps.first.d
        = std::round(std::clamp(std::min(likely, stiffest / steps.damper), 1.0, steps.mostRaw / steps.damper));
    steps.isLed = true;
    steps.rate = ground.profileRate(steps.first.d);
    return steps;
}

} // namespace

double StepGround::mostDrive() const
{
    return envelope.current && moves.current > 0.0 ? shareOfCurrent * *envelope.current / moves.current
                                                   : std::numeric_limits<double>::infinity();
}

double StepGround::profileRate(double d) const
{
    const double drawn = moves.current * TwoPointSteps::damper * d * cycle; // A for 1 count/s
    return std::round(std::min(rateShare * *envelope.current / drawn, envelope.speed.value_or(fastestProfile)));
}

Result<TwoPointSteps> TwoPointSteps::chosenFrom(const StepGround &ground)
{
    TwoPointSteps steps;
    RawGains &first = steps.first;
    if (ground.isKnown) {
        steps.drive = tried * ground.full * ground.envelope.duty.value_or(1.0);
        const double step = std::min(firmer * smallestStep, ground.room);
        first.p = std::clamp(std::round(std::min(steps.drive / step, ground.stored.p)), 1.0, mostRaw / firmer);
        first.d = ground.stored.d * std::sqrt(first.p / ground.stored.p);
    } else {
        const double most = ground.mostDrive();
        first.p = std::max(std::round(ground.stored.p / firmer), 1.0);
        first.d = ground.stored.d / damper;
        steps.drive = firmer * first.p * trustedCounts;
        if (steps.drive >= easilyDrawn * most)
            return gentleSteps(ground);
        const double clear = ground.moves.push / breakawayOver / easyFriction;
        steps.isGrown = clear > steps.drive;
        steps.drive = std::min(std::clamp(clear, steps.drive, mostGrowth * steps.drive), most);
    }
    steps.drive = std::min(steps.drive, first.p * ground.room);
    if (steps.drive < firmer * first.p * leastRoom)
        return fail(Fault::OutOfRange,
            say("there is not enough room: its limits leave steps of %1 counts",
                numberText(std::round(steps.drive / (firmer * first.p)))),
            say("allow more travel"));
    const double least = ground.stored.d > 0.0 ? 1.0 : fewestDamping * first.p;
    first.d = std::round(std::clamp(first.d, least, mostRaw / damper));
    return steps;
}

bool TwoPointSteps::grow(const StepGround &ground, double held)
{
    if (ground.isKnown || isGrown || held <= easyFriction)
        return false;
    drive = std::min({drive * std::min(held / easyFriction, mostGrowth), first.p * ground.room, ground.mostDrive()});
    isGrown = true;
    return true;
}

bool TwoPointSteps::enlarge(const StepGround &ground)
{
    const double weaker = std::round(first.p / larger);
    if (std::exchange(isEnlarged, true) || weaker < fewestP || drive / weaker > ground.room)
        return false;
    first = {weaker, std::max(std::round(first.d / std::sqrt(larger)), 1.0)};
    return true;
}

} // namespace mb::tuning
