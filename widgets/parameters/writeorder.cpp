// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/writeorder.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>

namespace mb {
namespace {

bool isLimit(std::string_view key)
{
    return key.find("limit") != std::string_view::npos || key.find("max_") != std::string_view::npos;
}

/// p, i or d; 0 for everything else.
char gainOf(std::string_view key)
{
    const auto dot = key.rfind('.');
    const std::string_view last = dot == std::string_view::npos ? key : key.substr(dot + 1);
    return last == "p" || last == "i" || last == "d" ? last.front() : '\0';
}

} // namespace

int writeRank(const Parameter &parameter, const StagedChange &change)
{
    if (parameter.nature == Nature::Live)
        return 9;
    const bool raised = !change.from || std::abs(change.to) > std::abs(*change.from);
    switch (gainOf(parameter.key)) {
    case 'p': return raised ? 7 : 3;
    case 'i': return raised ? 8 : 2;
    case 'd': return raised ? 4 : 6;
    default: break;
    }
    if (isLimit(parameter.key))
        return parameter.type == WireType::Boolean ? 1 : 0;
    return 5;
}

void sortForWriting(std::span<const Parameter> table, std::vector<StagedChange> &changes)
{
    const auto place = [table](const StagedChange &change) {
        return std::tuple(writeRank(table[change.index.value], change), change.index.value);
    };
    std::sort(changes.begin(), changes.end(),
        [&place](const StagedChange &a, const StagedChange &b) { return place(a) < place(b); });
}

} // namespace mb
