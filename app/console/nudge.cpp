// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/nudge.h"

#include "app/console/pace.h"
#include "model/leaserenewal.h"

#include "async/sleep.h"
#include "model/axis.h"

#include <algorithm>
#include <cmath>

namespace mb::console {
namespace {

using namespace std::chrono_literals;

constexpr Duration pushTime = 150ms;
constexpr Duration sendTime = 400ms; ///< of a move that ends by itself
constexpr Duration restTime = 300ms;
constexpr Duration standLimit = 2s;
constexpr double firstDuty = 0.08;
constexpr double mostDuty = 0.30;
constexpr double harder = 1.4;
constexpr double clearly = 8.0;       ///< counts
constexpr double timesTheCheck = 5.0; ///< of the move that checks the direction: to be seen from a step away

std::optional<double> positionOf(const Device &device, int axis)
{
    const bool several = device.family().capabilities.axes > 1;
    const auto channel = findChannel(
        device.family().channels, several ? "ch" + std::to_string(axis) + ".position" : std::string("position"));
    const auto latest = channel ? device.telemetry()->latest(*channel) : std::nullopt;
    return latest ? std::optional<double>(latest->value) : std::nullopt;
}

/// What is known of the motor without its link: nothing.
Result<void> linkOf(const Device &device, const SetPointStream &stream)
{
    if (device.link().state() != LinkState::Lost && stream.end() != SetPointStream::End::LinkLost) // it may be back
        return {};
    return fail(Fault::LinkLost,
        say("the link was lost while the shaft was turned (%1)", device.link().loss().message()),
        say("see that the motor stands before anything else"));
}

/// One push; yields how far the shaft has gone once it stands again. After a signal, whenever it came, none begins.
Task<double> push(Console &console, Device &device, SetPoint setPoint, Duration time)
{
    const auto cancelled = [&device] {
        return fail(Fault::Cancelled, say("interrupted before it was done; %1 has stopped", device.selector()));
    };
    if (console.isInterrupted())
        co_return cancelled();
    SetPointStream &stream = console.session().stream(device);
    const double before = positionOf(device, setPoint.axis).value_or(0.0);
    co_await stream.start(setPoint, LeaseRenewal::term);
    co_await Sleep(console.clock(), time);
    co_await linkOf(device, stream);
    if (!stream.isRunning() && !console.isInterrupted())
        co_return fail(Fault::Unsafe, say("stopped for safety: %1", stream.reason()));
    stream.stop();
    const Instant limit = console.clock().now() + standLimit;
    while (!device.isSeenStopped()) {
        co_await linkOf(device, stream);
        if (console.clock().now() >= limit)
            co_return fail(Fault::Unsafe, say("the stop was not confirmed by %1", device.selector()),
                say("cut its power if the motor still turns"));
        co_await Sleep(console.clock(), lookEvery);
    }
    co_await Sleep(console.clock(), restTime);
    if (console.isInterrupted())
        co_return cancelled();
    co_return positionOf(device, setPoint.axis).value_or(0.0) - before;
}

} // namespace

Task<double> nudge(Console &console, Device &device, int axis)
{
    const Subscription signal = console.interrupted().add([&console] { console.session().stopAll(StopCause::User); });
    const double way = device.family().trials ? timesTheCheck * device.family().trials->nudge : 0.0;
    SetPoint setPoint;
    setPoint.axis = axis;
    setPoint.mode = way > 0.0 ? Mode::Position : Mode::Duty;
    setPoint.relative = way > 0.0;
    double strength = way > 0.0 ? way : firstDuty;
    double moved = 0.0;
    for (bool last = false; !last && std::abs(moved) < clearly; strength = std::min(strength * harder, mostDuty)) {
        last = way > 0.0 || strength >= mostDuty;
        setPoint.target = strength;
        ++setPoint.order;
        auto pushing = push(console, device, setPoint, way > 0.0 ? sendTime : pushTime);
        moved = co_await std::move(pushing);
    }
    if (std::abs(moved) < clearly)
        co_return fail(Fault::Refused, say("the shaft of %1 did not move (%2 counts)", device.selector(), moved),
            say("look whether it is blocked, or its encoder dead"));
    for (int turn = 0; turn < 3; ++turn) { // back, to and back
        setPoint.target = -setPoint.target;
        ++setPoint.order;
        auto pushing = push(console, device, setPoint, way > 0.0 ? sendTime : pushTime);
        (void)co_await std::move(pushing);
    }
    co_return moved;
}

} // namespace mb::console
