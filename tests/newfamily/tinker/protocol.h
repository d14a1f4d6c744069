// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

#include <cstdint>

/// The wire of the Tinker One: all that host and simulator share. README.md has the table.
namespace mb::tinker {

constexpr std::uint32_t baseId = 0x0F5E0000;
constexpr int highestAddress = 15;

enum class Message : std::uint8_t {
    Who = 0x01,
    Drive = 0x02,
    Read = 0x03,
    Write = 0x04,
    Store = 0x05,
    Load = 0x10,
    Piece = 0x11,
    Run = 0x12,
    Here = 0x81,
    Value = 0x83,
    Status = 0x90,
    Loaded = 0x91,
};

enum class Drive : std::uint8_t { Off, Duty, Position };

constexpr double fullDuty = 10000.0;
constexpr std::uint8_t stalledFlag = 0x01;
constexpr std::uint8_t endSwitchFlag = 0x02;
constexpr std::uint16_t wholeProgram = 0xFFFF; ///< in Loaded, of Load and Run
constexpr int pieceSize = 4;
constexpr int programSize = 4096; ///< bytes; the first two are the version

constexpr Duration statusPeriod = std::chrono::milliseconds(10);
constexpr std::chrono::milliseconds driveLimit{100};

} // namespace mb::tinker
