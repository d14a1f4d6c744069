// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/parameterrows.h"

#include "app/console/table.h"
#include "app/console/target.h"

namespace mb::console {

Result<ParameterIndex> parseKey(const Family &family, std::string_view key)
{
    if (const auto index = findParameter(family.parameters, key))
        return *index;
    std::vector<std::string_view> known;
    for (const Parameter &parameter : family.parameters)
        known.push_back(parameter.key);
    const std::string name(family.key);
    return fail(Fault::Usage, say("%1 has no parameter '%2'", name, key),
        suggestion(key, known, "'motorbenchctl parameters " + name + "' lists them"));
}

std::string shownValue(const Parameter &parameter, std::optional<std::int64_t> raw)
{
    if (!raw)
        return "unknown";
    const std::string text = toText(parameter, *raw);
    return parameter.unit.empty() ? text : text + ' ' + std::string(parameter.unit);
}

void printParameters(Console &console, const Device &device, const std::vector<ParameterIndex> &indices)
{
    Table table({"KEY", "VALUE", "UNIT", "STATE"});
    for (const ParameterIndex index : indices) {
        const Parameter &parameter = device.parameters().parameter(index);
        const ParameterStore::Entry &entry = device.parameters().entry(index);
        const bool known = entry.raw && entry.state != ParameterState::Failed;
        table.add({std::string(parameter.key), known ? toText(parameter, *entry.raw) : std::string(),
            std::string(parameter.unit), std::string(toString(entry.state))});
    }
    table.print(console.out());
}

std::optional<Error> firstError(const Device &device, const std::vector<TransferOutcome> &outcomes)
{
    for (const TransferOutcome &outcome : outcomes) {
        if (!outcome.raw)
            return errorOf(outcome, device.parameters().parameter(outcome.index).key);
    }
    return std::nullopt;
}

} // namespace mb::console
