// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/adviser.h"

#include "model/family.h"
#include "tuning/evidence.h"
#include "tuning/gainrules.h"

#include <algorithm>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr double notableOvershoot = 0.05;
constexpr double shortBy = 2.0;         ///< that are left over
constexpr double mostLeap = 0.1;        ///< of full duty, by one count
constexpr double slowRamp = 0.5;        ///< of the rise
constexpr double leastAtLimit = 0.02;   ///< s
constexpr double latestVelocity = 0.03; ///< s
constexpr double latestMove = 0.06;     ///< s
constexpr double leastHolding = 0.02;   ///< duty
constexpr double leastPlay = 3.0;       ///< counts
constexpr int leastTurns = 4;
constexpr double calmer = 0.6; ///< of P and I, where the loop is later than it looks

using Changes = std::vector<std::pair<std::string, double>>;

void add(std::vector<Advice> &all, Cause cause, double number, double weight, Changes changes)
{
    all.push_back({cause, number, weight, std::move(changes)});
}

/// P and I smaller together, so that the loop keeps its shape.
Changes scaled(const Evidence &seen, double factor)
{
    Changes changes;
    for (const Role role : {Role::Proportional, Role::Integral}) {
        if (seen.gain(role) != 0.0)
            changes.emplace_back(seen.key(role), seen.gain(role) * factor);
    }
    return changes;
}

/// The least output that overcomes friction, where the drive has one.
Changes nominal(const Evidence &seen, double duty)
{
    Changes changes;
    for (const Role role : {Role::LeastForward, Role::LeastReverse}) {
        if (!seen.key(role).empty())
            changes.emplace_back(seen.key(role),
                std::round(helpOverFriction * std::abs(duty) * seen.scale()->fullDuty)
                    * (role == Role::LeastReverse ? -1.0 : 1.0));
    }
    return changes;
}

void adviseOnFeedForward(const Evidence &seen, std::vector<Advice> &all)
{
    const auto product = seen.feedForwardTimesGain();
    if (seen.trial().mode != Mode::Velocity || seen.gain(Role::Integral) == 0.0 || !product
        || *product < mostFeedForward || seen.overshoot() < notableOvershoot)
        return;
    add(all, Cause::FeedForward, *product, *product / mostFeedForward, {{seen.key(Role::FeedForward), 0.0}});
}

void adviseOnDeadband(const Evidence &seen, std::vector<Advice> &all)
{
    const auto left = seen.countsLeft();
    const auto duty = seen.dutyAtEnd();
    if (seen.trial().mode != Mode::Position || seen.gain(Role::Integral) != 0.0 || !left || std::abs(*left) <= shortBy
        || !duty || *duty * *left <= 0.0) // it pushes the right way, and nothing moves
        return;
    Changes changes = seen.scale() ? nominal(seen, *duty) : Changes();
    if (changes.empty())
        changes.emplace_back(
            seen.key(Role::Proportional), seen.gain(Role::Proportional) * std::min(4.0, std::abs(*left) / shortBy));
    add(all, Cause::Deadband, std::abs(*left), std::abs(*left) / shortBy, std::move(changes));
}

void adviseOnResolution(const Evidence &seen, std::vector<Advice> &all)
{
    double fewest = leastGainSteps;
    for (const Role role : {Role::Proportional, Role::Integral, Role::Derivative}) {
        const auto steps = seen.stepsOf(role);
        if (steps && *steps > 0.0)
            fewest = std::min(fewest, *steps);
    }
    if (fewest == leastGainSteps)
        return;
    Changes changes;
    if (!seen.key(Role::Divisor).empty()) { // the same loop in finer steps
        constexpr double finer = 10.0;
        for (const Role role : {Role::Divisor, Role::Proportional, Role::Integral, Role::Derivative})
            changes.emplace_back(seen.key(role), seen.gain(role) * finer);
    }
    add(all, Cause::Resolution, fewest, leastGainSteps / fewest, std::move(changes));
}

void adviseOnNoise(const Evidence &seen, std::vector<Advice> &all)
{
    const auto leap = seen.leapOfOneCount();
    if (!leap || *leap <= mostLeap)
        return;
    add(all, Cause::DerivativeNoise, *leap, *leap / mostLeap,
        {{seen.key(Role::Derivative), seen.gain(Role::Derivative) * mostLeap / *leap}});
}

void adviseOnRamp(const Evidence &seen, std::vector<Advice> &all)
{
    const auto time = seen.rampTime();
    const auto rise = seen.trial().metrics.rise;
    if (!time || !rise || *time <= slowRamp * *rise)
        return;
    add(all, Cause::Ramp, *time, *time / (slowRamp * *rise), {{seen.key(Role::Ramp), 0.0}});
}

void adviseOnLimit(const Evidence &seen, std::vector<Advice> &all)
{
    const double time = seen.timeAtLimit();
    if (time < leastAtLimit)
        return;
    const bool wound = seen.gain(Role::Integral) != 0.0 && seen.overshoot() >= notableOvershoot;
    if (wound) {
        Changes changes{{seen.key(Role::Integral), seen.gain(Role::Integral) / 2.0}};
        if (const auto zone = seen.errorAfterLimit(); zone && !seen.key(Role::IntegralZone).empty())
            changes = {{seen.key(Role::IntegralZone), std::max(1.0, std::round(*zone))}};
        add(all, Cause::Windup, time, time / leastAtLimit, std::move(changes));
        return;
    }
    const auto demand = seen.demandOfStep();
    const double limit = seen.trial().envelope.duty.value_or(1.0);
    add(all, Cause::Saturation, time, time / leastAtLimit,
        demand && *demand > limit ? scaled(seen, limit / *demand) : Changes());
}

/// A velocity that comes anew only so often is late, too: the rarer cause is the one to name.
void adviseOnVelocity(const Evidence &seen, std::vector<Advice> &all)
{
    if (seen.trial().mode != Mode::Velocity)
        return;
    const auto hold = seen.velocityHold();
    const auto late = seen.velocityDelay();
    const bool lively = seen.overshoot() >= notableOvershoot;
    const Changes changes = lively ? scaled(seen, calmer) : Changes();
    if (hold && *hold > latestVelocity)
        add(all, Cause::BlockVelocity, *hold, *hold / latestVelocity, changes);
    else if (late && *late > latestVelocity && lively) // of a loop that does not overshoot it explains nothing
        add(all, Cause::FilterDelay, *late, *late / latestVelocity, changes);
}

void adviseOnFriction(const Evidence &seen, std::vector<Advice> &all)
{
    const auto start = seen.startOfMotion();
    const double usual = std::max(latestMove, seen.trial().metrics.rise.value_or(0.0) / 4.0);
    if (!start || start->time <= usual)
        return;
    Changes changes = seen.scale() ? nominal(seen, start->duty) : Changes();
    if (changes.empty() && seen.gain(Role::Integral) != 0.0)
        changes.emplace_back(seen.key(Role::Integral), seen.gain(Role::Integral) * 1.5);
    add(all, Cause::Friction, std::abs(start->duty), start->time / usual, std::move(changes));
}

void adviseOnGravity(const Evidence &seen, std::vector<Advice> &all)
{
    const auto before = seen.dutyBefore();
    const auto after = seen.dutyAtEnd();
    if (seen.trial().mode != Mode::Position || !before || !after || *before * *after <= 0.0
        || std::min(std::abs(*before), std::abs(*after)) < leastHolding)
        return;
    const double holding = (*before + *after) / 2.0;
    Changes changes;
    const auto rise = seen.trial().metrics.rise;
    if (seen.gain(Role::Integral) == 0.0 && seen.scale() && rise && *rise > 0.0) // resets in four times the rise
        changes.emplace_back(
            seen.key(Role::Integral), seen.gain(Role::Proportional) * seen.scale()->period / (4.0 * *rise));
    add(all, Cause::Gravity, holding, std::abs(holding) / leastHolding, std::move(changes));
}

void adviseOnBacklash(const Evidence &seen, std::vector<Advice> &all)
{
    const auto swing = seen.swingAtEnd();
    if (seen.trial().mode != Mode::Position || !swing || swing->counts < leastPlay || swing->turns < leastTurns)
        return;
    Changes changes;
    if (!seen.key(Role::AllowableError).empty())
        changes.emplace_back(seen.key(Role::AllowableError), std::ceil(swing->counts / 2.0));
    else if (seen.gain(Role::Integral) != 0.0)
        changes.emplace_back(seen.key(Role::Integral), seen.gain(Role::Integral) / 2.0);
    add(all, Cause::Backlash, swing->counts, swing->counts / leastPlay, std::move(changes));
}

} // namespace

std::string_view toString(Cause cause)
{
    switch (cause) {
    case Cause::FeedForward: return "feed-forward";
    case Cause::Deadband: return "deadband";
    case Cause::Resolution: return "resolution";
    case Cause::DerivativeNoise: return "derivative-noise";
    case Cause::Ramp: return "ramp";
    case Cause::Saturation: return "saturation";
    case Cause::Windup: return "windup";
    case Cause::FilterDelay: return "filter-delay";
    case Cause::BlockVelocity: return "block-velocity";
    case Cause::Friction: return "friction";
    case Cause::Gravity: return "gravity";
    case Cause::Backlash: return "backlash";
    }
    return {};
}

std::vector<Advice> advise(const Family &family, const Trial &trial)
{
    std::vector<Advice> all;
    if (trial.stimulus.profile != Profile::Step && trial.stimulus.profile != Profile::Square)
        return all;
    const Evidence seen(family, trial);
    for (const auto advise : {adviseOnFeedForward, adviseOnDeadband, adviseOnResolution, adviseOnNoise, adviseOnRamp,
             adviseOnLimit, adviseOnVelocity, adviseOnFriction, adviseOnGravity, adviseOnBacklash})
        advise(seen, all);
    std::ranges::stable_sort(all, [](const Advice &a, const Advice &b) { return a.weight > b.weight; });
    return all;
}

} // namespace mb::tuning
