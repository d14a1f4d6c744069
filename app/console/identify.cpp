// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/target.h"
#include "app/console/verb.h"

#include <memory>

namespace mb::console {
namespace {

/// Of several axes, all are shown.
std::string positionOption(const Family &family)
{
    return findChannel(family.channels, "position") ? " --channel position" : "";
}

Task<int> identify(Console &console, std::string text)
{
    const auto target = parseTarget(console, text);
    if (!target)
        co_return fail(target.error());
    if (!target->family->capabilities.identify)
        co_return fail(Fault::Unsupported, std::string(target->family->key) + " cannot blink",
            "turn its shaft by hand and see which position moves: motorbenchctl watch " + text
                + positionOption(*target->family));
    auto connecting = connect(console, *target);
    Device *const device = co_await std::move(connecting);
    auto blinking = device->identify();
    co_await std::move(blinking);
    if (console.json())
        console.out().json({{QStringLiteral("device"), qt(device->selector())},
            {QStringLiteral("result"), QStringLiteral("blinked")}});
    else
        console.out().line(device->selector() + " blinks");
    co_return exitDone;
}

} // namespace

Job declareIdentify(CLI::App &arguments)
{
    const auto device = std::make_shared<std::string>();
    arguments.add_option("device", *device, "LINK/FAMILY:ADDRESS")->required();
    return [device](Console &console) { return identify(console, *device); };
}

} // namespace mb::console
