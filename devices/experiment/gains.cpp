// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/gains.h"

#include "async/progress.h"
#include "model/family.h"
#include "model/loopparameters.h"

#include <algorithm>

namespace mb::tuning {
namespace {

bool isReadable(const Device &device, ParameterIndex index)
{
    return device.parameters().parameter(index).access != Access::WriteOnly && device.offers(index);
}

bool isKnown(const Device &device, ParameterIndex index)
{
    const auto &entry = device.parameters().entry(index);
    return entry.raw && entry.state != ParameterState::Unknown && entry.state != ParameterState::Failed;
}

} // namespace

Message writeOrKeep()
{
    return say("write the gains of this loop once, or keep what is tried");
}

namespace {

/// Of one that cannot be read.
Result<void> checkWritten(const Device &device, ParameterIndex index)
{
    const std::string key(device.parameters().parameter(index).key);
    if (isKnown(device, index) && !device.knowledge().profile().lost.contains(key))
        return {};
    return fail(Fault::OutOfRange, say("%1 cannot be read, so it could not be put back", key), writeOrKeep());
}

} // namespace

Result<void> checkTried(const Family &family, ParameterIndex index)
{
    const Parameter &parameter = family.parameters[index.value];
    const std::string key(parameter.key);
    if (parameter.access == Access::ReadOnly)
        return fail(Fault::OutOfRange, say("%1 is read-only", key), say("it cannot be tried"));
    if (parameter.nature != Nature::Setting || parameter.afterRestart || key == family.trials->never)
        return fail(
            Fault::OutOfRange, say("%1 is never part of an experiment", key), say("write it with 'motorbenchctl set'"));
    return {};
}

std::vector<ParameterChange> triable(const Family &family, const std::vector<ParameterChange> &changes)
{
    std::vector<ParameterChange> some;
    std::copy_if(changes.begin(), changes.end(), std::back_inserter(some),
        [&family](const ParameterChange &change) { return checkTried(family, change.index).has_value(); });
    return some;
}

Task<std::vector<std::pair<std::string, std::optional<double>>>> readGains(
    Device &device, Mode mode, int axis, int slot)
{
    std::vector<std::pair<std::string, std::optional<double>>> gains;
    const LoopGains *const loop = loopOf(device.family(), mode);
    const auto rows = loop ? loopParameters(device.family(), *loop, axis, slot) : std::vector<ParameterIndex>();
    for (const ParameterIndex index : rows) {
        if (!device.offers(index))
            continue;
        if (isReadable(device, index))
            co_await device.read(index);
        std::optional<double> value;
        if (isKnown(device, index)) {
            const Value known = toValue(device.parameters().parameter(index), *device.parameters().entry(index).raw);
            if (const double *number = std::get_if<double>(&known))
                value = *number;
        }
        gains.emplace_back(device.parameters().parameter(index).key, value);
    }
    co_return gains;
}

Result<void> checkPutBack(const Device &device, Mode mode, int axis, int slot)
{
    const LoopGains *const loop = loopOf(device.family(), mode);
    const auto rows = loop ? loopParameters(device.family(), *loop, axis, slot) : std::vector<ParameterIndex>();
    for (const ParameterIndex index : rows) {
        if (!device.offers(index) || isReadable(device, index))
            continue;
        MB_TRY_VOID(checkWritten(device, index));
    }
    return {};
}

Task<std::vector<OwedValue>> readReplaced(Device &device, std::vector<ParameterChange> changes)
{
    std::vector<OwedValue> values;
    for (const ParameterChange &change : changes) {
        const std::string key(device.parameters().parameter(change.index).key);
        if (isReadable(device, change.index)) {
            co_await device.read(change.index);
        } else if (auto written = checkWritten(device, change.index); !written) {
            co_return fail(written.error());
        }
        values.push_back({key, *device.parameters().entry(change.index).raw, change.raw});
    }
    co_return values;
}

Task<void> writeGains(Device &device, std::vector<ParameterChange> changes)
{
    bool isSeen = false;
    for (int pass = 0; pass < 2 && !isSeen; ++pass) {
        NoProgress progress;
        const std::vector<TransferOutcome> outcomes = co_await writeParameters(device, changes, progress);
        isSeen = true;
        for (const TransferOutcome &outcome : outcomes) {
            if (!outcome.raw)
                co_return fail(outcome.raw.error());
            isSeen = isSeen && outcome.verified.has_value();
        }
    }
    co_return {};
}

std::vector<ParameterChange> changesOf(const Family &family, const std::vector<OwedValue> &values)
{
    std::vector<ParameterChange> changes;
    for (const OwedValue &value : values) {
        if (const auto index = findParameter(family.parameters, value.key))
            changes.push_back({*index, value.raw});
    }
    return changes;
}

std::vector<std::pair<std::string, std::optional<double>>> numbersOf(
    const Family &family, const std::vector<ParameterChange> &changes)
{
    std::vector<std::pair<std::string, std::optional<double>>> numbers;
    for (const ParameterChange &change : changes) {
        const Parameter &parameter = family.parameters[change.index.value];
        const Value value = toValue(parameter, change.raw);
        const double *const number = std::get_if<double>(&value);
        numbers.emplace_back(
            parameter.key, number ? *number : static_cast<double>(change.raw)); // on and off are 1 and 0
    }
    return numbers;
}

bool needsRestart(const Device &device, const std::vector<ParameterChange> &changes)
{
    const TrialTraits &traits = *device.family().trials;
    if (traits.atBoot.empty() || traits.atBootDialects.find(device.identity().dialect) == std::string_view::npos)
        return false;
    return std::ranges::any_of(changes, [&](const ParameterChange &change) {
        const auto before = device.parameters().entry(change.index).raw;
        return device.parameters().parameter(change.index).key == traits.atBoot && before != change.raw;
    });
}

} // namespace mb::tuning
