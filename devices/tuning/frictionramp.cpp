// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/frictionramp.h"

#include "experiment/figures.h"
#include "experiment/seconds.h"
#include "model/family.h"
#include "tuning/autotunerun.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr double rampOverFriction = 3.5; ///< times, up to which a ramp goes
constexpr double rampOverHeld = 1.5;     ///< the same of a duty that did not move it
constexpr double leastRampTop = 0.04;    ///< duty
constexpr double rampSeconds = 2.0;
constexpr double rampTravel = 0.75; ///< of the travel
constexpr double rampRollsOn = 1.25;
constexpr double timeForRamps = 35.0;    ///< s, with the proofs that come after them
constexpr double mostRampDoubt = 0.15;   ///< of friction, that its ± may be,
constexpr double leastRampDoubt = 0.004; ///< or duty
constexpr double heldOverFriction = 1.5; ///< times, that a duty which hardly moves it may be
constexpr double mostRampOffset = 0.1;   ///< of friction, that a load may be
constexpr double digitsOfVolts = 1000.0;

/// In V where the supply is told.
MessageNumber rampNumber(const MotorFound &found, double duty)
{
    return found.supply > 0.0 ? MessageNumber{std::round(duty * found.supply * digitsOfVolts) / digitsOfVolts, -1, "V"}
                              : percentText(duty);
}

} // namespace

void takeRamp(MotorFound &found, const RampFound &ramp)
{
    found.ramp = ramp;
    if (!ramp.agreesWith(found.line.gain))
        return;
    const double beside = std::abs(found.line.friction - ramp.friction());
    found.line.friction = ramp.friction();
    found.line.frictionError = std::max(ramp.error(), 0.5 * beside);
}

/// Both ways in turn: it ends where it has begun.
Task<void> FrictionRamp::run(AutotuneRun &run, MotorFound &found)
{
    m_top = std::min(
        std::max({rampOverFriction * found.line.friction, rampOverHeld * m_held, leastRampTop}), m_strongest);
    if (!isWanted(run, found))
        co_return {};
    if (!hasRoom(run, found)) {
        run.note(say("there is no room for a duty that grows slowly"));
        co_return {};
    }
    const double beat = inSeconds(run.device().family().trials->glideBeat);
    const RampedMotor motor{found.pushes.tau, found.pushes.delay, beat, found.restNoise.value_or(0.0), found.supply};
    std::array<std::optional<RampWay>, 2> ways;
    for (const bool forward : {true, false}) {
        AutotuneRun::Push push{forward ? m_top : -m_top, rampSeconds};
        push.grows = true;
        const Trial trial = co_await run.push(push);
        if (run.isOver())
            co_return {};
        ways[forward ? 0 : 1] = readRamp(trial, motor);
    }
    if (ways[0] && ways[1])
        takeRamp(found, {*ways[0], *ways[1]});
    else
        run.note(say("a duty that grew to %1 did not move the motor both ways", percentText(m_top)));
    co_return {};
}

/// A whole tuning takes the time where friction is hardly known, a load pulls one way, or a push that was stronger than friction did not move
/// the motor.
bool FrictionRamp::isWanted(const AutotuneRun &run, const MotorFound &found) const
{
    const GainFit &line = found.line;
    const bool isVague = line.frictionError > std::max(mostRampDoubt * line.friction, leastRampDoubt);
    const bool isLoaded = std::abs(line.offset) > line.offsetError + mostRampOffset * line.friction;
    const bool sticks = m_held > heldOverFriction * line.friction;
    return run.plan().propose || ((isVague || isLoaded || sticks) && run.left() >= timeForRamps);
}

bool FrictionRamp::hasRoom(const AutotuneRun &run, const MotorFound &found) const
{
    const auto travel = run.travelLeft();
    const double beyond = std::max(m_top - found.line.friction, 0.0);
    const double way = 0.5 * found.line.gain * beyond * beyond / m_top * rampSeconds;
    return !travel || rampRollsOn * way <= rampTravel * *travel;
}

std::optional<Gate> rampGate(const MotorFound &found)
{
    if (!found.ramp)
        return std::nullopt;
    const RampFound &ramp = *found.ramp;
    const auto told = [&found](double duty) { return rampNumber(found, duty); };
    Gate gate{"ramp",
        say("it lets go at %1 forwards and %2 backwards, known within %3, and takes %4 and %5 while it turns (R² %6)",
            told(ramp.forward.breakaway), told(ramp.reverse.breakaway),
            told(std::max(ramp.forward.breakawayError, ramp.reverse.breakawayError)), told(ramp.forward.friction),
            told(ramp.reverse.friction), std::round(ramp.determination() * 1e4) / 1e4),
        true, {}};
    gate.warns = !ramp.agreesWith(found.line.gain);
    return gate;
}

} // namespace mb::tuning
