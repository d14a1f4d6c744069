// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/announcement.h"

#include "experiment/direction.h"
#include "experiment/experimentmotion.h"
#include "experiment/figures.h"
#include "experiment/guards.h"
#include "experiment/motiontimes.h"
#include "model/family.h"
#include "model/trialtraits.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mb::tuning {
namespace {

constexpr double beyondTarget = 1.5; ///< gains that turn out too lively go half as far again
constexpr double rollsOn = 1.25;     ///< of a push, while it brakes
constexpr double significant = 100.0;

std::optional<double> least(std::optional<double> a, std::optional<double> b)
{
    return a && b ? std::min(*a, *b) : a ? a : b;
}

/// Which its guard lets pass.
std::optional<double> stopSpeed(const Envelope &bounds)
{
    return bounds.speed ? std::optional(speedMargin * *bounds.speed) : std::nullopt;
}

/// Upwards to two figures: a bound is no measurement.
double roundedUp(double value)
{
    if (value <= 0.0)
        return 0.0;
    const double unit = std::pow(10.0, std::floor(std::log10(value))) / significant * 10.0;
    const double steps = std::ceil(value / unit);
    return unit < 1.0 ? steps / std::round(1.0 / unit) : steps * unit; // not 3.8000000000000003
}

std::optional<double> speedOf(const ExperimentPlan &plan, double target, double duty, double gain)
{
    if (plan.mode == Mode::Velocity)
        return beyondTarget * target;
    return gain > 0.0 ? std::optional(gain * (plan.mode == Mode::Duty ? target : duty)) : std::nullopt;
}

/// Pushes go on where the one before has ended; a set-point of speed is followed until its end, and once more on the way back to X,
/// whose own is `atStart`.
std::optional<double> travelOf(const ExperimentPlan &plan, const Stimulus &stimulus, double place,
    std::optional<double> speed, std::optional<double> atStart, double lag)
{
    if (plan.mode == Mode::Position)
        return beyondTarget * std::max(std::abs(stimulus.from - place), std::abs(stimulus.to - place));
    if (plan.reach)
        return (rollsOn * *plan.reach + speed.value_or(0.0) * std::max(lag - stopLag, 0.0)) * plan.repeat;
    if (!speed || !atStart)
        return std::nullopt;
    const double endless = std::numeric_limits<double>::infinity();
    return rollsOn * *speed * stimulus.length() * plan.repeat
        + *atStart * secondsAtStart(endless, stimulus.length(), plan.repeat);
}

void announceDirection(const Device &device, const ExperimentSurroundings &surroundings, const ExperimentPlan &plan,
    const Envelope &envelope, double gone)
{
    if (!isClosedLoop(plan.mode) || !surroundings.directions
        || surroundings.directions->find(device.selector(), plan.axis))
        return;
    const TrialTraits &traits = *device.family().trials;
    const bool isSent = traits.nudge > 0.0;
    Extent extent = extentOf(envelope);
    extent.duty = isSent ? extent.duty : largestOfDirection(envelope);
    extent.travel = isSent ? least(extent.travel, traits.nudgeTravel) : envelope.travel.value_or(0.0) + std::abs(gone);
    if (const double gain = plan.announced.value_or(0.0); gain > 0.0)
        extent.speed = least(extent.speed, gain * extent.duty);
    surroundings.note(joined(isSent ? say("first its direction is checked: %1 counts up", traits.nudge)
                                    : say("first its direction is checked: pushes of 0.3 s, until it turns"),
        textOf(extent)));
}

} // namespace

Extent extentOf(const ExperimentPlan &plan, const Trial &trial, double origin, double gain, double lag, double gone)
{
    const Envelope &envelope = trial.envelope;
    const Stimulus &stimulus = trial.stimulus;
    const double start = std::abs(stimulus.from);
    const double most = std::max(start, std::abs(stimulus.to));
    Extent extent;
    extent.duty = plan.mode == Mode::Duty ? most : envelope.duty.value_or(1.0);
    extent.speed = least(speedOf(plan, most, extent.duty, gain), stopSpeed(envelope));
    const auto atStart = start > 0.0 ? least(speedOf(plan, start, extent.duty, gain), extent.speed) : 0.0;
    extent.travel = travelOf(plan, stimulus, origin + gone, extent.speed, atStart, lag);
    if (envelope.travel)
        extent.travel = least(extent.travel, *envelope.travel + std::abs(gone));
    return extent;
}

Extent extentOf(const Envelope &bounds)
{
    return {bounds.duty.value_or(1.0), stopSpeed(bounds), bounds.travel};
}

Message textOf(const Extent &extent)
{
    const double travel = roundedUp(extent.travel.value_or(0.0)); // without a bound of it nothing moves
    return extent.speed ? say("at most %1 duty, %2 counts/s and %3 counts from where it stands",
               percentText(extent.duty), roundedUp(*extent.speed), travel)
                        : say("at most %1 duty and %2 counts from where it stands, at a speed that nobody knows yet",
                            percentText(extent.duty), travel);
}

void announce(const Device &device, const ExperimentSurroundings &surroundings, const ExperimentPlan &plan,
    const Trial &trial, double origin, double gone)
{
    if (plan.limits.current && !trial.envelope.current)
        surroundings.caution(
            say("the unit tells no current in ampere: the duty limit stands in for %1 A", *plan.limits.current));
    if (!surroundings.note)
        return;
    announceDirection(device, surroundings, plan, trial.envelope, gone);
    const double lag = surroundings.directions ? surroundings.directions->lag(device.selector(), plan.axis) : 0.0;
    surroundings.note(textOf(extentOf(plan, trial, origin, plan.announced.value_or(0.0), lag, gone)));
}

} // namespace mb::tuning
