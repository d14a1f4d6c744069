// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/parameter.h"

#include <span>

namespace mb::quadquad2drv {

[[nodiscard]] std::span<const Parameter> parameterTable();

/// What an axis (0…3) has in the table, in this order.
enum class AxisParameter : std::uint16_t {
    PositionP,
    PositionI,
    PositionD,
    PositionWindup,
    VelocityP,
    VelocityI,
    VelocityD,
    LimitPower,
    LimitVelocity,
    LimitAcceleration,
    InputMode,
    InputPolarity,
    InputEdge,
    InputSpacing,
    InputPosition,
    DataMask,
    Counter,
};
constexpr std::uint16_t parametersPerAxis = 17;

/// What the board has once, after the axes.
enum class BoardParameter : std::uint16_t { StreamPeriod, StreamConfig, HistoryLength, HistoryTimeBits };

[[nodiscard]] constexpr ParameterIndex indexOf(int axis, AxisParameter which)
{
    return {static_cast<std::uint16_t>(axis * parametersPerAxis + static_cast<int>(which))};
}
[[nodiscard]] constexpr ParameterIndex indexOf(BoardParameter which)
{
    return {static_cast<std::uint16_t>(4 * parametersPerAxis + static_cast<int>(which))};
}

} // namespace mb::quadquad2drv
