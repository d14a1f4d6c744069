// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/storing.h"

#include "async/seconds.h"
#include "model/family.h"
#include "model/unit.h"

#include <cmath>
#include <map>

namespace mb::settings {
namespace {

constexpr double margin
    = 1.0; ///< s, over the time after which a unit stores by itself: it takes a while, and writes repeats

using Values = std::map<std::string, std::int64_t>;

/// What was written so lately that flash may not have it, by key. A write that changed nothing waits for nothing.
Values unstored(const Device &device, const std::vector<SettingsChange> &changes)
{
    const double span = static_cast<double>(device.family().capabilities.storesAfter.count()) + margin;
    const double now = unixSeconds(device.clock());
    Values values;
    for (const SettingsChange &change : changes) {
        if (change.purpose == Purpose::Store)
            values.clear();
        if (std::abs(now - change.time) > span || change.origin == Origin::Elsewhere)
            continue;
        for (const ValueChange &value : change.values) {
            if (value.proof != Proof::Refused && (value.proof == Proof::Open || value.before != value.after))
                values[value.key] = value.after;
        }
    }
    return values;
}

/// As if this program had written it: what reads back different was not, or is gone.
Task<void> recall(Device &device, SettingsLog &log)
{
    const Result<std::vector<SettingsChange>> changes = co_await log.changesOf(unitKeyOf(device)).attempt();
    if (!changes)
        co_return {}; // who keeps the history tells what is wrong with it
    for (const auto &[key, raw] : unstored(device, *changes)) {
        const auto index = findParameter(device.family().parameters, key);
        const Parameter *const parameter = index ? &device.parameters().parameter(*index) : nullptr;
        if (parameter && parameter->persistent && parameter->access == Access::ReadWrite && !parameter->afterRestart
            && parameter->nature == Nature::Setting)
            device.parameters().setWritten(*index, raw, device.clock().now());
    }
    co_return {};
}

} // namespace

Task<std::vector<TransferOutcome>> readKept(
    Device &device, std::vector<ParameterIndex> indices, SettingsLog *log, Progress &progress)
{
    if (log && device.family().capabilities.storesAfter > std::chrono::seconds(0))
        co_await recall(device, *log);
    co_return co_await readParameters(device, std::move(indices), progress);
}

Task<bool> storeKept(Device &device, Origin origin, SettingsLog *log, Progress &progress)
{
    const bool stored = co_await device.store(progress);
    if (stored && log)
        (void)co_await keepStored(device, origin, *log).attempt();
    co_return stored;
}

Task<void> keepStored(const Device &device, Origin origin, SettingsLog &log)
{
    SettingsChange change;
    change.unit = unitKeyOf(device);
    change.device = device.selector();
    change.origin = origin;
    change.purpose = Purpose::Store;
    co_await log.begin(std::move(change));
    co_return {};
}

} // namespace mb::settings
