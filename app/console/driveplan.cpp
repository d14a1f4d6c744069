// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/driveplan.h"

#include "transport/linkcatalog.h"

#include <algorithm>
#include <array>
#include <memory>

namespace mb::console {
namespace {

constexpr double huge = 1e12;

Result<Mode> parseMode(const Family &family, const std::string &text)
{
    std::vector<std::string_view> known{toString(Mode::Off)};
    for (const Mode mode : family.modes)
        known.push_back(toString(mode));
    const auto mode = modeFromString(text);
    if (mode && std::ranges::find(known, text) != known.end())
        return *mode;
    return fail(Fault::Usage, say("%1 has no mode '%2'", family.key, text),
        mode ? say("it has %1", joined(known)) : suggestion(text, known, "it has " + joined(known)));
}

Result<double> optionalNumber(std::string_view name, const std::string &text, double low, double high)
{
    return text.empty() ? Result<double>(0.0) : parseNumber(name, text, low, high);
}

constexpr std::array<std::string_view, 4> overrides{"none", "forward", "reverse", "both"};

/// Which limit switches do not count while this set-point is in force, whatever the device's parameters say.
Result<void> overrideLimits(SetPoint &setPoint, const std::string &which)
{
    if (which.empty())
        return {};
    const std::vector<std::string_view> known(overrides.begin(), overrides.end());
    if (std::ranges::find(known, which) == known.end())
        return fail(Fault::Usage, say("--limit-override cannot be '%1'", which),
            suggestion(which, known, "it switches off " + joined(known)));
    setPoint.overrideLimits = true;
    setPoint.disableForwardLimit = which == "forward" || which == "both";
    setPoint.disableReverseLimit = which == "reverse" || which == "both";
    return {};
}

Result<void> readNumbers(SetPoint &setPoint, const DriveArguments &a)
{
    struct Field {
        std::string_view name;
        const std::string &text;
        double low;
        double high;
        double &value;
    };
    const std::array<Field, 4> fields{{
        {"--target", a.target, -huge, huge, setPoint.target},
        {"--velocity", a.velocity, 0.0, huge, setPoint.velocity},
        {"--acceleration", a.acceleration, 0.0, huge, setPoint.acceleration},
        {"--ramp", a.ramp, 0.0, 1e6, setPoint.ramp},
    }};
    for (const Field &field : fields) {
        MB_TRY(field.value, optionalNumber(field.name, field.text, field.low, field.high));
    }
    return {};
}

Result<SetPoint> parseSetPoint(const Family &family, const DriveArguments &a)
{
    if (a.halt && a.mode.empty() && a.target.empty())
        return holding();
    if (a.mode.empty())
        return fail(Fault::Usage, say("--mode is missing"), say("give a mode, or --halt alone to hold the position"));
    MB_TRY(const auto mode, parseMode(family, a.mode));
    if (a.target.empty() && mode != Mode::Off)
        return fail(Fault::Usage, say("--target is missing"),
            unitOf(mode).empty() ? say("give it in the unit of the mode") : say("give it in %1", unitOf(mode)));
    SetPoint setPoint;
    MB_TRY_VOID(readNumbers(setPoint, a));
    if (!a.target.empty()) {
        MB_TRY_VOID(parseModeNumber("--target", a.target, mode, -huge, huge));
    }
    if (mode == Mode::Off && setPoint.target != 0.0)
        return fail(
            Fault::Usage, say("--mode off has no target"), say("leave --target out, or name the mode that is meant"));
    MB_TRY(setPoint.axis, integerOr(1, "--axis", a.axis, 1, family.capabilities.axes));
    MB_TRY(setPoint.slot, integerOr(0, "--slot", a.slot, 0, family.capabilities.gainSlots - 1));
    if (a.brake && a.coast)
        return fail(Fault::Usage, say("--brake and --coast exclude each other"), say("give one"));
    setPoint.mode = mode;
    setPoint.reverseMotor = a.reverseMotor;
    setPoint.reverseSensor = a.reverseSensor;
    if (a.brake || a.coast)
        setPoint.brake = a.brake;
    setPoint.relative = a.relative;
    setPoint.buffered = a.buffered;
    setPoint.order = 1;
    MB_TRY_VOID(overrideLimits(setPoint, a.limitOverride));
    return setPoint;
}

/// Where this program makes the way, and not the device.
Result<double> parseSlew(const DriveArguments &a, const SetPoint &setPoint)
{
    const auto slew = optionalNumber("--slew", a.slew, 0.0, huge);
    const bool goesItself = setPoint.mode == Mode::Off || setPoint.mode == Mode::Follow
        || setPoint.mode == Mode::RampPosition || setPoint.mode == Mode::RampVelocity || setPoint.relative;
    if (slew && *slew <= 0.0 && !a.slew.empty())
        return fail(Fault::OutOfRange, say("--slew: with %1 the target would never be reached", a.slew),
            say("it is above 0; without the option the target jumps"));
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
        MB_TRY(auto made, Bench::create(plan.target.selector.link, console.clock(), console.families()));
        bench = std::move(made);
        link = bench->hostLink();
    } else {
        MB_TRY(auto made, createLink(plan.target.selector.link, console.clock()));
        link = std::move(made);
    }
    Identity identity;
    identity.family = plan.target.selector.family;
    identity.address = plan.target.selector.address;
    const auto device = plan.target.family->open(*link, console.clock(), identity);
    return device->check(plan.setPoint);
}

Result<void> checkOffered(const Family &family, const DriveArguments &arguments)
{
    if (arguments.zero && !family.capabilities.zeroPosition)
        return fail(Fault::OutOfRange, say("--zero: %1 has no command that zeroes its position", family.key));
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

} // namespace

void DriveArguments::declare(CLI::App &arguments)
{
    arguments.add_option("device", device, "LINK/FAMILY:ADDRESS")->required();
    arguments.add_option(
        "--mode", mode, "duty, velocity, position, current, voltage, follow, ramp-position, ramp-velocity, off");
    arguments.add_option("--target", target, "-1…1, counts/s, counts, A, V, a device number, by mode");
    arguments.add_option("--for", seconds, "Seconds, then it is stopped")->required();
    arguments.add_option("--axis", axis, "1…, on boards with several");
    arguments.add_option("--slot", slot, "Gain set, 0…");
    arguments.add_option("--velocity", velocity, "Of profiled modes, counts/s");
    arguments.add_option("--acceleration", acceleration, "Of profiled modes, counts/s²");
    arguments.add_option("--ramp", ramp, "Greatest change of the output, duty per second, in modes without a loop");
    arguments.add_option(
        "--slew", slew, "Greatest change of the target, in its unit per second, from where the motor is");
    arguments.add_flag("--brake", brake, "Brake at zero output; the stored setting otherwise");
    arguments.add_flag("--coast", coast, "Coast at zero output");
    arguments.add_flag("--reverse-motor", reverseMotor, "Exchange the directions of the output");
    arguments.add_flag("--reverse-sensor", reverseSensor, "Exchange the directions of the encoder");
    arguments.add_flag("--limit-override{both}", limitOverride,
        "Limit switches do not count meanwhile, whatever the device's own settings; =forward, =reverse, =none: these");
    arguments.add_flag("--relative", relative, "The target is a distance, where the device has relative moves");
    arguments.add_flag("--buffered", buffered, "Give the move first and start it with the command for the whole line");
    arguments.add_flag("--halt", halt,
        "Brake to a halt and hold before it is switched off; without --mode: hold the position, nothing else");
    arguments.add_flag("--zero", zero, "Stop first, and let the position count from 0, where the device can");
}

SetPoint holding()
{
    SetPoint setPoint;
    setPoint.mode = Mode::Position;
    setPoint.relative = true;
    setPoint.order = 2; // after the move
    return setPoint;
}

Result<DrivePlan> planOf(Console &console, const DriveArguments &arguments)
{
    MB_TRY(auto target, parseTarget(console, arguments.device));
    MB_TRY_VOID(checkOffered(*target.family, arguments));
    MB_TRY(const auto setPoint, parseSetPoint(*target.family, arguments));
    MB_TRY(const auto time, parseSpan(arguments.seconds));
    MB_TRY(const auto slew, parseSlew(arguments, setPoint));
    DrivePlan plan{std::move(target), setPoint, slew, time.value_or(Duration::zero()), arguments.zero,
        arguments.halt && !arguments.mode.empty()};
    MB_TRY_VOID(checkSetPoint(console, plan));
    return plan;
}

} // namespace mb::console
