// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/writeorder.h"

#include "model/family.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>

namespace mb {
namespace {

bool switchesOff(const Parameter &parameter, const StagedChange &change)
{
    return parameter.inverted ? change.to != 0 : change.to == 0;
}

bool isNoLimit(const Parameter &parameter, std::int64_t raw)
{
    return parameter.zeroIsNone && raw == 0;
}

bool isSwitch(const Parameter &parameter)
{
    return parameter.type == WireType::Boolean;
}

} // namespace

bool boundsPlace(const Parameter &parameter)
{
    return isLimit(parameter) && !isSwitch(parameter) && parameter.minimum < 0.0 && parameter.maximum > 0.0;
}

bool widensLimit(const Parameter &parameter, const StagedChange &change)
{
    if (!isLimit(parameter) || !change.from || *change.from == change.to)
        return false;
    if (isSwitch(parameter))
        return switchesOff(parameter, change);
    if (boundsPlace(parameter))
        return (change.to > *change.from) != parameter.inverted;
    if (isNoLimit(parameter, *change.from) || isNoLimit(parameter, change.to))
        return isNoLimit(parameter, change.to);
    return std::abs(change.to) > std::abs(*change.from);
}

std::int64_t tightestOf(const Parameter &limit)
{
    if (isSwitch(limit))
        return limit.inverted ? 0 : 1;
    const std::int64_t least = toRaw(limit, limit.minimum).value_or(0);
    return isNoLimit(limit, least) ? 1 : least;
}

int writeRank(const Parameter &parameter, const StagedChange &change)
{
    if (parameter.nature == Nature::Live)
        return 11;
    const bool raised = !change.from || std::abs(change.to) > std::abs(*change.from);
    switch (parameter.role) {
    case Role::Proportional: return raised ? 9 : 3;
    case Role::Integral: return raised ? 10 : 2;
    case Role::Derivative: return raised ? 4 : 8;
    default: break;
    }
    if (!isLimit(parameter))
        return 7;
    if (isSwitch(parameter))
        return switchesOff(parameter, change) ? 6 : 1;
    return widensLimit(parameter, change) || isNoLimit(parameter, change.to) ? 5 : 0;
}

void sortForWriting(std::span<const Parameter> table, std::vector<StagedChange> &changes)
{
    const auto place = [table](const StagedChange &change) {
        return std::tuple(writeRank(table[change.index.value], change), change.index.value);
    };
    std::ranges::sort(changes, [&place](const StagedChange &a, const StagedChange &b) { return place(a) < place(b); });
}

void arrangeForWriting(const Family &family, const ParameterStore &known, std::vector<ParameterChange> &changes)
{
    if (family.arrange)
        return family.arrange(known, changes);
    std::vector<StagedChange> staged;
    for (const ParameterChange &change : changes) {
        const ParameterStore::Entry &entry = known.entry(change.index);
        staged.push_back({change.index, entry.state == ParameterState::Failed ? std::nullopt : entry.raw, change.raw});
    }
    sortForWriting(known.table(), staged);
    std::transform(staged.begin(), staged.end(), changes.begin(), [](const StagedChange &change) {
        return ParameterChange{change.index, change.to};
    });
}

} // namespace mb
