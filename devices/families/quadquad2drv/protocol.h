// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>

/// Names and numbers of the QuadQuad2Drv's SPI packets.
/// The only header that host and simulator share.
namespace mb::quadquad2drv {

/// README.md#checksum
constexpr std::uint8_t stx = 0x02;
constexpr std::size_t overhead = 4; ///< STX, size, id, checksum

constexpr int axes = 4;

/// A request and its reply have the same number.
enum class PacketId : std::uint8_t {
    GetVersion = 1,
    GetMotion = 2,
    Stream = 3, ///< from the board only, without return code
    SetStreamPeriod = 4,
    GetStreamPeriod = 5,
    SetDataMask = 6,
    GetDataMask = 7,
    SetStreamConfig = 8,
    GetStreamConfig = 9,
    SetPosition = 10,
    GetPosition = 11,
    SetHistory = 12,
    GetHistory = 13,
    SetInputMode = 14,
    SetControlMode = 16,
    SetPower = 18,
    SetPositionTarget = 20,
    SetVelocityTarget = 22,
    SetPowerLimit = 24,
    SetVelocityLimit = 26,
    SetAccelerationLimit = 28,
    SetPositionGains = 30,
    SetVelocityGains = 32,
    RampPosition = 34,
    RampVelocity = 36,
};

/// Of packet 16.
enum class ControlMode : std::uint8_t { Off = 0, Power = 1, Position = 2, Velocity = 3 };

/// What of an axis is in its motion data.
namespace datamask {
constexpr std::uint8_t positionSize = 0x03; ///< 0 none, 1 I8, 2 I16, 3 I32
constexpr std::uint8_t relative = 0x04;
constexpr std::uint8_t velocity = 0x08;
constexpr std::uint8_t status = 0x20;
constexpr std::uint8_t startUp = 0x0B;
constexpr std::uint8_t everything = 0x2B; ///< I32 position, velocity, status
} // namespace datamask

/// What a stream packet begins with: packet 8.
namespace streamconfig {
constexpr std::uint8_t timing = 0x01;
constexpr std::uint8_t elapsed = 0x02;
} // namespace streamconfig

/// The status byte of an axis.
namespace status {
constexpr std::uint8_t positiveEdge = 0x01;
constexpr std::uint8_t negativeEdge = 0x02;
constexpr std::uint8_t inputWasActive = 0x04;
constexpr std::uint8_t inputActive = 0x08;
constexpr std::uint8_t overspeed = 0x40;
constexpr std::uint8_t glitch = 0x80;
} // namespace status

/// What the input of an axis is for: packet 14.
enum class InputMode : std::uint8_t { Disabled = 0, Home = 1, Index = 2, Edge = 3 };

/// Scales: README.md#times-4096.
constexpr std::int32_t fullPower = 8191;
constexpr std::int32_t fastest = 100'000;    ///< transitions/s
constexpr std::int32_t steepest = 1'000'000; ///< transitions/s²
constexpr double limitOne = 4096.0;          ///< raw value of 1.0 of limits and ramps, "shl 12"
constexpr double resolution = 4.0;           ///< of the velocity, transitions/s
constexpr double loopTime = 0.002;           ///< s, one pass of the control loop
constexpr std::uint16_t fastestStream = 49;  ///< 2.007 ms, the loop runs at 500 Hz
constexpr std::chrono::nanoseconds streamUnit{40'960};

constexpr std::chrono::milliseconds answerTime{100};
constexpr std::chrono::milliseconds resetTime{100};

/// The first byte of every reply; a stream packet has none (README.md#stream).
enum class ReturnCode : std::int8_t {
    Ok = 0,
    Overflow = -1,
    InvalidCommand = -10,
    InvalidParameter = -11,
    InvalidData = -12,
    Unspecified = -127
};

/// What an unknown board most likely does where the reference has two readings: settings of a device, the safe one first.
struct Readings {
    bool velocityTargetShifted = false; ///< the target of packet 22 times 4096 (README.md#times-4096)
    bool libraryPolarity = true;        ///< polarity and edge as the vendor's library has them (README.md#inputs)
};

} // namespace mb::quadquad2drv
