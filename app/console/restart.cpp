// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/notebook.h"
#include "app/console/target.h"
#include "app/console/verb.h"

#include <memory>

namespace mb::console {
namespace {

Task<int> restart(Console &console, std::string text)
{
    auto target = co_await parseTarget(console, text);
    target.mayBeSilent = target.family->capabilities.bootloaderElsewhere;
    if (!target.family->capabilities.restart)
        co_return fail(Fault::Unsupported, say("%1 cannot be restarted from here", target.family->key),
            say("switch it off and on"));
    Device *const device = co_await connect(console, target);
    co_await device->link().address().takesOrders();
    const Duration wait = target.family->capabilities.storesAfter;
    if (wait > Duration::zero() && device->identity().state != DeviceState::Bootloader)
        console.note(
            "it restarts once what was written is stored, which takes up to " + numberText(secondsOf(wait)) + " s");
    co_await device->restart();
    co_await keepStored(console, *device);
    if (console.json())
        console.out().json({{QStringLiteral("device"), qt(device->selector())},
            {QStringLiteral("result"), QStringLiteral("restarted")}});
    else
        console.out().line(device->selector() + " has restarted and answers");
    co_return exitDone;
}

} // namespace

Job declareRestart(CLI::App &arguments)
{
    const auto device = std::make_shared<std::string>();
    arguments.add_option("device", *device, "LINK/FAMILY:ADDRESS")->required();
    return [device](Console &console) { return restart(console, *device); };
}

} // namespace mb::console
