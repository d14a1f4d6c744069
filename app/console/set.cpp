// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/assignments.h"
#include "app/console/notebook.h"
#include "app/console/parameterrows.h"
#include "app/console/progressline.h"
#include "app/console/target.h"
#include "app/console/verb.h"
#include "settings/writing.h"

#include <algorithm>
#include <memory>

namespace mb::console {
namespace {

struct SetArguments {
    std::string device;
    std::vector<std::string> assignments;
    bool store = false;
};

/// True: each was read back and is equal. False: one differs. Nothing: one cannot be read back.
std::optional<bool> verdictOf(const std::vector<TransferOutcome> &outcomes)
{
    std::optional<bool> verdict = true;
    for (const TransferOutcome &outcome : outcomes) {
        if (!outcome.raw && outcome.raw.error().fault == Fault::BadCheck)
            return false;
        if (!outcome.verified)
            verdict.reset();
    }
    return verdict;
}

void show(
    Console &console, const Device &device, const std::vector<ParameterIndex> &indices, std::optional<bool> verified)
{
    if (console.json()) {
        QJsonObject object = parametersToJson(device, indices);
        object.insert(QStringLiteral("verified"), verified ? QJsonValue(*verified) : QJsonValue());
        console.out().json(object);
    } else {
        printParameters(console, device, indices);
    }
}

/// Yields the error that is to be told besides the values, if any. Fails when nothing is known to print.
Task<std::optional<Error>> store(Console &console, Device &device)
{
    ProgressLine progress(console);
    auto storing = device.store(progress);
    const Result<bool> stored = co_await std::move(storing).attempt();
    if (!stored)
        co_return std::optional<Error>(
            stored.error().about(say("the values are in force but not proved to be stored")));
    if (!*stored)
        console.note("this device cannot prove that it stored the values; read them again after a power cycle");
    co_return std::optional<Error>();
}

Task<int> set(Console &console, SetArguments arguments)
{
    const auto target = parseTarget(console, arguments.device);
    if (!target)
        co_return fail(target.error());
    const auto changes = parseAssignments(*target->family, arguments.assignments);
    if (!changes)
        co_return fail(changes.error());
    Notebook notebook(console); // before the device is found: what is refused at once must not come after an answer
    auto connecting = connect(console, *target);
    Device *const device = co_await std::move(connecting);
    if (auto ready = needsApplication(*device); !ready)
        co_return fail(ready.error());
    std::vector<TransferOutcome> outcomes;
    {
        ProgressLine progress(console);
        auto writing
            = settings::writeKept(*device, *changes, {settings::Origin::Console}, notebook.settings(), progress);
        outcomes = co_await std::move(writing);
    }
    std::optional<Error> error = firstError(*device, outcomes);
    if (error && outcomes.size() > 1)
        error->detail = say("%1 (written before it: %2)", error->detail, outcomes.size() - 1);
    if (error && error->fault != Fault::BadCheck)
        co_return console.fails(*error); // judged now: what is polled meanwhile was not sent by this verb
    if (arguments.store && !error) {
        auto storing = store(console, *device);
        error = co_await std::move(storing);
    }
    std::vector<ParameterIndex> indices;
    for (const ParameterChange &change : *changes)
        indices.push_back(change.index);
    show(console, *device, indices, error ? std::optional<bool>(false) : verdictOf(outcomes));
    if (!error)
        co_return exitDone;
    if (error->fault == Fault::Timeout)
        error->fault = Fault::BadCheck;
    co_return console.fails(*error);
}

} // namespace

Job declareSet(CLI::App &arguments)
{
    const auto a = std::make_shared<SetArguments>();
    arguments.add_option("device", a->device, "LINK/FAMILY:ADDRESS")->required();
    arguments.add_option("assignment", a->assignments, "KEY=VALUE, in the unit that 'parameters' shows")->required();
    arguments.add_flag("--store", a->store, "Make it survive a power cycle, and prove it");
    return [a](Console &console) { return set(console, *a); };
}

} // namespace mb::console
