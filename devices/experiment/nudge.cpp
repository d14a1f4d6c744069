// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/nudge.h"

#include "async/sleep.h"
#include "experiment/direction.h"
#include "experiment/raisedrates.h"
#include "model/family.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

namespace mb::tuning {
namespace {

using namespace std::chrono_literals;

constexpr Duration pushTime = 150ms;
constexpr Duration sendTime = 400ms; ///< of a move that ends by itself
constexpr Duration restTime = 300ms; ///< each is seen by itself
constexpr Duration longestNudge = 60s;
/// Less than a move has to begin; a line that loses some is silent for 200 ms before one.
constexpr Duration longestSilence = 280ms;
constexpr double firstNudge = 0.08;
constexpr double strongestNudge = 0.30;
constexpr double harderNudge = 1.4;
constexpr double timesTheCheck = 5.0; ///< of the move that checks the direction: to be seen from a step away
constexpr std::array<std::string_view, 1> guarded{"position"};
constexpr double unbounded = std::numeric_limits<double>::infinity(); ///< counts that end no push

/// Of a device whose short way `way` is a closed loop.
Task<void> guardWay(Device &device, SetPointStream &stream, TrialRecorder &recorder, int axis, double way)
{
    const TrialTraits &traits = *device.family().trials;
    GuardPlan guards;
    guards.envelope.travel = traits.nudgeTravel;
    guards.origin = recorder.latest("position").value_or(0.0);
    guards.lag = 0.0; // it stops by itself where it was sent
    guards.hottest = traits.hottest;
    guards.lowestBus = traits.lowestBus;
    guards.highestBus = traits.highestBus;
    guards.longest = longestNudge;
    guards.silence = longestSilence;
    guards.mostLost = 1.0;
    std::optional<Trip> trip;
    (void)co_await checkDirection(device, stream, recorder, axis, guards, trip, way);
    guards.envelope.travel = way + traits.nudgeTravel;
    guards.origin = recorder.latest("position").value_or(0.0);
    recorder.guard(guards);
    co_return {};
}

/// Where nobody knows whether it stands, none follows.
Task<double> turn(Device &device, SetPointStream &stream, const TrialRecorder &recorder, const SetPoint &setPoint)
{
    auto pushing = push(device, stream, recorder, setPoint, unbounded, setPoint.relative ? sendTime : pushTime);
    const double moved = co_await std::move(pushing);
    if (!device.isSeenStopped())
        co_return fail(Fault::Unsafe, stream.reason());
    co_await Sleep(device.clock(), restTime);
    co_return moved;
}

Task<double> toAndFro(Device &device, SetPointStream &stream, TrialRecorder &recorder, int axis, double way)
{
    if (way > 0.0)
        co_await guardWay(device, stream, recorder, axis, way);
    SetPoint setPoint;
    setPoint.axis = axis;
    setPoint.mode = way > 0.0 ? Mode::Position : Mode::Duty;
    setPoint.relative = way > 0.0;
    double strength = way > 0.0 ? way : firstNudge;
    double moved = 0.0;
    for (bool last = false; !last && std::abs(moved) < leastNudged;
         strength = std::min(strength * harderNudge, strongestNudge)) {
        last = way > 0.0 || strength >= strongestNudge;
        setPoint.target = strength;
        ++setPoint.order;
        auto turning = turn(device, stream, recorder, setPoint);
        moved = co_await std::move(turning);
    }
    if (std::abs(moved) < leastNudged)
        co_return moved;
    for (int again = 0; again < 3; ++again) { // back, to and back
        setPoint.target = -setPoint.target;
        ++setPoint.order;
        (void)co_await turn(device, stream, recorder, setPoint);
    }
    co_return moved;
}

} // namespace

Task<double> nudge(Device &device, SetPointStream &stream, int axis, const ExperimentSurroundings &surroundings)
{
    const Interruptible user(surroundings.interruption, stream);
    const TrialTraits *const traits = device.family().trials;
    const double way = traits ? timesTheCheck * traits->nudge : 0.0;
    TrialRecorder recorder(device, stream, way > 0.0 ? Mode::Position : Mode::Duty, axis);
    RaisedRates rates(device);
    if (way > 0.0)
        co_await rates.raise(axis, traits->rate, surroundings, guarded);
    const Result<double> moved = co_await toAndFro(device, stream, recorder, axis, way).attempt();
    co_await rates.lower(surroundings);
    co_return moved;
}

} // namespace mb::tuning
