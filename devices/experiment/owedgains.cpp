// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/owedgains.h"

#include "async/progress.h"
#include "async/seconds.h"
#include "experiment/direction.h"
#include "experiment/gains.h"
#include "experiment/seconds.h"
#include "experiment/verdict.h"
#include "model/family.h"
#include "model/standstill.h"
#include "model/unit.h"

#include <algorithm>
#include <map>

namespace mb::tuning {
namespace {

constexpr Duration storeMargin = std::chrono::seconds(5); ///< over the time after which a unit stores by itself

/// It must have stored what was written then, and nothing says that it did not.
Task<bool> hasStored(Device &device, double since)
{
    if (unixSeconds(device.clock()) - since < inSeconds(storingTime(device)))
        co_return false;
    NoProgress unseen;
    const Result<bool> stored = co_await device.store(unseen).attempt();
    co_return stored.has_value();
}

using Present = std::map<std::string, std::int64_t>;

/// What the unit has of these now; empty where that is not known.
Task<Present> presentOf(Device &device, std::vector<OwedValue> values)
{
    const auto read = co_await readReplaced(device, changesOf(device.family(), values)).attempt();
    Present present;
    for (const OwedValue &value : read.value_or(std::vector<OwedValue>()))
        present[value.key] = value.raw;
    co_return present;
}

bool has(const Present &present, const OwedValue &value)
{
    const auto now = present.find(value.key);
    return now != present.end() && now->second == value.raw;
}

/// It was put back, and somebody has written another since; or a tuning keeps what is there.
bool isOver(const Present &present, const OwedGains &debt, const OwedValue &value)
{
    const auto now = present.find(value.key);
    if (now == present.end() || !value.tried)
        return false;
    return now->second == *value.tried ? value.isKept : debt.isPutBack && now->second != value.raw;
}

/// Takes what is there on purpose out of the debt.
Task<void> releaseWritten(const Device &device, ExperimentJournal &journal, const Present &present, OwedGains &debt)
{
    std::vector<std::string> written;
    for (const OwedValue &value : debt.values) {
        if (isOver(present, debt, value))
            written.push_back(value.key);
    }
    if (written.empty())
        co_return {};
    std::erase_if(debt.values, [&](const OwedValue &value) { return isOver(present, debt, value); });
    (void)co_await journal.release(unitKeyOf(device), std::move(written)).attempt();
    co_return {};
}

} // namespace

Duration storingTime(const Device &device)
{
    return device.family().capabilities.storesAfter + storeMargin;
}

bool storesLater(const Device &device)
{
    return device.family().capabilities.storesAfter > Duration::zero() && !device.link().address().isSimulated();
}

Task<void> markPutBack(Device &device, ExperimentJournal &journal, std::int64_t trial)
{
    auto marking = storesLater(device) ? journal.markPutBack(trial) : journal.settle(trial);
    co_await std::move(marking);
    co_return {};
}

Task<std::vector<OwedGains>> lookForOwed(Device &device, ExperimentJournal &journal)
{
    std::vector<OwedGains> owed = co_await journal.owedTo(unitKeyOf(device));
    co_return co_await stillOwed(device, journal, std::move(owed));
}

Task<std::vector<OwedGains>> stillOwed(
    Device &device, ExperimentJournal &journal, std::vector<OwedGains> owed, bool mayWait)
{
    std::vector<OwedGains> rest;
    for (OwedGains &debt : owed) {
        if (debt.isUnderWay)
            continue;
        const Present present = co_await presentOf(device, debt.values);
        co_await releaseWritten(device, journal, present, debt);
        if (debt.values.empty())
            continue;
        const auto isThere = [&present](const OwedValue &value) { return has(present, value); };
        if (!std::ranges::all_of(debt.values, isThere)) {
            rest.push_back(std::move(debt));
            continue;
        }
        if (storesLater(device)) {
            if (!mayWait)
                continue;
            if (const bool stored = co_await hasStored(device, debt.time); !stored)
                continue;
        }
        (void)co_await journal.settle(debt.trial).attempt();
    }
    co_return rest;
}

Task<void> payOwed(Device &device, ExperimentJournal &journal, OwedGains owed)
{
    co_await hasNoOtherMaster(device);
    bool stands = co_await untilAtRest(device); // what somebody else turns is his to stop
    if (stands)
        stands = co_await confirmStop(device);
    if (!stands)
        co_return fail(
            Fault::Unsafe, say("the motor was not seen to stand"), say("stop it before its gains are put back"));
    co_await writeGains(device, changesOf(device.family(), owed.values));
    co_await markPutBack(device, journal, owed.trial);
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
