// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/dmc60c/protocol.h"

#include <array>
#include <cstdint>
#include <span>

namespace mb::dmc60c::simulation {

/// What the device does with a PARAMSET of a parameter.
enum class Rule : std::uint8_t {
    Signed,   ///< range is that of a signed 32-bit value
    Unsigned, ///< … of an unsigned one
    Counter,  ///< answers the old value; any value but 0 clears
    ReadOnly,
};

struct Row {
    std::uint8_t id = 0;
    Rule rule = Rule::Signed;
    bool persistent = true;
    std::int64_t low = 0;
    std::int64_t high = 0;
    std::uint32_t fallback = 0;
};

/// The 55 rows of README.md#parameters, in the order of their numbers.
[[nodiscard]] std::span<const Row> rows();
[[nodiscard]] const Row *findRow(std::uint8_t id);

/// Parameter values by wire number. Copied whole between RAM and flash.
class ParameterBank {
public:
    ParameterBank();
    [[nodiscard]] std::uint32_t raw(std::uint8_t id) const { return m_raw[id]; }
    [[nodiscard]] std::int32_t value(std::uint8_t id) const { return static_cast<std::int32_t>(m_raw[id]); }
    [[nodiscard]] bool flag(std::uint8_t id) const { return m_raw[id] != 0; }
    void set(std::uint8_t id, std::uint32_t raw) { m_raw[id] = raw; }
    /// Everything that flash does not keep is as after a start.
    void forgetVolatile();

private:
    std::array<std::uint32_t, 256> m_raw{};
};

/// Wire numbers the control loop needs and protocol.h does not name.
namespace number {
constexpr std::uint8_t forwardNormallyClosed = 1;
constexpr std::uint8_t forwardDisabled = 2;
constexpr std::uint8_t reverseNormallyClosed = 3;
constexpr std::uint8_t reverseDisabled = 4;
constexpr std::uint8_t softForwardThreshold = 5;
constexpr std::uint8_t softForwardEnable = 6;
constexpr std::uint8_t softReverseThreshold = 7;
constexpr std::uint8_t softReverseEnable = 8;
constexpr std::uint8_t adcMultiplier = 9;
constexpr std::uint8_t slot0 = 10; ///< P; then I, D, I-zone, F, allowable error, ramp, max and nominal duties
constexpr std::uint8_t slot1 = 21;
constexpr std::uint8_t limiter = 32; ///< P; then I, D, I-zone, F
constexpr std::uint8_t clearOnIndex = 42;
constexpr std::uint8_t clearOnForwardLimit = 43;
constexpr std::uint8_t clearOnReverseLimit = 44;
constexpr std::uint8_t indexEdge = 45;
constexpr std::uint8_t continuousLimit = 61;
constexpr std::uint8_t peakLimit = 62;
constexpr std::uint8_t peakDuration = 63;
constexpr std::uint8_t limiterEnable = 64;
} // namespace number

} // namespace mb::dmc60c::simulation
