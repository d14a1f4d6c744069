// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/owedgains.h"

#include "async/progress.h"
#include "experiment/direction.h"
#include "experiment/gains.h"
#include "experiment/seconds.h"
#include "experiment/verdict.h"
#include "model/family.h"
#include "model/unit.h"

#include <algorithm>
#include <map>

namespace mb::tuning {
namespace {

constexpr Duration storeMargin = std::chrono::seconds(5); ///< over the time after which a unit stores by itself

/// It must have stored what was written then, and nothing says that it did not.
Task<bool> hasStored(Device &device, double since)
{
    const Duration now = device.clock().now().time_since_epoch() + device.clock().unixOffset();
    if (inSeconds(now) - since < inSeconds(storingTime(device)))
        co_return false;
    NoProgress unseen;
    auto storing = device.store(unseen);
    const Result<bool> stored = co_await std::move(storing).attempt();
    co_return stored.has_value();
}

using Present = std::map<std::string, std::int64_t>;

/// What the unit has of these now; empty where that is not known.
Task<Present> presentOf(Device &device, std::vector<OwedValue> values)
{
    auto reading = readReplaced(device, changesOf(device.family(), values));
    const auto read = co_await std::move(reading).attempt();
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
    auto releasing = journal.release(unitKeyOf(device), std::move(written));
    (void)co_await std::move(releasing).attempt();
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
    auto asking = journal.owedTo(unitKeyOf(device));
    std::vector<OwedGains> owed = co_await std::move(asking);
    auto looking = stillOwed(device, journal, std::move(owed));
    co_return co_await std::move(looking);
}

Task<std::vector<OwedGains>> stillOwed(Device &device, ExperimentJournal &journal, std::vector<OwedGains> owed)
{
    std::vector<OwedGains> rest;
    for (OwedGains &debt : owed) {
        if (debt.isUnderWay)
            continue;
        auto looking = presentOf(device, debt.values);
        const Present present = co_await std::move(looking);
        auto releasing = releaseWritten(device, journal, present, debt);
        co_await std::move(releasing);
        if (debt.values.empty())
            continue;
        const auto isThere = [&present](const OwedValue &value) { return has(present, value); };
        if (!std::ranges::all_of(debt.values, isThere)) {
            rest.push_back(std::move(debt));
            continue;
        }
        if (storesLater(device)) {
            auto proving = hasStored(device, debt.time);
            if (!co_await std::move(proving))
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
    (void)co_await std::move(confirming);
    auto resting = untilAtRest(device);
    if (!co_await std::move(resting) || !device.isSeenStopped()) // another may drive a motor that is blocked
        co_return fail(
            Fault::Unsafe, say("the motor was not seen to stand"), say("stop it before its gains are put back"));
    auto writing = writeGains(device, changesOf(device.family(), owed.values));
    co_await std::move(writing);
    auto marking = markPutBack(device, journal, owed.trial);
    co_await std::move(marking);
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
