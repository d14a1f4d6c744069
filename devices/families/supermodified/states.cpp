// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/states.h"

#include "families/supermodified/codec.h"

#include <QtGlobal>

#include <vector>

namespace mb::supermodified {
namespace {

constexpr std::array<StateRow, 4> stateRows{{
    {"input.1", QT_TRANSLATE_NOOP("table", "Digital input 1"), {}, StateKind::Input},
    {"input.2", QT_TRANSLATE_NOOP("table", "Digital input 2"), {}, StateKind::Input},
    {"input.3", QT_TRANSLATE_NOOP("table", "Digital input 3"), {}, StateKind::Input},
    {"input.4", QT_TRANSLATE_NOOP("table", "Digital input 4"), {}, StateKind::Input},
}};
static_assert(checkStates(stateRows));

} // namespace

std::span<const StateRow> stateTable()
{
    return stateRows;
}

std::span<const FaultRow> faultTable()
{
    static const std::vector<FaultRow> rows = [] {
        std::vector<FaultRow> made;
        for (const CodeName &name : codeNames())
            made.push_back({name.key, name.text});
        return made;
    }();
    return rows;
}

LiveStates statesOf(std::uint8_t inputs)
{
    LiveStates states;
    for (std::uint16_t i = 0; i < stateRows.size(); ++i)
        states.set({i}, (inputs >> i & 1U) != 0U);
    return states;
}

} // namespace mb::supermodified
