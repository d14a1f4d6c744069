// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/supermodified/protocol.h"
#include "model/parameter.h"

#include <optional>
#include <span>

namespace mb::supermodified {

/// The table of README.md#settings, for all dialects; keys are those that users type.
[[nodiscard]] std::span<const Parameter> parameterTable();

/// What sets and what reads a row; nothing where the node has no such command.
[[nodiscard]] Command setterOf(const Parameter &parameter);
[[nodiscard]] std::optional<Command> getterOf(const Parameter &parameter);
/// Whether a dialect has this row; without a dialect, only what helps to find it out.
[[nodiscard]] bool isOffered(const Parameter &parameter, std::optional<Dialect> dialect);

namespace id {
constexpr std::uint16_t gainP = 0x00;
constexpr std::uint16_t profileAcceleration = 0x03;
constexpr std::uint16_t profileVelocity = 0x04;
constexpr std::uint16_t currentLimit = 0x05;
constexpr std::uint16_t currentLimitDuration = 0x06;
constexpr std::uint16_t nodeId = 0x15;
constexpr std::uint16_t nodeMask = 0x16;
constexpr std::uint16_t baudrate = 0x17;
constexpr std::uint16_t errorLevel = 0x1C;
constexpr std::uint16_t antiWindup = 0x1D;
constexpr std::uint16_t errorReaction = 0x73; ///< its get: D3 sets it with the id of the error level
} // namespace id
[[nodiscard]] std::optional<ParameterIndex> parameterWithId(std::uint16_t wireNumber);

} // namespace mb::supermodified
