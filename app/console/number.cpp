// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/notebook.h"
#include "app/console/target.h"
#include "app/console/verb.h"
#include "async/progress.h"
#include "settings/writing.h"

#include <memory>

namespace mb::console {
namespace {

struct NumberArguments {
    std::string device;
    std::string number;
};

/// Two units of one number could not be told apart, and could not be driven.
Result<void> checkFree(Console &console, const Device &device, int number)
{
    for (const Device *other : console.session().devices()) {
        if (other != &device && &other->family() == &device.family() && other->identity().address == number)
            return fail(Fault::OutOfRange,
                say("number %1 is taken by another %2 on this link", number, device.family().title),
                say("choose a free one"));
    }
    return {};
}

/// It has taken the number and uses it after its next restart.
bool isPending(const Device &device, int number)
{
    const auto table = device.parameters().table();
    for (std::uint16_t i = 0; i < table.size(); ++i) {
        const ParameterStore::Entry &entry = device.parameters().entry({i});
        if (table[i].afterRestart && entry.raw == number && entry.state == ParameterState::Assumed)
            return true;
    }
    return false;
}

Task<int> renumber(Console &console, NumberArguments arguments)
{
    const auto target = co_await parseTarget(console, arguments.device);
    if (!target.family->capabilities.renumber)
        co_return fail(Fault::Unsupported, say("%1 has no number that can be changed", target.family->key),
            say("its place on the link is fixed"));
    const int number = co_await parseInteger("NEW", arguments.number, 1, target.family->capabilities.lastAddress);
    Device *const device = co_await connect(console, target);
    // What is refused for its range or its owner is refused before the device is told anything.
    console.onlyAsk();
    co_await checkFree(console, *device, number);
    const int old = device->identity().address;
    Notebook notebook(console);
    notebook.noteTrouble();
    NoProgress progress;
    auto renumbering
        = settings::renumberKept(*device, number, settings::Origin::Console, notebook.settings(), progress);
    co_await std::move(renumbering);
    const bool verified = device->identity().address == number;
    const bool pending = !verified && isPending(*device, number);
    if (console.json()) {
        console.out().json({
            {QStringLiteral("device"), qt(device->selector())},
            {QStringLiteral("old"), old},
            {QStringLiteral("new"), number},
            {QStringLiteral("verified"), pending ? QJsonValue() : QJsonValue(verified)},
        });
    } else {
        console.out().line("number " + std::to_string(old) + " → " + std::to_string(number)
            + (verified       ? ", it answers as " + device->selector()
                    : pending ? ", in force after its next power cycle"
                              : ", not verified"));
    }
    if (verified || pending)
        co_return exitDone;
    co_return fail(Fault::BadCheck, say("the device did not answer under its new number"),
        say("'motorbenchctl scan' shows where it is"));
}

} // namespace

Job declareNumber(CLI::App &arguments)
{
    const auto a = std::make_shared<NumberArguments>();
    arguments.add_option("device", a->device, "LINK/FAMILY:ADDRESS")->required();
    arguments.add_option("new", a->number, "Its new number")->required();
    return [a](Console &console) { return renumber(console, *a); };
}

} // namespace mb::console
