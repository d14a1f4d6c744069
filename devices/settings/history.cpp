// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/history.h"

#include "model/family.h"

#include <algorithm>

namespace mb::settings {
namespace {

using Stack = std::vector<const SettingsChange *>;

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
    return std::any_of(change.values.begin(), change.values.end(),
        [](const ValueChange &value) { return value.proof != Proof::Refused; });
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

} // namespace

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

std::string textOf(const Family &family, const SettingsChange &change)
{
    std::string text;
    for (const ValueChange &value : change.values) {
        const auto index = findParameter(family.parameters, value.key);
        if (value.proof == Proof::Refused)
            continue;
        const auto written
            = [&](std::int64_t raw) { // what is no parameter, such as the number on the bus, is a bare number
                  return index ? toText(family.parameters[index->value], raw) : std::to_string(raw);
              };
        text += (text.empty() ? "" : ", ") + value.key + ": " + (value.before ? written(*value.before) : "?") + " -> "
            + written(value.after);
    }
    return text;
}

} // namespace mb::settings
