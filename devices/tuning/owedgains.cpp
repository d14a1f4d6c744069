// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/owedgains.h"

#include "model/family.h"
#include "tuning/direction.h"
#include "tuning/gains.h"
#include "tuning/verdict.h"

namespace mb::tuning {
namespace {

/// The unit has every value that is owed to it.
Task<bool> has(Device &device, std::vector<OwedValue> values)
{
    auto reading = readReplaced(device, changesOf(device.family(), values));
    const auto present = co_await std::move(reading).attempt();
    co_return present &&*present == values;
}

} // namespace

Task<std::vector<OwedGains>> lookForOwed(Device &device, ExperimentJournal &journal)
{
    auto asking = journal.owedTo(unitOf(device));
    std::vector<OwedGains> owed = co_await std::move(asking);
    std::vector<OwedGains> rest;
    for (OwedGains &debt : owed) {
        auto looking = has(device, debt.values);
        if (!co_await std::move(looking)) {
            rest.push_back(std::move(debt));
            continue;
        }
        auto settling = journal.settle(debt.trial);
        (void)co_await std::move(settling).attempt();
    }
    co_return rest;
}

Task<void> payOwed(Device &device, ExperimentJournal &journal, OwedGains owed)
{
    auto confirming = confirmStop(device);
    if (!co_await std::move(confirming))
        co_return fail(Fault::Unsafe, "the motor was not seen to stand; stop it before its gains are put back");
    auto writing = writeGains(device, changesOf(device.family(), owed.values));
    co_await std::move(writing);
    auto settling = journal.settle(owed.trial);
    co_await std::move(settling);
    co_return {};
}

std::string assignmentsOf(const Family &family, const std::vector<OwedValue> &values)
{
    std::string text;
    for (const OwedValue &value : values) {
        if (const auto index = findParameter(family.parameters, value.key))
            text += (text.empty() ? "" : " ") + value.key + '=' + toText(family.parameters[index->value], value.raw);
    }
    return text;
}

} // namespace mb::tuning
