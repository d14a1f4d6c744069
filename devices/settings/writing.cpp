// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/writing.h"

#include "async/progress.h"
#include "model/family.h"
#include "model/unit.h"
#include "model/writeorder.h"
#include "settings/history.h"
#include "settings/snapshots.h"

#include <algorithm>

namespace mb::settings {
namespace {

/// In the history; no parameter of any family is called so.
constexpr std::string_view numberKey = "number";

SettingsChange changeOf(const Device &device, const Order &order)
{
    SettingsChange change;
    change.unit = unitKeyOf(device);
    change.device = device.selector();
    change.origin = order.origin;
    change.purpose = order.purpose;
    change.of = order.of;
    return change;
}

std::optional<std::int64_t> knownOf(const Device &device, ParameterIndex index)
{
    const ParameterStore::Entry &entry = device.parameters().entry(index);
    return entry.state == ParameterState::Failed ? std::nullopt : entry.raw;
}

/// Asked afresh: another program may have written since. In the order in which they will be written. Where `asks`, fails with the cause
/// if somebody might have to keep one that did not answer: nobody knew what it goes back to.
Task<std::vector<ValueChange>> valuesBefore(Device &device, std::vector<ParameterChange> changes, bool asks)
{
    std::optional<Error> cause;
    bool silent = false;
    for (const ParameterChange &change : changes) {
        const Parameter &parameter = device.parameters().parameter(change.index);
        if (parameter.access == Access::WriteOnly)
            continue;
        if (!silent) {
            const Result<std::int64_t> raw = co_await device.read(change.index).attempt();
            cause = raw ? std::nullopt : std::optional(raw.error());
            silent = cause && (cause->fault == Fault::Timeout || cause->fault == Fault::LinkLost);
        }
        if (cause && asks && mayHaveToConfirm(parameter))
            co_return fail(*cause);
    }
    arrangeForWriting(device.family(), device.parameters(), changes);
    std::vector<ValueChange> values;
    for (const ParameterChange &change : changes) {
        const std::string key(device.parameters().parameter(change.index).key);
        values.push_back({key, knownOf(device, change.index), change.raw, Proof::Open});
    }
    co_return values;
}

bool changedNothing(Fault fault)
{
    return fault == Fault::Refused || fault == Fault::OutOfRange || fault == Fault::Unsupported
        || fault == Fault::Unsafe || fault == Fault::Usage || fault == Fault::NotKept;
}

ValueChange judged(const Device &device, ValueChange value, const TransferOutcome &outcome)
{
    if (outcome.raw) {
        value.proof = outcome.verified.value_or(false) ? Proof::Equal : Proof::Blind;
        return value;
    }
    const Fault fault = outcome.raw.error().fault;
    if (fault == Fault::BadCheck) {
        value.proof = Proof::Differs;
        value.after = knownOf(device, outcome.index).value_or(value.after);
    } else if (changedNothing(fault)) {
        value.proof = Proof::Refused;
    }
    return value;
}

/// Of those that were tried.
std::vector<ValueChange> judged(
    const Device &device, const std::vector<ValueChange> &begun, const std::vector<TransferOutcome> &outcomes)
{
    std::vector<ValueChange> values;
    for (const TransferOutcome &outcome : outcomes) {
        const std::string_view key = device.parameters().parameter(outcome.index).key;
        const auto found = std::ranges::find(begun, key, &ValueChange::key);
        if (found != begun.end())
            values.push_back(judged(device, *found, outcome));
    }
    return values;
}

void notKept(Progress &progress, const Error &error)
{
    progress.log(Severity::Caution, say("the history does not have this write: %1", error.message()));
}

/// The change is on the disk; nothing where nothing is kept, or the disk failed, which is told. NotKept of what asks to be kept.
Task<std::optional<std::int64_t>> beginKept(
    const Family &family, SettingsLog *log, SettingsChange change, Progress &progress)
{
    if (!log || change.values.empty())
        co_return std::nullopt;
    const bool asks = asksToBeKept(change.purpose) && !toConfirm(family, change.values).empty();
    const Result<std::int64_t> begun = co_await log->begin(std::move(change)).attempt();
    if (begun)
        co_return *begun;
    if (asks)
        co_return fail(keepsNothing(begun.error()));
    notKept(progress, begun.error());
    co_return std::nullopt;
}

Task<void> completeKept(
    SettingsLog *log, std::optional<std::int64_t> number, std::vector<ValueChange> values, Progress &progress)
{
    if (!log || !number)
        co_return {};
    if (const auto completed = co_await log->complete(*number, std::move(values)).attempt(); !completed)
        notKept(progress, completed.error());
    co_return {};
}

std::vector<ParameterChange> writesOf(const Family &family, const std::vector<ValueChange> &values,
    std::optional<std::int64_t> (*raw)(const ValueChange &))
{
    std::vector<ParameterChange> writes;
    for (const ValueChange &value : values) {
        const auto index = findParameter(family.parameters, value.key);
        if (const auto wanted = raw(value); index && wanted)
            writes.push_back({*index, *wanted});
    }
    return writes;
}

Task<void> writeAll(
    Device &device, std::vector<ParameterChange> writes, Order order, SettingsLog &log, Progress &progress)
{
    const std::vector<TransferOutcome> outcomes = co_await writeKept(device, std::move(writes), order, &log, progress);
    if (!outcomes.empty() && !outcomes.back().raw)
        co_return fail(outcomes.back().raw.error());
    co_return {};
}

Task<HistoryView> historyOf(const Device &device, SettingsLog &log)
{
    const std::vector<SettingsChange> changes = co_await log.changesOf(unitKeyOf(device));
    co_return viewOf(device.family(), changes);
}

/// What something else has written. Nothing where nothing differs.
Task<void> keepWritten(const Device &device, std::vector<ValueChange> values, Origin origin, SettingsLog &log)
{
    std::erase_if(values, [](const ValueChange &value) { return value.before == value.after; });
    if (values.empty())
        co_return {};
    SettingsChange change = changeOf(device, {origin});
    change.values = values;
    const std::int64_t number = co_await log.begin(std::move(change));
    co_await log.complete(number, std::move(values));
    co_return {};
}

} // namespace

Task<std::vector<TransferOutcome>> writeKept(
    Device &device, std::vector<ParameterChange> changes, Order order, SettingsLog *log, Progress &progress)
{
    SettingsChange change = changeOf(device, order);
    const bool isOrdered = order.purpose == Purpose::Write || order.purpose == Purpose::Restore;
    const bool asks = asksToBeKept(order.purpose) || (isOrdered && order.origin == Origin::Window);
    if (log && !changes.empty()) {
        change.values = co_await valuesBefore(device, changes, asks);
    }
    if (isOrdered && asks && !toConfirm(device.family(), change.values).empty())
        change.purpose = Purpose::Provisional;
    const std::optional<std::int64_t> number = co_await beginKept(device.family(), log, change, progress);
    if (number && order.begun)
        order.begun(*number);
    std::vector<TransferOutcome> outcomes = co_await writeParameters(device, std::move(changes), progress);
    co_await completeKept(log, number, judged(device, change.values, outcomes), progress);
    co_return outcomes;
}

Task<Numbers> numbersBefore(Device &device, std::vector<ParameterChange> changes)
{
    std::vector<ParameterIndex> readable;
    for (const ParameterChange &change : changes) {
        if (device.parameters().parameter(change.index).access != Access::WriteOnly)
            readable.push_back(change.index);
    }
    if (!readable.empty()) {
        NoProgress unseen;
        (void)co_await readParameters(device, std::move(readable), unseen).attempt();
    }
    Numbers known;
    for (const ParameterChange &change : changes) {
        const Parameter &parameter = device.parameters().parameter(change.index);
        const auto raw = device.parameters().entry(change.index).raw;
        known.emplace_back(
            parameter.key, raw ? std::optional(static_cast<double>(*raw) / parameter.one) : std::nullopt);
    }
    co_return known;
}

Task<void> keepReplaced(const Device &device, Numbers before, Origin origin, SettingsLog &log)
{
    std::vector<ValueChange> values;
    for (const auto &[key, number] : before) {
        const auto index = findParameter(device.family().parameters, key);
        const auto now = index ? knownOf(device, *index) : std::nullopt;
        if (!now)
            continue;
        const Parameter &parameter = device.parameters().parameter(*index);
        const Result<std::int64_t> raw = number ? toRaw(parameter, *number) : fail(Fault::OutOfRange);
        const Proof proof = parameter.access == Access::WriteOnly ? Proof::Blind : Proof::Equal;
        values.push_back({key, raw ? std::optional(*raw) : std::nullopt, *now, proof});
    }
    co_await keepWritten(device, std::move(values), origin, log);
    co_return {};
}

Task<int> rewriteKept(Device &device, Origin origin, SettingsLog *log, Progress &progress)
{
    SettingsChange change = changeOf(device, {origin, Purpose::Restore});
    for (const ParameterChange &lost : lostSettings(device.family(), device.knowledge().profile()))
        change.values.push_back(
            {std::string(device.parameters().parameter(lost.index).key), std::nullopt, lost.raw, Proof::Open});
    const std::optional<std::int64_t> number = co_await beginKept(device.family(), log, change, progress);
    const int written = co_await rewriteSettings(device, progress);
    for (ValueChange &value : change.values)
        value.proof = Proof::Blind;
    co_await completeKept(log, number, std::move(change.values), progress);
    co_return written;
}

Task<void> renumberKept(Device &device, int number, Origin origin, SettingsLog *log, Progress &progress)
{
    SettingsChange change = changeOf(device, {origin});
    const std::string unit = change.unit;
    change.values.push_back({std::string(numberKey), device.identity().address, number, Proof::Open});
    const std::optional<std::int64_t> kept = co_await beginKept(device.family(), log, change, progress);
    const Result<void> renumbered = co_await device.renumber(number).attempt();
    if (renumbered)
        change.values.front().proof = device.identity().address == number ? Proof::Equal : Proof::Blind;
    else if (changedNothing(renumbered.error().fault))
        change.values.front().proof = Proof::Refused;
    co_await completeKept(log, kept, std::move(change.values), progress);
    if (!renumbered)
        co_return fail(renumbered.error());
    if (log && unitByOf(unit) == UnitBy::Place) {
        if (const auto moved = co_await log->moved(unit, renumberedPlaceKey(unit, number)).attempt(); !moved)
            notKept(progress, moved.error());
    }
    co_return {};
}

Task<SettingsChange> undo(Device &device, Origin origin, SettingsLog &log, Progress &progress, Begun begun)
{
    const HistoryView history = co_await historyOf(device, log);
    if (!history.undo)
        co_return fail(Fault::Refused, say("the history of %1 has nothing to undo", device.selector()));
    std::vector<ParameterChange> writes = writesOf(device.family(), undoable(device.family(), *history.undo),
        [](const ValueChange &value) { return value.before; });
    Order order{origin, Purpose::Undo, history.undo->number, std::move(begun)};
    auto writing = writeAll(device, std::move(writes), std::move(order), log, progress);
    co_await std::move(writing);
    co_return *history.undo;
}

Task<SettingsChange> redo(Device &device, Origin origin, SettingsLog &log, Progress &progress, Begun begun)
{
    const HistoryView history = co_await historyOf(device, log);
    if (!history.redo)
        co_return fail(Fault::Refused, say("the history of %1 has nothing to do again", device.selector()));
    std::vector<ParameterChange> writes = writesOf(device.family(), undoable(device.family(), *history.redo),
        [](const ValueChange &value) { return std::optional(value.after); });
    Order order{origin, Purpose::Redo, history.redo->number, std::move(begun)};
    auto writing = writeAll(device, std::move(writes), std::move(order), log, progress);
    co_await std::move(writing);
    co_return *history.redo;
}

Task<int> noticeForeign(const Device &device, SettingsLog &log)
{
    const std::vector<SettingsChange> changes = co_await log.changesOf(unitKeyOf(device));
    if (changes.empty() || unitByOf(changes.back().unit) == UnitBy::Place)
        co_return 0; // another unit may stand there now, and it was never left as anything
    const HistoryView history = viewOf(device.family(), changes);
    std::vector<ValueChange> values;
    for (const auto &[key, raw] : history.values) {
        const auto index = findParameter(device.family().parameters, key);
        const auto known = index ? knownOf(device, *index) : std::nullopt;
        if (known && *known != raw && device.parameters().parameter(*index).nature == Nature::Setting)
            values.push_back({key, raw, *known, Proof::Equal});
    }
    const int count = static_cast<int>(values.size());
    co_await keepWritten(device, std::move(values), Origin::Elsewhere, log);
    co_return count;
}

} // namespace mb::settings
