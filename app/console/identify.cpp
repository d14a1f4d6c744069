// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/pace.h"
#include "app/console/question.h"
#include "app/console/target.h"
#include "app/console/verb.h"
#include "async/sleep.h"
#include "experiment/direction.h"
#include "experiment/nudge.h"
#include "model/leaserenewal.h"

#include <cmath>
#include <memory>
#include <unistd.h>

namespace mb::console {
namespace {

struct IdentifyArguments {
    std::string device;
    std::string axis;
    bool yes = false;
};

/// Of several axes, all are shown.
std::string positionOption(const Family &family)
{
    return findChannel(family.channels, "position") ? " --channel position" : "";
}

/// Whoever types it stands before the motor; a script has said --yes.
Task<void> mayNudge(Console &console, const Target &target, const IdentifyArguments &arguments)
{
    if (arguments.yes)
        co_return {};
    const std::string family(target.family->key);
    if (isatty(STDIN_FILENO) == 0)
        co_return fail(Fault::Usage, say("%1 cannot blink, so its shaft would be turned a little to and fro", family),
            say("give --yes once nothing is in its way, or turn its shaft by hand and see which position moves: "
                "motorbenchctl watch %1%2",
                arguments.device, positionOption(*target.family)));
    const bool agreed = co_await ask(console,
        family + " cannot blink. Turn the shaft of " + arguments.device
            + " a little to and fro? Nothing may be in its way.");
    if (agreed)
        co_return {};
    co_return fail(Fault::Cancelled, say("its shaft was not turned"),
        say("turn it by hand and see which position moves: motorbenchctl watch %1%2", arguments.device,
            positionOption(*target.family)));
}

/// A signal ends it through its own stop.
Task<double> nudge(Console &console, Device &device, int axis)
{
    SetPointStream &stream = console.session().stream(device);
    const LeaseRenewal renewal(console.clock(), [&stream] { stream.renew(); });
    tuning::Interruption interruption;
    if (console.isInterrupted())
        interruption.interrupt();
    const Subscription signal = console.interrupted().add([&interruption] { interruption.interrupt(); });
    tuning::ExperimentSurroundings surroundings;
    surroundings.interruption = &interruption;
    surroundings.note = [&console](const Message &text) { console.note(text.english()); };
    const Result<double> moved = co_await tuning::nudge(device, stream, axis, surroundings).attempt();
    const bool stopped = co_await tuning::confirmStop(device);
    if (device.link().state() == LinkState::Lost || stream.end() == SetPointStream::End::LinkLost) // it may be back
        co_return fail(Fault::LinkLost,
            say("the link was lost while the shaft was turned (%1)", device.link().loss().message()),
            say("see that the motor stands before anything else"));
    if (!stopped)
        co_return fail(Fault::Unsafe, say("the stop was not confirmed by %1", device.selector()),
            say("cut its power if the motor still turns"));
    if (interruption.isRequested())
        co_return fail(Fault::Cancelled, say("interrupted before it was done; %1 has stopped", device.selector()));
    if (moved && std::abs(*moved) < tuning::leastNudged)
        co_return fail(Fault::Refused, say("the shaft of %1 did not move (%2 counts)", device.selector(), *moved),
            say("look whether it is blocked, or its encoder dead"));
    co_return moved;
}

Task<int> identify(Console &console, IdentifyArguments arguments)
{
    const auto target = co_await parseTarget(console, arguments.device);
    const Capabilities &can = target.family->capabilities;
    const int axis = co_await integerOr(1, "--axis", arguments.axis, 1, can.axes);
    if (!can.identify)
        co_await mayNudge(console, target, arguments);
    Device *const device = co_await connect(console, target);
    co_await needsApplication(*device);
    std::string shown = "blinks";
    if (can.identify) {
        co_await device->identify();
    } else {
        co_await Sleep(console.clock(), masterListen);
        const double moved = co_await nudge(console, *device, axis);
        shown = "turned to and fro, " + numberText(std::round(std::abs(moved))) + " counts at first";
    }
    if (console.json())
        console.out().json({{QStringLiteral("device"), qt(device->selector())},
            {QStringLiteral("result"), can.identify ? QStringLiteral("blinked") : QStringLiteral("nudged")}});
    else
        console.out().line(device->selector() + ' ' + shown);
    co_return exitDone;
}

} // namespace

Job declareIdentify(CLI::App &arguments)
{
    const auto a = std::make_shared<IdentifyArguments>();
    arguments.add_option("device", a->device, "LINK/FAMILY:ADDRESS")->required();
    arguments.add_option("--axis", a->axis, "1…, on boards with several");
    arguments.add_flag("--yes", a->yes, "Turn the shaft of a device that cannot blink without asking");
    return [a](Console &console) { return identify(console, *a); };
}

} // namespace mb::console
