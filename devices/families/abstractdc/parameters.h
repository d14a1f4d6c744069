// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/abstractdc/protocol.h"
#include "model/family.h"

#include <span>

namespace mb::abstractdc {

/// DeviceProfile::counters besides those of savings.
namespace counter {
constexpr std::string_view powerCycle
    = "averaging.power_cycle";                           ///< 1: owed, before it may be driven (README.md#averaging)
constexpr std::string_view place = "place.position";     ///< counts; where it was seen to stand last, 0: nobody knows
constexpr std::string_view passed = "place.passed";      ///< counts; where its velocity loop passed last
constexpr std::string_view passedAt = "place.passed_ms"; ///< when, on the time line of the clock
constexpr std::string_view unsaved = "unsaved."; ///< and the key of a setting. 1: written since its loop was saved
} // namespace counter

[[nodiscard]] std::span<const Parameter> parameterTable();

/// The number in the table: loop and field, which each dialect spells its own way.
[[nodiscard]] constexpr std::uint16_t parameterId(Loop loop, Field field)
{
    return static_cast<std::uint16_t>(static_cast<unsigned>(loop) * 16U + static_cast<unsigned>(field));
}
[[nodiscard]] constexpr Loop loopOf(const Parameter &parameter)
{
    return static_cast<Loop>(parameter.id / 16U);
}
[[nodiscard]] constexpr Field fieldOf(const Parameter &parameter)
{
    return static_cast<Field>(parameter.id % 16U);
}
[[nodiscard]] std::optional<ParameterIndex> parameterOf(Loop loop, Field field);

/// Family::arrange: within a loop no intermediate set of gains is stronger than both its neighbours (README.md#control-law: the divisor
/// before the gains, or after them where it makes them weaker; damping before P where P rises).
void arrange(const ParameterStore &known, std::vector<ParameterChange> &changes);

} // namespace mb::abstractdc
