// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>

/// Names and numbers of the 01Mech protocol, shared by host and simulator.
namespace mb::supermodified {

/// Three firmware generations that differ in the width of values (README.md#dialects).
enum class Dialect : std::uint8_t {
    D1, ///< as in the datasheet: 16-bit velocities, 4096 ticks per turn
    D2, ///< 32-bit velocities
    D3, ///< "V3": 64-bit positions, 32768 ticks per turn
};

// Frame: README.md#frames

constexpr std::uint8_t header0 = 0x55;
constexpr std::uint8_t header1 = 0xAA;
constexpr int broadcastId = 0;
/// The host's own. Vendors' hosts have 1, which a mask that leaves out the upper bits puts into the group of every usual node.
constexpr int usualHostId = 0x77;
constexpr int vendorHostId = 1;
constexpr int lowestNode = 1;
constexpr int highestNode = 127;
constexpr int factoryNode = 4;
constexpr std::uint8_t exactMask = 0xFF; ///< local acceptance mask: only the own id

/// 55 AA, AndID, OndID, cID, bCnt before the data, the LRC behind it.
constexpr std::size_t headSize = 6;
constexpr std::size_t frameOverhead = 7;
/// The longest data of any message: error reactions of D3 (20); the D3 peer holds 22. D1 and D2 hold 16, and write past their
/// buffer when they get more (README.md#error-reactions).
constexpr std::size_t mostData = 22;
constexpr std::size_t mostDataD1D2 = 16;

enum class Command : std::uint8_t {
    // Set
    P = 0x00,
    I = 0x01,
    D = 0x02,
    ProfileAcceleration = 0x03,
    ProfileVelocity = 0x04,
    CurrentLimit = 0x05,
    CurrentLimitDuration = 0x06,
    MoveVelocity = 0x07,
    MoveAbsolute = 0x08,
    MoveRelative = 0x09, ///< D1, D2: relative to the present set-point
    MoveProfiledVelocity = 0x0A,
    MoveProfiledAbsolute = 0x0B,
    MoveProfiledRelative = 0x0C, ///< relative to the real position
    BufferVelocity = 0x0D,       ///< executed by DoMove, as the next five; one buffer, the last write wins
    BufferAbsolute = 0x0E,
    BufferRelative = 0x0F,
    BufferProfiledVelocity = 0x10,
    BufferProfiledAbsolute = 0x11,
    BufferProfiledRelative = 0x12,
    IoDirection = 0x13,
    Outputs = 0x14,
    NodeId = 0x15,
    NodeMask = 0x16,
    Baudrate = 0x17,
    ResetPosition = 0x18, ///< D1, D2: keeps the set-point, so that a running motor jumps (README.md#start)
    Start = 0x19,         ///< zeroes position and set-point, position mode, bridge on
    Halt = 0x1A,          ///< position mode where it is
    Stop = 0x1B,          ///< bridge off
    ErrorLevel = 0x1C,    ///< D1, D2: one byte; D3: error reaction, 20 bytes
    AntiWindup = 0x1D,    ///< D3
    ResetErrors = 0x1E,   ///< D3
    // Get
    GetP = 0x64,
    GetI = 0x65,
    GetD = 0x66,
    GetProfileAcceleration = 0x67,
    GetProfileVelocity = 0x68,
    GetCurrentLimit = 0x69,
    GetCurrentLimitDuration = 0x6A,
    GetIoDirection = 0x6B,
    GetNodeMask = 0x6C, ///< in force, not the one just written
    GetInputs = 0x6D,
    GetAnalog = 0x6E,
    GetPosition = 0x6F,
    GetAbsolutePosition = 0x70,
    GetVelocity = 0x71,
    GetCurrent = 0x72,
    GetWarnings = 0x73, ///< D3: error reaction
    GetAntiWindup = 0x74,
    // Broadcast; may also be sent to one node, which then answers
    DoMove = 0xC8,
    GlobalStart = 0xC9,
    GlobalHalt = 0xCA,
    GlobalStop = 0xCB,
    /// In place of a reply: 1…8 codes, and the command was not executed.
    Error = 0xFA,
};

constexpr bool isGet(std::uint8_t command)
{
    return command >= 0x64 && command < 0xC8;
}

// Errors: README.md#errors

namespace code {
constexpr std::uint8_t motorStalled = 0x01;
constexpr std::uint8_t encoderOverflow = 0x02;
constexpr std::uint8_t encoderUnderflow = 0x03;
constexpr std::uint8_t invalidCommand = 0x11;
constexpr std::uint8_t invalidSetCount = 0x12;
constexpr std::uint8_t invalidArgument = 0x13;
constexpr std::uint8_t invalidForState = 0x14;
constexpr std::uint8_t invalidGetCount
    = 0x15; ///< also raised by every successful get: a warning, noise (README.md#errors)
constexpr std::uint8_t uartFrame = 0x43;
constexpr std::uint8_t halfPacket = 0x51;
constexpr std::uint8_t wrongLrc = 0x52;
} // namespace code
constexpr std::size_t mostCodes = 8;

// Scales

constexpr double adcVolts = 5.0 / 1024.0; ///< analog inputs, 10 bits
constexpr int analogInputs = 4;

constexpr int ticksPerTurn(Dialect dialect)
{
    return dialect == Dialect::D3 ? 32768 : 4096;
}

/// Error reactions of D3 (1C, 73): one byte each, 0 nothing, 1 stop, 2 halt; two bits each in `error.reaction`.
constexpr std::size_t reactionCount = 20;
constexpr std::uint8_t mostReaction = 2;

// Times: README.md#time-outs

/// The rates to look for nodes with, in this order (README.md#scan).
constexpr std::array<int, 5> searchRates{57600, 115200, 9600, 19200, 38400};
/// Those that a node can be set to besides; a thorough search asks at them last.
constexpr std::array<int, 4> rareRates{4800, 2400, 1200, 600};
constexpr int slowestRate = 600;
constexpr int fastestRate = 115200;
constexpr std::chrono::milliseconds answerTime{25};       ///< after the wire time of request and reply
constexpr std::chrono::milliseconds storedAnswerTime{60}; ///< where an EEPROM is written first
constexpr std::chrono::microseconds eepromByteTime{3400}; ///< of a write; the reactions of D3 are 20 bytes
constexpr int patientTries = 4;                           ///< "at least 3" retries
/// What a real controller divides 20 MHz into (README.md#settings): 115200 is really 119048.
constexpr int realRate(int nominal)
{
    constexpr int clock = 20'000'000 / 8;
    const int divider = clock / nominal;
    return divider > 0 ? (clock + divider / 2) / divider : nominal;
}
constexpr double loopsPerSecond = 976.5625;
/// What D1 and D2 take their loop rate for: their speeds read too high and run too slow by the ratio (README.md#speeds).
constexpr double assumedLoopsPerSecond = 1089.3;

} // namespace mb::supermodified
