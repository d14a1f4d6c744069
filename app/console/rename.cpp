// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/notebook.h"
#include "app/console/target.h"
#include "app/console/verb.h"
#include "model/unit.h"

#include <memory>

namespace mb::console {
namespace {

constexpr int longest = 64;
constexpr int usual = 28;

struct RenameArguments {
    std::string device;
    std::string name;
};

/// `now`: what it is called after it; `proof`: how that is known.
Result<int> finish(Console &console, const Device &device, const std::string &old, const std::string &name,
    const std::string &now, const std::string &proof)
{
    const bool verified = now == name;
    if (console.json()) {
        console.out().json({
            {QStringLiteral("device"), qt(device.selector())},
            {QStringLiteral("old"), textOrNull(old)},
            {QStringLiteral("new"), qt(name)},
            {QStringLiteral("verified"), verified},
        });
    } else {
        console.out().line("name '" + old + "' → '" + name + "', " + (verified ? proof : "not verified"));
    }
    if (verified)
        return exitDone;
    return fail(Fault::BadCheck, say("it is called '%1' now", now), say("try again"));
}

/// Of a unit that stores no name: what it is called is kept on this computer.
Result<int> tag(Console &console, const Device &device, const std::string &name)
{
    console.onlyAsk(); // the device is told nothing
    Notebook notebook(console);
    if (notebook.trouble())
        return fail(*notebook.trouble());
    const std::string place = unitKeyOf(device);
    const std::string old(unitTagIn(notebook.settings()->resolved(place)));
    MB_TRY(const auto left, notebook.settings()->setTag(place, name));
    if (!left.empty())
        console.note("number " + left.substr(left.rfind(':') + 1) + " of this line was called so, and has no name now");
    const std::string now(unitTagIn(notebook.settings()->resolved(place)));
    return finish(console, device, old, name, now, "kept on this computer");
}

Task<int> rename(Console &console, RenameArguments arguments)
{
    const auto target = co_await parseTarget(console, arguments.device);
    const int length = qt(arguments.name).toUcs4().size();
    if (length < 1 || length > longest)
        co_return fail(Fault::OutOfRange, say("a name has 1 to %1 characters, this one has %2", longest, length),
            say("choose another"));
    co_await checkName("a name", arguments.name);
    Device *const device = co_await connect(console, target);
    if (!target.family->capabilities.rename)
        co_return tag(console, *device, arguments.name);
    if (length > usual)
        console.note("a name above " + std::to_string(usual) + " characters is cut short by some tools");
    const std::string old = device->identity().name;
    co_await device->rename(arguments.name);
    co_await device->refresh();
    co_return finish(console, *device, old, arguments.name, device->identity().name, "read back");
}

} // namespace

Job declareRename(CLI::App &arguments)
{
    const auto a = std::make_shared<RenameArguments>();
    arguments.add_option("device", a->device, "LINK/FAMILY:ADDRESS")->required();
    arguments.add_option("text", a->name, "Its new name, 1 to 64 characters")->required();
    return [a](Console &console) { return rename(console, *a); };
}

} // namespace mb::console
