// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/parameters.h"

#include <QtGlobal>

#include <algorithm>
#include <array>

namespace mb::supermodified {
namespace {

constexpr double uint16High = 65535.0;
constexpr double uint32High = 4294967295.0;
constexpr double reactionsHigh = 1099511627775.0; // 20 of two bits

constexpr std::string_view loop = QT_TRANSLATE_NOOP("table", "Loop");
constexpr std::string_view profileGroup = QT_TRANSLATE_NOOP("table", "Profile");
constexpr std::string_view limit = QT_TRANSLATE_NOOP("table", "Current limit");
constexpr std::string_view io = QT_TRANSLATE_NOOP("table", "Digital lines");
constexpr std::string_view bus = QT_TRANSLATE_NOOP("table", "Bus");
constexpr std::string_view errors = QT_TRANSLATE_NOOP("table", "Errors");

/// Stored in EEPROM with the write.
constexpr Parameter setting(std::string_view key, std::uint16_t id, WireType type, std::string_view unit, double low,
    double high, double fallback, std::string_view group, std::string_view label, std::string_view help)
{
    return {key, id, type, 1.0, unit, low, high, fallback, Access::ReadWrite, true, Nature::Setting, group, label, help,
        {}};
}
constexpr Parameter later(Parameter row)
{
    row.afterRestart = true;
    return row;
}
constexpr Parameter ofUnit(Parameter row)
{
    row.belongsToUnit = true;
    return row;
}
constexpr Parameter writeOnly(Parameter row, bool persistent)
{
    row.access = Access::WriteOnly;
    row.persistent = persistent;
    return row;
}

// One row per line, whatever its length.
// clang-format off
constexpr std::array<Parameter, 15> table{{
    as(Role::Proportional, setting("gain.p", id::gainP, WireType::Uint16, "duty/count", 0.0, uint16High, 4000.0, loop, "P", QT_TRANSLATE_NOOP("table", "D1, D2: 1/65280 of full output per count of error; 4000 is full output at 16 counts. The scale of D3 is not documented."))),
    as(Role::Integral, setting("gain.i", 0x01, WireType::Uint16, "duty/count/loop", 0.0, uint16High, 100.0, loop, "I", QT_TRANSLATE_NOOP("table", "D1, D2: 1/16711680 of full output per count of error and loop of 1.024 ms. The bound of the integral follows P at the next restart only."))),
    as(Role::Derivative, setting("gain.d", 0x02, WireType::Uint16, "duty·loop/count", 0.0, uint16High, 1000.0, loop, "D", QT_TRANSLATE_NOOP("table", "D1, D2: 1/65280 of full output per count that the error changes in one loop of 1.024 ms."))),
    setting("profile.acceleration", id::profileAcceleration, WireType::Uint32, "counts/s²", 1.0, uint32High, 800.0, profileGroup, QT_TRANSLATE_NOOP("table", "Acceleration"), QT_TRANSLATE_NOOP("table", "Of profiled moves. D1: at most 65535.")),
    setting("profile.velocity", id::profileVelocity, WireType::Uint32, "counts/s", 1.0, uint32High, 800.0, profileGroup, QT_TRANSLATE_NOOP("table", "Velocity"), QT_TRANSLATE_NOOP("table", "Of profiled moves. D1: at most 65535. D1 and D2 may pass their target above 2500, and compute wrongly from 46340 on.")),
    as(Role::Limit, setting("limit.current", id::currentLimit, WireType::Uint16, "mA", 1.0, uint16High, 5000.0, limit, QT_TRANSLATE_NOOP("table", "Current limit"), QT_TRANSLATE_NOOP("table", "Firmware of D1 and D2 stores it and does not limit anything."))),
    as(Role::Limit, later(setting("limit.current.duration", id::currentLimitDuration, WireType::Uint16, "ms", 0.0, uint16High, 5000.0, limit, QT_TRANSLATE_NOOP("table", "Time above the limit"), QT_TRANSLATE_NOOP("table", "In force after a restart. D1 and D2 take it for the current limit until then; the limit is therefore written again behind it.")))),
    setting("io.direction", 0x13, WireType::Uint8, "", 0.0, 15.0, 0.0, io, QT_TRANSLATE_NOOP("table", "Outputs among the lines"), QT_TRANSLATE_NOOP("table", "1, 2, 4, 8 for DIO1 to DIO4; a set bit makes an output. DIO1 and DIO3 low for 3 s start the analog programming of the device, DIO2 and DIO4 low restore its factory settings.")),
    writeOnly(setting("io.outputs", 0x14, WireType::Uint8, "", 0.0, 15.0, 0.0, io, QT_TRANSLATE_NOOP("table", "Levels of the outputs"), QT_TRANSLATE_NOOP("table", "Bits as for the directions; inputs ignore theirs. Cannot be read back and is lost at power-off.")), false),
    ofUnit(later(setting("node.id", id::nodeId, WireType::Uint8, "", lowestNode, highestNode, factoryNode, bus, QT_TRANSLATE_NOOP("table", "Node id"), QT_TRANSLATE_NOOP("table", "Its address on the line. In force after a restart; until then it answers under the old one.")))),
    later(setting("node.mask", id::nodeMask, WireType::Uint8, "", 1.0, 255.0, 255.0, bus, QT_TRANSLATE_NOOP("table", "Acceptance mask"), QT_TRANSLATE_NOOP("table", "Bits of an address that count. 255: only its own; less makes a group that acts on what is sent to any of its members, and on their answers. In force after a restart."))),
    later(setting("uart.baud", id::baudrate, WireType::Uint32, "bit/s", slowestRate, fastestRate, 115200.0, bus, QT_TRANSLATE_NOOP("table", "Bit rate"), QT_TRANSLATE_NOOP("table", "In force after a restart. Reads as the rate at which it answers. 115200 is really 119048: prefer 57600."))),
    writeOnly(setting("error.level", id::errorLevel, WireType::Uint8, "", 0.0, 0.0, 0.0, errors, QT_TRANSLATE_NOOP("table", "Error level"), QT_TRANSLATE_NOOP("table", "D1 and D2. Level 1 would make every reading fail, so only 0 is offered: write it where another program set 1.")), true),
    setting("error.reaction", id::errorReaction, WireType::Flags64, "", 0.0, reactionsHigh, 0.0, errors, QT_TRANSLATE_NOOP("table", "Reactions to errors"), QT_TRANSLATE_NOOP("table", "D3. Two bits for each of 20 errors, the first lowest: 0 nothing, 1 stop, 2 halt. Which error is which is not documented.")),
    setting("anti_windup", id::antiWindup, WireType::Uint32, "", 0.0, uint32High, 0.0, loop, QT_TRANSLATE_NOOP("table", "Anti-windup"), QT_TRANSLATE_NOOP("table", "D3. Bound of the integral; its scale is not documented.")),
}};
// clang-format on

static_assert(checkParameters(table));

} // namespace

std::span<const Parameter> parameterTable()
{
    return table;
}

std::optional<ParameterIndex> parameterWithId(std::uint16_t wireNumber)
{
    const auto *const row = std::ranges::find(table, wireNumber, &Parameter::id);
    if (row == table.end())
        return std::nullopt;
    return ParameterIndex{static_cast<std::uint16_t>(row - table.begin())};
}

Command setterOf(const Parameter &parameter)
{
    return parameter.id == id::errorReaction ? Command::ErrorLevel : static_cast<Command>(parameter.id);
}

std::optional<Command> getterOf(const Parameter &parameter)
{
    switch (static_cast<Command>(parameter.id)) {
    case Command::P: return Command::GetP;
    case Command::I: return Command::GetI;
    case Command::D: return Command::GetD;
    case Command::ProfileAcceleration: return Command::GetProfileAcceleration;
    case Command::ProfileVelocity: return Command::GetProfileVelocity;
    case Command::CurrentLimit: return Command::GetCurrentLimit;
    case Command::CurrentLimitDuration: return Command::GetCurrentLimitDuration;
    case Command::IoDirection: return Command::GetIoDirection;
    case Command::NodeMask: return Command::GetNodeMask;
    case Command::GetWarnings: return Command::GetWarnings;
    case Command::AntiWindup: return Command::GetAntiWindup;
    default: return std::nullopt;
    }
}

bool isOffered(const Parameter &parameter, std::optional<Dialect> dialect)
{
    if (parameter.id == id::errorLevel)
        return dialect != Dialect::D3;
    if (!dialect)
        return parameter.id == id::nodeId || parameter.id == id::baudrate;
    const bool onlyThird = parameter.id == id::errorReaction || parameter.id == id::antiWindup;
    return !onlyThird || dialect == Dialect::D3;
}

} // namespace mb::supermodified
