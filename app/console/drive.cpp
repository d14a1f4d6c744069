// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/driveplan.h"
#include "app/console/pace.h"
#include "app/console/samplestream.h"
#include "app/console/verb.h"
#include "async/sleep.h"
#include "experiment/direction.h"
#include "model/leaserenewal.h"

#include <algorithm>
#include <functional>
#include <memory>

namespace mb::console {
namespace {

using namespace std::chrono_literals;

constexpr Duration stopLimit = 1s;
constexpr Duration haltLimit = 2s;

/// From where the motor is: what it was told last in this mode is not known, and it stands.
Glide glideOf(const Device &device, const DrivePlan &plan)
{
    if (plan.slew <= 0.0)
        return {};
    const bool isPosition = plan.setPoint.mode == Mode::Position;
    const std::string channel
        = device.family().capabilities.axes > 1 ? "ch" + std::to_string(plan.setPoint.axis) + ".position" : "position";
    const auto position = isPosition ? findChannel(device.family().channels, channel) : std::nullopt;
    const auto latest = position ? device.telemetry()->latest(*position) : std::nullopt;
    if (isPosition && !latest)
        return {};
    return {plan.slew, latest ? latest->value : 0.0};
}

/// What ended the motion, and whether the device was seen to have stopped.
struct Outcome {
    SetPointStream::End end = SetPointStream::End::None;
    Message why;
    bool interrupted = false;
    bool stopped = false;
    Result<void> released; ///< of a buffered move

    [[nodiscard]] bool isGuarded() const
    {
        return end != SetPointStream::End::Stopped && end != SetPointStream::End::None;
    }
    [[nodiscard]] bool isSafety() const { return isGuarded() || !stopped || (!released && !interrupted); }
};

/// Keeps the set-point alive from this program's own loop: if that hangs, the stream stops the motor. Ends early when the
/// stream does, at a signal, and once `done` says so.
Task<void> keepAlive(Console &console, SetPointStream &stream, Duration time, std::function<bool()> done)
{
    const Instant end = console.clock().now() + time;
    const LeaseRenewal renewal(console.clock(), [&stream] { stream.renew(); });
    while (stream.isRunning() && !console.isInterrupted() && !done()) {
        const Duration left = end - console.clock().now();
        if (left <= Duration::zero())
            break;
        co_await Sleep(console.clock(), std::min<Duration>(left, LeaseRenewal::period));
    }
    co_return {};
}

/// Starts what the device keeps, as soon as it has acknowledged it, and waits until it has begun.
Task<void> release(Console &console, Device &device)
{
    SetPointStream &stream = console.session().stream(device);
    const Instant limit = console.clock().now() + stopLimit;
    const Result<void> waiting = fail(Fault::Unsafe, say("the buffered move was not acknowledged"));
    Result<void> released = waiting;
    const auto hasBegun = [&] { return released && !device.gate().keepsMove(); };
    while (!hasBegun() && stream.isRunning() && !console.isInterrupted() && console.clock().now() < limit) {
        auto looking = keepAlive(console, stream, lookEvery, hasBegun);
        co_await std::move(looking);
        if (device.gate().kept().state == KeptMove::State::Acknowledged)
            released = console.session().stops().releaseMoves(device);
    }
    co_return released && !hasBegun() ? waiting : released;
}

/// Whether the shaft stands, by the newest velocity that is younger than the halt.
bool stands(const Device &device, Instant since)
{
    const auto velocity = findChannel(device.family().channels, "velocity");
    const auto latest = velocity ? device.telemetry()->latest(*velocity) : std::nullopt;
    return latest && latest->time > since && latest->value == 0.0;
}

Task<Outcome> move(Console &console, Device &device, DrivePlan plan)
{
    SetPointStream &stream = console.session().stream(device);
    if (!console.isInterrupted()) {
        if (auto started = stream.start(plan.setPoint, LeaseRenewal::term, glideOf(device, plan)); !started) {
            if (!plan.zero)
                console.onlyAsk();
            co_return fail(started.error());
        }
    }
    Result<void> released;
    if (plan.setPoint.buffered) {
        released = co_await release(console, device).attempt();
    }
    auto moving = keepAlive(console, stream, released ? plan.time : Duration::zero(), [] { return false; });
    co_await std::move(moving);
    if (plan.halt && stream.isRunning() && !console.isInterrupted() && stream.update(holding())) {
        const Instant since = device.clock().now();
        auto halting = keepAlive(console, stream, haltLimit, [&device, since] { return stands(device, since); });
        co_await std::move(halting);
    }
    Outcome outcome;
    outcome.released = released;
    outcome.interrupted = console.isInterrupted();
    if (stream.isRunning() || stream.end() == SetPointStream::End::None)
        stream.stop();
    const bool isOff = plan.setPoint.mode == Mode::Off && stream.end() != SetPointStream::End::LinkLost;
    outcome.end = isOff ? SetPointStream::End::Stopped : stream.end(); // whatever ended it, it was to end
    outcome.why = stream.reason();
    outcome.stopped = co_await tuning::confirmStop(device, stopLimit);
    co_return outcome;
}

void report(Console &console, const Outcome &outcome, std::uint64_t samples)
{
    const char *const reason = outcome.isSafety() ? "safety" : outcome.interrupted ? "interrupted" : "done";
    if (console.json()) {
        console.out().json({
            {QStringLiteral("samples"), static_cast<qint64>(samples)},
            {QStringLiteral("stopped"), outcome.stopped},
            {QStringLiteral("reason"), QLatin1String(reason)},
        });
    } else {
        console.note(std::to_string(samples) + " samples, " + (outcome.stopped ? "stopped" : "stop not confirmed")
            + ", " + reason);
    }
}

Result<int> verdictOf(const Device &device, const Outcome &outcome)
{
    const bool isLost
        = device.link().state() == LinkState::Lost && !outcome.isGuarded(); // else it ended for safety before
    if (outcome.end == SetPointStream::End::LinkLost || isLost)
        return fail(Fault::LinkLost,
            say("the link was lost while the motor was driven (%1)", device.link().loss().message()),
            say("see that the motor stands before anything else"));
    if (!outcome.stopped)
        return fail(Fault::Unsafe,
            outcome.isGuarded()
                ? say("the stop was not confirmed by %1 within a second (%2)", device.selector(), outcome.why)
                : say("the stop was not confirmed by %1 within a second", device.selector()),
            say("cut its power if the motor still turns"));
    if (outcome.isGuarded())
        return fail(Fault::Unsafe, say("stopped for safety: %1", outcome.why),
            say("remove the cause before it is driven again"));
    if (!outcome.released && !outcome.interrupted)
        return fail(outcome.released.error());
    return exitDone;
}

/// Now that the device itself is known. It is switched off whoever drives it.
Result<void> mayDrive(const Device &device, const SetPoint &setPoint)
{
    if (setPoint.mode == Mode::Off)
        return {};
    MB_TRY_VOID(device.mayMove());
    return device.check(setPoint);
}

Task<int> drive(Console &console, DriveArguments arguments)
{
    const auto plan = co_await planOf(console, arguments);
    const auto stopAll = [&console] { console.session().stopAll(StopCause::User); };
    const Subscription signal = console.interrupted().add(stopAll); // it ends this verb through its own stop, too
    Device *const device = co_await connect(console, plan.target);
    co_await Sleep(console.clock(), masterListen);
    console.onlyAsk();
    co_await needsApplication(*device);
    co_await noteOwed(console, *device);
    co_await mayDrive(*device, plan.setPoint);
    if (const Message caution = device->caution(plan.setPoint); !caution.empty())
        console.note(device->selector() + ": " + caution.english());
    console.begin();
    if (console.isInterrupted())
        stopAll(); // those that were not known at the signal
    else if (plan.zero) {
        co_await device->zeroPosition();
    }
    Outcome outcome;
    {
        SampleStream samples(console, *device, {.channels = {}, .states = {}, .driven = true});
        outcome = co_await move(console, *device, plan);
        report(console, outcome, samples.count());
    }
    co_return verdictOf(*device, outcome);
}

} // namespace

Job declareDrive(CLI::App &arguments)
{
    const auto a = std::make_shared<DriveArguments>();
    a->declare(arguments);
    return [a](Console &console) { return drive(console, *a); };
}

} // namespace mb::console
