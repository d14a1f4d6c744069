// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/states.h"

#include "families/quadquad2drv/protocol.h"

#include <QtGlobal>

namespace mb::quadquad2drv {
namespace {

constexpr std::string_view input = QT_TRANSLATE_NOOP("table", "Input");

constexpr std::array<StateRow, axes> stateRows{{
    {"ch1.input", input, {}, StateKind::Input},
    {"ch2.input", input, {}, StateKind::Input},
    {"ch3.input", input, {}, StateKind::Input},
    {"ch4.input", input, {}, StateKind::Input},
}};
static_assert(checkStates(stateRows));

} // namespace

std::span<const StateRow> stateTable()
{
    return stateRows;
}

void takeStates(LiveStates &states, int axis, std::uint8_t status)
{
    states.set({static_cast<std::uint16_t>(axis)}, (status & (status::inputActive | status::inputWasActive)) != 0);
}

} // namespace mb::quadquad2drv
