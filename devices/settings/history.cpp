// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/history.h"

#include "model/family.h"
#include "model/writeorder.h"
#include "wire/fixedpoint.h"
#include "wire/number.h"

#include <algorithm>
#include <iterator>

namespace mb::settings {
namespace {

using Stack = std::vector<const SettingsChange *>;

/// How others reach it on its bus: number, mask, bit rate. A unit takes these when it starts, and nothing else but limits.
bool isAddress(const Parameter &parameter)
{
    return parameter.afterRestart && !isLimit(parameter);
}

/// What it goes back to; nothing where nobody has to keep it.
std::optional<std::int64_t> goesBackTo(const Family &family, const ValueChange &value)
{
    const auto index = findParameter(family.parameters, value.key);
    if (!index || value.proof == Proof::Refused)
        return std::nullopt;
    const Parameter &parameter = family.parameters[index->value];
    const bool isUntold = !value.before && isLimit(parameter) && parameter.access == Access::WriteOnly;
    const auto before = isUntold ? tightestOf(parameter) : value.before;
    const bool isAsked = before && *before != value.after
        && (isAddress(parameter) || widensLimit(parameter, {*index, before, value.after}));
    return isAsked ? before : std::nullopt;
}

/// Moves the change that `by` is about, if it is where an undo or redo finds it.
void pass(Stack &from, Stack &to, const SettingsChange &by)
{
    const auto found = std::find_if(
        from.rbegin(), from.rend(), [&by](const SettingsChange *change) { return change->number == by.of; });
    if (found == from.rend())
        return;
    to.push_back(*found);
    from.erase(std::next(found).base());
}

bool didSomething(const SettingsChange &change)
{
    return std::ranges::any_of(change.values, [](const ValueChange &value) { return value.proof != Proof::Refused; });
}

std::optional<SettingsChange> topOf(const Stack &stack)
{
    return stack.empty() ? std::nullopt : std::optional(*stack.back());
}

void follow(const SettingsChange &change, std::map<std::string, std::int64_t> &values)
{
    for (const ValueChange &value : change.values) {
        if (value.proof == Proof::Open)
            values.erase(value.key);
        else if (value.proof != Proof::Refused)
            values[value.key] = value.after;
    }
}

/// What is no parameter, such as the number on the bus, is a bare one.
MessageArgument worded(const Family &family, std::string_view key, std::int64_t raw)
{
    const auto index = findParameter(family.parameters, key);
    return index ? settings::worded(family.parameters[index->value], raw) : MessageArgument(raw);
}

} // namespace

MessageArgument worded(const Parameter &parameter, std::int64_t raw)
{
    if (parameter.type == WireType::Boolean)
        return raw != 0 ? say("on") : say("off");
    const std::string text = shownText(parameter, raw);
    const std::size_t point = text.find('.');
    return MessageNumber{numberFrom(text).value_or(fromFixed(raw, parameter.one)),
        point == std::string::npos ? 0 : static_cast<int>(text.size() - point - 1)};
}

std::vector<ValueChange> undoable(const Family &family, const SettingsChange &change)
{
    std::vector<ValueChange> values;
    for (const ValueChange &value : change.values) {
        const auto index = findParameter(family.parameters, value.key);
        if (!index || value.proof == Proof::Refused || !value.before)
            continue;
        const Parameter &parameter = family.parameters[index->value];
        const bool never = family.trials && family.trials->never == value.key;
        const bool forgotten = change.origin == Origin::Elsewhere && !parameter.persistent;
        const bool same = value.proof != Proof::Open && *value.before == value.after;
        if (parameter.nature == Nature::Setting && isLegal(parameter, *value.before) && !never && !forgotten && !same)
            values.push_back(value);
    }
    return values;
}

HistoryView viewOf(const Family &family, std::span<const SettingsChange> changes)
{
    Stack undo;
    Stack redo;
    HistoryView view;
    for (const SettingsChange &change : changes) {
        follow(change, view.values);
        if (!didSomething(change))
            continue;
        if (change.purpose == Purpose::Undo) {
            pass(undo, redo, change);
        } else if (change.purpose == Purpose::Redo) {
            pass(redo, undo, change);
        } else if (!undoable(family, change).empty()) {
            undo.push_back(&change);
            redo.clear();
        }
    }
    view.undo = topOf(undo);
    view.redo = topOf(redo);
    return view;
}

bool mayHaveToConfirm(const Parameter &parameter)
{
    return isAddress(parameter) || isLimit(parameter);
}

std::vector<ValueChange> toConfirm(const Family &family, std::span<const ValueChange> values)
{
    std::vector<ValueChange> wanted;
    for (const ValueChange &value : values) {
        if (const auto before = goesBackTo(family, value))
            wanted.push_back({value.key, before, value.after, value.proof});
    }
    return wanted;
}

Message textOf(const Family &family, const SettingsChange &change)
{
    Message text;
    for (const ValueChange &value : change.values) {
        if (value.proof == Proof::Refused)
            continue;
        const MessageArgument after = worded(family, value.key, value.after);
        const Message one = value.before
            ? say("%1: %2 → %3", value.key, worded(family, value.key, *value.before), after)
            : say("%1: ? → %2", value.key, after);
        text = text.empty() ? one : say("%1, %2", text, one);
    }
    return text;
}

} // namespace mb::settings
