// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string_view>

/// Names and numbers of the Abstract DC Drive on CAN, shared by the codec and the simulator, and nothing else.
namespace mb::abstractdc {

/// Up to here every identifier has one meaning (README.md#offsets).
constexpr int maxOffset = 99;

enum class Loop : std::uint8_t { None, Velocity, Current, Position, Direct };
enum class Field : std::uint8_t { P, I, D, Divisor, Averaging };
enum class Log : std::uint8_t { Position, Velocity, Current, Temperature, Voltage };

constexpr std::size_t loopCount = 5;
constexpr std::size_t fieldCount = 5;
constexpr std::size_t logCount = 5;
constexpr int absent = -1;

namespace id { ///< the offset of the drive is added (README.md#offsets); 0 is every drive
constexpr std::uint32_t setPoint = 100;
constexpr std::uint32_t settings = 200;
constexpr std::uint32_t logRequest = 900;
constexpr std::uint32_t logRequestOld = 800; ///< dialect LL; there is no broadcast
constexpr std::uint32_t velocityLog = 1024;
constexpr std::uint32_t positionLog = 1152;
constexpr std::uint32_t currentLog = 1280;
constexpr std::uint32_t temperatureLog = 1536;
constexpr std::uint32_t voltageLog = 1664; ///< the firmware adds no offset to this one, the document does
constexpr std::uint32_t velocityLogLegacy = 1000;
constexpr std::uint32_t positionLogLegacy = 1100;
constexpr std::uint32_t currentLogLegacy = 1200;
} // namespace id

/// One row of the table of dialects (README.md#dialects). Codes stand in the order of the enumerations above.
struct Dialect {
    std::string_view key;
    std::array<int, loopCount> type;   ///< TYPE; `absent`: cannot be said
    std::array<int, fieldCount> field; ///< FIELD
    std::array<int, logCount> log;     ///< LOG; `absent`: there is none
    std::array<int, logCount> reply;   ///< base of the identifier of the answer
    std::uint32_t request = id::logRequest;
    bool wide = false;          ///< settings and set-points of 8 bytes: code nibbles, three bytes of nothing, value
    bool voltageOffset = false; ///< the offset is added to the identifier of the voltage log

    [[nodiscard]] constexpr int codeOf(Loop loop) const { return type.at(static_cast<std::size_t>(loop)); }
    [[nodiscard]] constexpr int codeOf(Field name) const { return field.at(static_cast<std::size_t>(name)); }
    [[nodiscard]] constexpr int codeOf(Log name) const { return log.at(static_cast<std::size_t>(name)); }
    [[nodiscard]] constexpr bool has(Log name) const { return codeOf(name) != absent; }
    /// Whether the drive can be told to do nothing. One that cannot is never driven.
    [[nodiscard]] constexpr bool canStop() const { return codeOf(Loop::None) != absent; }
};

constexpr std::array<int, logCount> repliesNew{static_cast<int>(id::positionLog), static_cast<int>(id::velocityLog),
    static_cast<int>(id::currentLog), static_cast<int>(id::temperatureLog), static_cast<int>(id::voltageLog)};
constexpr std::array<int, logCount> repliesLegacy{static_cast<int>(id::positionLogLegacy),
    static_cast<int>(id::velocityLogLegacy), static_cast<int>(id::currentLogLegacy), absent, absent};

/// What the firmware of today speaks.
inline constexpr Dialect dialectF{"F", {0, 1, 2, 3, 4}, {0, 1, 2, 3, 4}, {0, 1, 2, 3, 4}, repliesNew};
/// The published master, and the firmware before the frames became shorter.
inline constexpr Dialect dialectL{
    "L", {0, 1, 2, 3, 4}, {0, 1, 2, 3, 4}, {0, 1, 2, absent, absent}, repliesLegacy, id::logRequest, true};
/// Older still: nothing stops such a drive but its power.
inline constexpr Dialect dialectLL{
    "LL", {absent, 0, 1, 2, 3}, {0, 1, 2, 3, 4}, {0, 1, 2, absent, absent}, repliesLegacy, id::logRequestOld, true};
/// The codes of the document, which no known firmware has.
inline constexpr Dialect dialectD{
    "D", {0, 1, 3, 4, 5}, {0, 1, 3, 4, 5}, {4, 1, 3, absent, 5}, repliesNew, id::logRequest, false, true};

inline constexpr std::array<const Dialect *, 4> dialects{&dialectF, &dialectL, &dialectLL, &dialectD};

/// nullptr when there is no such dialect.
[[nodiscard]] constexpr const Dialect *dialectByKey(std::string_view key)
{
    for (const Dialect *dialect : dialects) {
        if (dialect->key == key)
            return dialect;
    }
    return nullptr;
}

constexpr int fullPwm = 255;          ///< of a direct set-point, either sign
constexpr int adcMost = 1023;         ///< of the current and temperature logs
constexpr int averagingMost = 500;    ///< the device does not check it (README.md#averaging)
constexpr int outputWraps = 32768;    ///< an output is cast to 16 bits before it is clamped (README.md#wraps)
constexpr int wrapLoss = 65535;       ///< README.md#position: what a wrap of the 16-bit timer is counted as
constexpr int savesUntilWarning = 40; ///< README.md#saves
constexpr int savesPerPage = 50;      ///< the 51st record makes the next start load something else
constexpr auto loopPeriod = std::chrono::microseconds(20040);
constexpr auto answerSlack = std::chrono::milliseconds(20); ///< of an answer, besides twice the frames

/// The settings in flash (README.md#saves), 1 KiB each for velocity, current, position.
constexpr std::uint32_t settingsAddress = 0x0800C800;
constexpr std::uint32_t settingsSize = 0xC00;

} // namespace mb::abstractdc
