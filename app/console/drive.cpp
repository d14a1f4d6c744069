// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/pace.h"
#include "app/console/samplestream.h"
#include "app/console/target.h"
#include "app/console/verb.h"
#include "async/sleep.h"
#include "model/leaserenewal.h"
#include "transport/linkcatalog.h"

#include <algorithm>
#include <array>
#include <functional>
#include <memory>

namespace mb::console {
namespace {

using namespace std::chrono_literals;

constexpr Duration stopLimit = 1s;
constexpr Duration stopAgain = 100ms;
constexpr Duration haltLimit = 2s;
constexpr double huge = 1e12;

struct DriveArguments {
    std::string device;
    std::string mode;
    std::string target;
    std::string seconds;
    std::string axis;
    std::string slot;
    std::string velocity;
    std::string acceleration;
    std::string ramp;
    std::string slew;
    bool brake = false;
    bool coast = false;
    bool reverseMotor = false;
    bool reverseSensor = false;
    bool zero = false;
    bool relative = false;
    bool buffered = false;
    bool halt = false;
    std::string limitOverride;

    [[nodiscard]] bool hasOutputOptions() const
    {
        return !ramp.empty() || brake || coast || reverseMotor || reverseSensor || !limitOverride.empty();
    }
};

struct DrivePlan {
    Target target;
    SetPoint setPoint;
    double slew = 0.0; ///< greatest change of the target per second; 0 jumps
    Duration time{};
    bool zero = false;
    bool halt = false; ///< before it is switched off
};

Result<Mode> parseMode(const Family &family, const std::string &text)
{
    std::vector<std::string_view> known{toString(Mode::Off)};
    for (const Mode mode : family.modes)
        known.push_back(toString(mode));
    const auto mode = modeFromString(text);
    if (mode && std::find(known.begin(), known.end(), text) != known.end())
        return *mode;
    return fail(Fault::Usage, say("%1 has no mode '%2'", family.key, text),
        mode ? say("it has %1", joined(known)) : suggestion(text, known, "it has " + joined(known)));
}

Result<double> optionalNumber(std::string_view name, const std::string &text, double low, double high)
{
    return text.empty() ? Result<double>(0.0) : parseNumber(name, text, low, high);
}

/// Brakes to a halt and holds the position.
SetPoint holding()
{
    SetPoint setPoint;
    setPoint.mode = Mode::Position;
    setPoint.relative = true;
    setPoint.order = 2; // after the move
    return setPoint;
}

constexpr std::array<std::string_view, 4> overrides{"none", "forward", "reverse", "both"};

/// Which limit switches do not count while this set-point is in force, whatever the device's parameters say.
Result<void> overrideLimits(SetPoint &setPoint, const std::string &which)
{
    if (which.empty())
        return {};
    const std::vector<std::string_view> known(overrides.begin(), overrides.end());
    if (std::find(known.begin(), known.end(), which) == known.end())
        return fail(Fault::Usage, say("--limit-override cannot be '%1'", which),
            suggestion(which, known, "it switches off " + joined(known)));
    setPoint.overrideLimits = true;
    setPoint.disableForwardLimit = which == "forward" || which == "both";
    setPoint.disableReverseLimit = which == "reverse" || which == "both";
    return {};
}

Result<SetPoint> parseSetPoint(const Family &family, const DriveArguments &a)
{
    if (a.halt && a.mode.empty() && a.target.empty())
        return holding();
    if (a.mode.empty())
        return fail(Fault::Usage, say("--mode is missing"), say("give a mode, or --halt alone to hold the position"));
    const auto mode = parseMode(family, a.mode);
    if (!mode)
        return fail(mode.error());
    if (a.target.empty() && *mode != Mode::Off)
        return fail(Fault::Usage, say("--target is missing"),
            unitOf(*mode).empty() ? say("give it in the unit of the mode") : say("give it in %1", unitOf(*mode)));
    const auto target = optionalNumber("--target", a.target, -huge, huge);
    const auto velocity = optionalNumber("--velocity", a.velocity, 0.0, huge);
    const auto acceleration = optionalNumber("--acceleration", a.acceleration, 0.0, huge);
    const auto ramp = optionalNumber("--ramp", a.ramp, 0.0, 1e6);
    for (const Result<double> *number : {&target, &velocity, &acceleration, &ramp}) {
        if (!*number)
            return fail(number->error());
    }
    const auto axis = a.axis.empty() ? Result<int>(1) : parseInteger("--axis", a.axis, 1, family.capabilities.axes);
    const auto slot
        = a.slot.empty() ? Result<int>(0) : parseInteger("--slot", a.slot, 0, family.capabilities.gainSlots - 1);
    if (!axis || !slot)
        return fail(axis ? slot.error() : axis.error());
    if (a.brake && a.coast)
        return fail(Fault::Usage, say("--brake and --coast exclude each other"), say("give one"));
    SetPoint setPoint;
    setPoint.mode = *mode;
    setPoint.target = *target;
    setPoint.axis = *axis;
    setPoint.slot = *slot;
    setPoint.velocity = *velocity;
    setPoint.acceleration = *acceleration;
    setPoint.ramp = *ramp;
    setPoint.reverseMotor = a.reverseMotor;
    setPoint.reverseSensor = a.reverseSensor;
    if (a.brake || a.coast)
        setPoint.brake = a.brake;
    setPoint.relative = a.relative;
    setPoint.buffered = a.buffered;
    setPoint.order = 1;
    if (auto chosen = overrideLimits(setPoint, a.limitOverride); !chosen)
        return fail(chosen.error());
    return setPoint;
}

/// Where this program makes the way, and not the device.
Result<double> parseSlew(const DriveArguments &a, const SetPoint &setPoint)
{
    const auto slew = optionalNumber("--slew", a.slew, 0.0, huge);
    const bool goesItself = setPoint.mode == Mode::Off || setPoint.mode == Mode::Follow
        || setPoint.mode == Mode::RampPosition || setPoint.mode == Mode::RampVelocity || setPoint.relative;
    if (slew && *slew > 0.0 && goesItself)
        return fail(Fault::Usage, say("--slew means a target that this program moves"),
            say("give it with duty, velocity, position, current or voltage"));
    return slew;
}

/// Asks the family's own check before anything is opened: a device object on a link that stays closed.
Result<void> checkSetPoint(Console &console, const DrivePlan &plan)
{
    std::unique_ptr<Bench> bench;
    std::unique_ptr<Link> link;
    if (plan.target.selector.link.isSimulated()) {
        auto made = Bench::create(plan.target.selector.link, console.clock(), console.families());
        if (!made)
            return fail(made.error());
        bench = std::move(*made);
        link = bench->hostLink();
    } else {
        auto made = createLink(plan.target.selector.link, console.clock());
        if (!made)
            return fail(made.error());
        link = std::move(*made);
    }
    Identity identity;
    identity.family = plan.target.selector.family;
    identity.address = plan.target.selector.address;
    const auto device = plan.target.family->open(*link, console.clock(), identity);
    return plan.setPoint.mode == Mode::Off ? Result<void>() : device->check(plan.setPoint);
}

Result<void> checkOffered(const Family &family, const DriveArguments &arguments)
{
    if (arguments.zero && !family.capabilities.zeroPosition)
        return fail(Fault::OutOfRange, say("--zero: %1 has no command that zeroes its position", family.key));
    if (arguments.hasOutputOptions() && !family.capabilities.outputOptions)
        return fail(Fault::Usage, say("%1 has no ramp, brake, direction or limit override of its output", family.key),
            say("leave these options out"));
    if ((arguments.relative || arguments.halt) && !family.capabilities.relativeMoves)
        return fail(Fault::Usage, say("%1 has no relative moves and no halt", family.key),
            say("leave --relative and --halt out"));
    if (arguments.buffered && !family.capabilities.bufferedMoves)
        return fail(Fault::Usage, say("%1 has no buffered moves", family.key), say("leave --buffered out"));
    const bool profiled
        = arguments.mode == toString(Mode::RampPosition) || arguments.mode == toString(Mode::RampVelocity);
    if ((!arguments.velocity.empty() || !arguments.acceleration.empty()) && !profiled)
        return fail(Fault::Usage, say("--velocity and --acceleration belong to a profile"),
            say("give them with --mode ramp-position or ramp-velocity"));
    const bool positional
        = arguments.mode == toString(Mode::Position) || arguments.mode == toString(Mode::RampPosition);
    if (arguments.relative && !positional)
        return fail(
            Fault::Usage, say("--relative means a distance"), say("give it with --mode position or ramp-position"));
    return {};
}

Result<DrivePlan> check(Console &console, const DriveArguments &arguments)
{
    auto target = parseTarget(console, arguments.device);
    if (!target)
        return fail(target.error());
    if (auto offered = checkOffered(*target->family, arguments); !offered)
        return fail(offered.error());
    const auto setPoint = parseSetPoint(*target->family, arguments);
    if (!setPoint)
        return fail(setPoint.error());
    const auto time = parseSpan(arguments.seconds);
    if (!time)
        return fail(time.error());
    const auto slew = parseSlew(arguments, *setPoint);
    if (!slew)
        return fail(slew.error());
    DrivePlan plan{std::move(*target), *setPoint, *slew, time->value_or(Duration::zero()), arguments.zero,
        arguments.halt && !arguments.mode.empty()};
    if (auto legal = checkSetPoint(console, plan); !legal)
        return fail(legal.error());
    return plan;
}

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
    [[nodiscard]] bool isSafety() const { return isGuarded() || !stopped; }
};

Task<bool> confirmStop(Console &console, Device &device)
{
    const Instant limit = console.clock().now() + stopLimit;
    Instant again = console.clock().now() + stopAgain;
    while (!device.isSeenStopped()) {
        const Instant now = console.clock().now();
        if (now >= limit || device.link().state() != LinkState::Open)
            co_return false;
        if (now >= again) { // a frame may have been lost
            device.stop();
            again = limit;
        }
        Sleep nap(console.clock(), lookEvery);
        co_await nap;
    }
    co_return true;
}

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
        Sleep nap(console.clock(), std::min<Duration>(left, LeaseRenewal::period));
        co_await nap;
    }
    co_return {};
}

/// Starts what the device keeps, as soon as it has acknowledged it.
Task<void> release(Console &console, Device &device)
{
    SetPointStream &stream = console.session().stream(device);
    const Instant limit = console.clock().now() + stopLimit;
    Result<void> released = fail(Fault::Unsafe, say("the buffered move was not acknowledged"));
    while (!released && stream.isRunning() && !console.isInterrupted() && console.clock().now() < limit) {
        auto waiting = keepAlive(console, stream, lookEvery, [] { return false; });
        co_await std::move(waiting);
        if (device.liveness().mode == stream.setPoint().mode)
            released = console.session().stops().releaseMoves(device);
    }
    co_return released;
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
    const Subscription signal = console.interrupted().add([&console] { console.session().stopAll(StopCause::User); });
    if (!console.isInterrupted()) {
        if (auto started = stream.start(plan.setPoint, LeaseRenewal::term, glideOf(device, plan)); !started) {
            if (!plan.zero)
                console.onlyAsk();
            co_return fail(started.error());
        }
    }
    Result<void> released;
    if (plan.setPoint.buffered) {
        auto releasing = release(console, device);
        released = co_await std::move(releasing).attempt();
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
    outcome.end = stream.end();
    outcome.why = stream.reason();
    auto confirming = confirmStop(console, device);
    outcome.stopped = co_await std::move(confirming);
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
    if (outcome.end == SetPointStream::End::LinkLost || device.link().state() == LinkState::Lost)
        return fail(Fault::LinkLost,
            say("the link was lost while the motor was driven (%1)", device.link().loss().message()),
            say("see that the motor stands before anything else"));
    if (!outcome.stopped)
        return fail(Fault::Unsafe,
            outcome.isGuarded()
                ? say("the stop was not confirmed by %1 within a second (%2)", device.selector(), outcome.why)
                : say("the stop was not confirmed by %1 within a second", device.selector()),
            say("cut its power if the motor still turns"));
    if (!outcome.released && !outcome.interrupted)
        return fail(outcome.released.error());
    if (outcome.isGuarded())
        return fail(Fault::Unsafe, say("stopped for safety: %1", outcome.why),
            say("remove the cause before it is driven again"));
    return exitDone;
}

Task<int> drive(Console &console, DriveArguments arguments)
{
    const auto plan = check(console, arguments);
    if (!plan)
        co_return fail(plan.error());
    const Subscription patient = console.interrupted().add([] {}); // a signal ends this verb through its own stop
    auto connecting = connect(console, plan->target);
    Device *const device = co_await std::move(connecting);
    Sleep listening(console.clock(), masterListen);
    co_await listening;
    console.onlyAsk();
    if (auto ready = needsApplication(*device); !ready)
        co_return fail(ready.error());
    if (auto allowed = device->mayMove(); !allowed)
        co_return fail(allowed.error());
    if (auto legal = plan->setPoint.mode == Mode::Off ? Result<void>() : device->check(plan->setPoint); !legal)
        co_return fail(legal.error()); // now that the device itself is known
    if (const Message caution = device->caution(plan->setPoint); !caution.empty())
        console.note(device->selector() + ": " + caution.english());
    console.begin();
    if (plan->zero) {
        auto zeroing = device->zeroPosition();
        co_await std::move(zeroing);
    }
    Outcome outcome;
    {
        SampleStream samples(console, *device, {.channels = {}, .states = {}, .driven = true});
        auto moving = move(console, *device, *plan);
        outcome = co_await std::move(moving);
        report(console, outcome, samples.count());
    }
    co_return verdictOf(*device, outcome);
}

} // namespace

Job declareDrive(CLI::App &arguments)
{
    const auto a = std::make_shared<DriveArguments>();
    arguments.add_option("device", a->device, "LINK/FAMILY:ADDRESS")->required();
    arguments.add_option(
        "--mode", a->mode, "duty, velocity, position, current, voltage, follow, ramp-position, ramp-velocity, off");
    arguments.add_option("--target", a->target, "-1…1, counts/s, counts, A, V, a device number, by mode");
    arguments.add_option("--for", a->seconds, "Seconds, then it is stopped")->required();
    arguments.add_option("--axis", a->axis, "1…, on boards with several");
    arguments.add_option("--slot", a->slot, "Gain set, 0…");
    arguments.add_option("--velocity", a->velocity, "Of profiled modes, counts/s");
    arguments.add_option("--acceleration", a->acceleration, "Of profiled modes, counts/s²");
    arguments.add_option("--ramp", a->ramp, "Greatest change of the output, duty per second");
    arguments.add_option(
        "--slew", a->slew, "Greatest change of the target, in its unit per second, from where the motor is");
    arguments.add_flag("--brake", a->brake, "Brake at zero output; the stored setting otherwise");
    arguments.add_flag("--coast", a->coast, "Coast at zero output");
    arguments.add_flag("--reverse-motor", a->reverseMotor, "Exchange the directions of the output");
    arguments.add_flag("--reverse-sensor", a->reverseSensor, "Exchange the directions of the encoder");
    arguments.add_flag("--limit-override{both}", a->limitOverride,
        "Limit switches do not count meanwhile, whatever the device's own settings; =forward, =reverse, =none: these");
    arguments.add_flag("--relative", a->relative, "The target is a distance, where the device has relative moves");
    arguments.add_flag(
        "--buffered", a->buffered, "Give the move first and start it with the command for the whole line");
    arguments.add_flag("--halt", a->halt,
        "Brake to a halt and hold before it is switched off; without --mode: hold the position, nothing else");
    arguments.add_flag("--zero", a->zero, "Stop first, and let the position count from 0, where the device can");
    return [a](Console &console) { return drive(console, *a); };
}

} // namespace mb::console
