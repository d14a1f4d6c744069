// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/confirmation.h"

#include "model/family.h"
#include "model/unit.h"
#include "settings/writing.h"

#include <algorithm>

namespace mb::settings {
namespace {

bool isSeenStill(const Device &device)
{
    return device.link().state() == LinkState::Open && device.liveness().heard && !device.liveness().moving;
}

/// What acts after a restart is not what the device says before.
bool mayHave(const Device &device, const ValueChange &value)
{
    const auto index = findParameter(device.family().parameters, value.key);
    const ParameterStore::Entry &entry = device.parameters().entry(*index);
    const bool isKnown = entry.raw && entry.state != ParameterState::Failed;
    return !isKnown || entry.raw == value.after || device.family().parameters[index->value].afterRestart;
}

/// What acts at once is. What acts after a restart is when the unit was asked since, and has it.
bool isInForce(const Device &device, const std::vector<ValueChange> &values)
{
    const auto table = device.family().parameters;
    return std::ranges::all_of(values, [&](const ValueChange &value) {
        const auto index = findParameter(table, value.key);
        const ParameterStore::Entry &entry = device.parameters().entry(*index);
        return !table[index->value].afterRestart || (entry.state == ParameterState::Stored && entry.raw == value.after);
    });
}

/// What nobody has kept of this value, where it stood; where something else may be in force now it does no more.
std::optional<ValueChange> takeOpen(std::vector<SettingsChange> &open, const ValueChange &later)
{
    std::optional<ValueChange> taken;
    for (SettingsChange &change : open) {
        const auto found = std::ranges::find(change.values, later.key, &ValueChange::key);
        if (found == change.values.end())
            continue;
        taken = *found;
        if (later.proof != Proof::Open)
            change.values.erase(found);
    }
    return taken;
}

/// Of a change its values that somebody has to keep.
std::vector<ValueChange> openOf(const Family &family, const SettingsChange &change, std::vector<SettingsChange> &before)
{
    std::vector<ValueChange> values;
    for (ValueChange value : change.values) {
        const auto over = value.proof == Proof::Refused ? std::nullopt : takeOpen(before, value);
        if (over && change.origin == Origin::Window)
            value.before = over->before;
        if (asksToBeKept(change.purpose) || (over && change.origin == Origin::Window))
            values.push_back(std::move(value));
    }
    return toConfirm(family, values);
}

} // namespace

std::vector<SettingsChange> unconfirmed(const Family &family, std::span<const SettingsChange> changes)
{
    std::vector<SettingsChange> open;
    for (const SettingsChange &change : changes) {
        if (change.purpose == Purpose::Keep)
            std::erase_if(open, [&change](const SettingsChange &known) { return known.number == change.of; });
        std::vector<ValueChange> values = openOf(family, change, open);
        if (values.empty())
            continue;
        open.push_back(change);
        open.back().values = std::move(values);
    }
    std::erase_if(open, [](const SettingsChange &change) { return change.values.empty(); });
    return open;
}

std::vector<SettingsChange> unconfirmedOf(const Device &device, std::span<const SettingsChange> changes)
{
    std::vector<SettingsChange> open = unconfirmed(device.family(), changes);
    for (SettingsChange &change : open)
        std::erase_if(change.values, [&device](const ValueChange &value) { return !mayHave(device, value); });
    std::erase_if(open, [](const SettingsChange &change) { return change.values.empty(); });
    return open;
}

Task<std::vector<SettingsChange>> findUnconfirmed(const Device &device, SettingsLog &log)
{
    const std::vector<SettingsChange> changes = co_await log.changesOf(unitKeyOf(device));
    co_return unconfirmedOf(device, changes);
}

Task<void> keepChange(const Device &device, std::int64_t number, SettingsLog &log)
{
    SettingsChange kept;
    kept.unit = unitKeyOf(device);
    kept.device = device.selector();
    kept.purpose = Purpose::Keep;
    kept.of = number;
    co_await log.begin(std::move(kept));
    co_return {};
}

Task<bool> putBack(Device &device, std::int64_t number, SettingsLog &log, Progress &progress)
{
    const std::vector<SettingsChange> open = co_await findUnconfirmed(device, log);
    const auto change = std::ranges::find(open, number, &SettingsChange::number);
    if (change == open.end())
        co_return false;
    if (!isSeenStill(device))
        co_return fail(Fault::Unsafe, say("the motor is not seen to stand"), say("stop it, then put the values back"));
    std::vector<ParameterChange> writes;
    for (const ValueChange &value : change->values)
        writes.push_back({*findParameter(device.family().parameters, value.key), *value.before});
    const Order order{Origin::Window, Purpose::Revert, number};
    const std::vector<TransferOutcome> outcomes = co_await writeKept(device, std::move(writes), order, &log, progress);
    if (!outcomes.empty() && !outcomes.back().raw)
        co_return fail(outcomes.back().raw.error());
    co_return true;
}

Confirmation::State Confirmation::look(const Device &device, Instant now)
{
    if (m_state == State::AwaitsRestart && isInForce(device, m_values)) {
        m_state = State::Counting;
        m_until = now + confirmTime;
    }
    if ((m_state == State::Counting && now >= m_until) || m_state == State::Due)
        m_state = State::AwaitsStandstill;
    if (m_state == State::AwaitsStandstill && isSeenStill(device))
        m_state = State::Due;
    return m_state;
}

Duration Confirmation::left(Instant now) const
{
    return m_state == State::AwaitsRestart ? confirmTime : std::max<Duration>(m_until - now, Duration::zero());
}

} // namespace mb::settings
