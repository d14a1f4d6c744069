// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/preflight.h"

#include "experiment/owedgains.h"
#include "model/standstill.h"

namespace mb::service {
namespace {

/// Names of the states in which nothing may be done to a unit.
Result<void> checkState(const Device &device, const Recipe &recipe)
{
    switch (device.identity().state) {
    case DeviceState::Unassigned:
        if (recipe.test)
            return fail(Fault::Unsafe, say("this unit has no number yet, and without one its motor may not be driven"),
                say("give it a number first, or take the self-test out of the recipe"));
        return {};
    case DeviceState::Bootloader:
        if (!recipe.firmware)
            return fail(Fault::Unsafe, say("this unit waits in its bootloader, and the recipe has no firmware for it"),
                say("name a firmware in the recipe"));
        return {};
    case DeviceState::Duplicate: // standsStill() refuses it
    case DeviceState::Online: return {};
    }
    return {};
}

/// Gains that an experiment tried are no state of a unit that could be backed up, or pass.
Task<void> checkOwed(Device &device, tuning::ExperimentJournal &trials)
{
    const std::vector<tuning::OwedGains> owed = co_await tuning::lookForOwed(device, trials);
    if (owed.empty())
        co_return {};
    co_return fail(Fault::Refused, say("trial %1 did not put back what it changed", owed.front().trial),
        say("put it back first, as 'motorbenchctl set %1 %2' does", device.selector(),
            tuning::assignmentsOf(device.family(), owed.front().values)));
}

} // namespace

Task<void> preflight(Device &device, const RecipeMatter &matter, tuning::ExperimentJournal *trials, Progress &progress)
{
    co_await checkState(device, matter.recipe);
    co_await standsStill(device);
    if (trials && device.identity().state != DeviceState::Bootloader)
        co_await checkOwed(device, *trials);
    if (!matter.recipe.firmware) {
        co_await checkOffered(device, matter);
        co_return {};
    }
    UpdateOptions options = updateOptionsOf(*matter.recipe.firmware);
    options.dryRun = true;
    const UpdateReport report = co_await device.family().update(device, matter.image, options, progress);
    if (report.outcome == UpdateOutcome::Done || report.outcome == UpdateOutcome::UpToDate)
        co_return {};
    const Fault fault = report.outcome == UpdateOutcome::Refused ? Fault::Unsafe : Fault::Refused;
    co_return fail(report.fault.value_or(fault), report.evidence, report.remedy);
}

Result<void> checkOffered(const Device &device, const RecipeMatter &matter)
{
    for (const ParameterChange &change : matter.parameters) {
        if (!device.offers(change.index))
            return fail(Fault::Refused,
                say("this unit does not have %1 of the recipe", device.parameters().parameter(change.index).key),
                say("take it out of the recipe's parameters, or serve such units by a recipe of their own"));
    }
    return {};
}

UpdateOptions updateOptionsOf(const FirmwareRule &rule)
{
    constexpr std::string_view mark = "?target=";
    UpdateOptions options;
    const auto at = rule.via.find(mark);
    options.via = rule.via.substr(0, at);
    if (at != std::string::npos)
        options.target = rule.via.substr(at + mark.size());
    return options;
}

} // namespace mb::service
