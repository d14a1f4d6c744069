// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/direction.h"

#include "async/sleep.h"
#include "experiment/envelope.h"
#include "experiment/experimentplan.h"
#include "model/axis.h"
#include "model/family.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace mb::tuning {
namespace {

using namespace std::chrono_literals;

constexpr double firstDuty = 0.08;
constexpr double harder = 1.5;
constexpr double mostDuty = 0.6;
constexpr Duration pulse = 300ms;
constexpr Duration nudgeTime = 1s;
constexpr Duration patience = 300ms; ///< until it has begun to go where it was sent
constexpr double clearMove = 15.0;   ///< counts
constexpr double leastNudge = 3.0;   ///< counts; friction holds the rest
constexpr Duration glancePeriod = 5ms;
constexpr Duration stopAgain = 100ms;
constexpr Duration restLimit = 5s;
constexpr Duration restSpan = 100ms;
constexpr Duration untoldTime = 1s; ///< without a position
constexpr double restCounts = 3.0;

std::string keyOf(const Device &device, int axis)
{
    return directionKey(device.family().capabilities.axes > 1 ? axis : 0);
}

tl::unexpected<Error> wrong(Device &device, int axis, std::optional<Trip> &trip, EndReason guard, Message detail)
{
    if (guard != EndReason::Link)
        device.knowledge().setVerdict(keyOf(device, axis),
            guard == EndReason::NoMotion ? DirectionVerdict::NoMotion : DirectionVerdict::Reversed);
    trip = Trip{guard, detail, device.clock().now()};
    return fail(Fault::Unsafe, std::move(detail));
}

/// Where an axis was seen, and since when.
struct Place {
    Place(const Telemetry &telemetry, ChannelIndex of, Instant begin)
        : channel(of)
        , since(begin)
    {
        if (const auto newest = telemetry.latest(channel)) {
            counts = newest->value;
            told = newest->time;
        }
    }
    ChannelIndex channel;
    std::optional<double> counts{};
    Instant since;
    Instant told{};

    /// What was silent since may have gone anywhere.
    [[nodiscard]] bool rests(Instant now) const
    {
        return counts && now - since >= restSpan && told - since >= restSpan / 2;
    }
    void look(const Telemetry &telemetry, Instant now)
    {
        const auto newest = telemetry.latest(channel);
        if (!newest || newest->time <= told)
            return;
        told = newest->time;
        if (counts && std::abs(newest->value - *counts) <= restCounts)
            return;
        counts = newest->value;
        since = now;
    }
};

/// Whether a motor did not move can be said only of one that still tells where it is.
bool isHeard(const Device &device, int axis)
{
    const auto channel = axisChannel(device, "position", axis);
    const auto newest = channel ? device.telemetry()->latest(*channel) : std::nullopt;
    return newest && device.clock().now() - newest->time <= untoldTime;
}

tl::unexpected<Error> silent(Device &device, int axis, std::optional<Trip> &trip)
{
    return wrong(device, axis, trip, EndReason::Link, say("%1 does not answer", device.selector()));
}

std::vector<Place> placesOf(const Device &device, std::optional<int> axis)
{
    const Telemetry &telemetry = *device.telemetry();
    const Instant begin = device.clock().now();
    if (const auto channel = axis ? axisChannel(device, "position", *axis) : std::nullopt)
        return {{telemetry, *channel, begin}};
    std::vector<Place> places;
    const auto channels = telemetry.channels();
    for (std::uint16_t i = 0; i < channels.size(); ++i) {
        if (channels[i].key == axisKey(axisOf(channels[i].key), "position"))
            places.emplace_back(telemetry, ChannelIndex{i}, begin);
    }
    return places;
}

} // namespace

double largestOfDirection(const Envelope &envelope)
{
    return std::min(envelope.duty.value_or(mostDuty), mostDuty);
}

Task<double> checkDirection(Device &device, SetPointStream &stream, TrialRecorder &recorder, int axis, GuardPlan guards,
    std::optional<Trip> &trip, double farthest)
{
    const TrialTraits &traits = *device.family().trials;
    const bool isSent = traits.nudge > 0.0; // it stops by itself where it was sent
    const double most = isSent ? std::max(traits.nudge, farthest) : largestOfDirection(guards.envelope);
    SetPoint setPoint;
    setPoint.axis = axis;
    setPoint.mode = isSent ? Mode::Position : Mode::Duty;
    setPoint.relative = isSent;
    if (device.family().capabilities.output.brake)
        setPoint.brake = true;
    if (isSent) {
        guards.envelope.travel = std::min(guards.envelope.travel.value_or(traits.nudgeTravel), traits.nudgeTravel);
        guards.lag = 0.0;
        guards.telemetry = guards.command = Duration::zero();
    }
    guards.breakaway = 1.0; // nothing is known of its friction yet
    guards.dutyKnown = true;
    bool rests = recorder.isStill(Instant(), restSpan);
    if (!rests) {
        rests = co_await untilAtRest(device, axis);
    }
    if (!rests && !isHeard(device, axis))
        co_return silent(device, axis, trip);
    if (!rests && device.link().state() == LinkState::Open)
        co_return fail(Fault::Unsafe, say("the shaft still turns, so nobody can tell which way it is pushed"),
            say("let it come to rest first"));
    recorder.guard(guards);
    const double enough = isSent ? leastNudge : clearMove / 2.0;
    double moved = 0.0;
    double strength = isSent ? traits.nudge : std::min(firstDuty, most);
    for (bool last = false; !last && std::abs(moved) < enough; strength = std::min(strength * harder, most)) {
        last = strength >= most;
        setPoint.target = strength;
        ++setPoint.order;
        const double before = recorder.latest("position").value_or(0.0);
        auto pushing = push(device, stream, recorder, setPoint, clearMove, isSent ? nudgeTime : pulse);
        const Result<double> pushed = co_await std::move(pushing).attempt();
        moved = pushed.value_or(recorder.latest("position").value_or(before) - before);
        const bool ranAway = recorder.trip() && recorder.trip()->guard == EndReason::Travel && moved <= -enough;
        if (!pushed && !ranAway)
            co_return fail(pushed.error());
        if (moved >= enough) {
            device.knowledge().setVerdict(keyOf(device, axis), DirectionVerdict::Agrees);
            co_return isSent ? 0.0 : setPoint.target;
        }
    }
    if (!isHeard(device, axis))
        co_return silent(device, axis, trip);
    if (std::abs(moved) < enough)
        co_return wrong(device, axis, trip, EndReason::NoMotion,
            isSent ? say("the motor did not move when it was sent %1 counts up (%2 counts): stalled, or the encoder is "
                         "dead",
                most, moved)
                   : say("the motor did not move at up to %1 % duty (%2 counts): stalled, or the encoder is dead",
                       std::round(most * 100.0), moved));
    co_return wrong(device, axis, trip, EndReason::WrongDirection,
        say("the sensor counts down when the motor is driven up (%1 counts): one of them is reversed", moved));
}

/// Counts that it went while it was pushed: the first that were enough, for a loop that swings may roll out on its way back.
Task<double> push(Device &device, SetPointStream &stream, const TrialRecorder &recorder, SetPoint setPoint,
    double enough, Duration limit)
{
    Clock &clock = device.clock();
    if (auto started = stream.start(setPoint, experimentLease, {}, SetPointStream::Since::Renewal); !started)
        co_return fail(started.error());
    co_await untilSent(clock, stream);
    const double before = recorder.latest("position").value_or(0.0);
    const Instant begin = clock.now();
    double moved = 0.0;
    while (stream.isRunning() && clock.now() < begin + limit && std::abs(moved) < enough) {
        co_await Sleep(clock, glancePeriod);
        moved = recorder.latest("position").value_or(before) - before;
        if (clock.now() >= begin + patience && std::abs(moved) < leastNudge)
            break;
    }
    const bool others = !stream.isRunning() && stream.end() == SetPointStream::End::Stopped && !recorder.trip();
    if (stream.isRunning())
        stream.stop();
    (void)co_await confirmStop(device);
    (void)co_await untilAtRest(device, setPoint.axis);
    if (others)
        co_return fail(Fault::Cancelled, stream.reason());
    if (recorder.trip())
        co_return fail(Fault::Unsafe, recorder.trip()->detail);
    if (stream.end() != SetPointStream::End::Stopped)
        co_return fail(Fault::Unsafe, stream.reason());
    co_return std::abs(moved) >= enough ? moved : recorder.latest("position").value_or(before) - before;
}

Task<void> untilSent(Clock &clock, const SetPointStream &stream)
{
    while (stream.waitsForGuard())
        co_await Sleep(clock, glancePeriod);
    co_return {};
}

Task<bool> confirmStop(Device &device, Duration longest)
{
    Clock &clock = device.clock();
    const Instant limit = clock.now() + longest;
    Instant again = clock.now() + stopAgain;
    while (!device.isSeenStopped()) {
        if (clock.now() >= limit || device.link().state() != LinkState::Open)
            co_return false;
        if (clock.now() >= again) { // a frame may have been lost
            device.stop();
            again = limit;
        }
        co_await Sleep(clock, glancePeriod);
    }
    co_return true;
}

Task<bool> untilAtRest(Device &device, std::optional<int> axis)
{
    Clock &clock = device.clock();
    const Instant begin = clock.now();
    std::vector<Place> places = placesOf(device, axis);
    while (!std::ranges::all_of(places, [&clock](const Place &place) { return place.rests(clock.now()); })) {
        if (clock.now() >= begin + restLimit || device.link().state() != LinkState::Open)
            co_return false;
        co_await Sleep(clock, glancePeriod);
        for (Place &place : places)
            place.look(*device.telemetry(), clock.now());
    }
    co_return true;
}

} // namespace mb::tuning
