// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/simulatorword.h"

#include "wire/bytes.h"

namespace mb::dmc60c::simulation {
namespace {

ControlMode modeOf(std::uint8_t code)
{
    return code <= static_cast<std::uint8_t>(ControlMode::Follower) ? static_cast<ControlMode>(code)
                                                                    : ControlMode::NoDrive;
}

} // namespace

ControlWord ControlWord::decode(std::span<const std::uint8_t> bytes)
{
    ControlWord word;
    word.mode = modeOf(bytes[0] & 0x0FU);
    word.overrideNeutral = (bytes[0] & 0x10U) != 0U;
    word.brake = (bytes[0] & 0x20U) != 0U;
    word.slot = (bytes[0] & 0x40U) != 0U ? 1 : 0;
    word.reverseSensor = (bytes[0] & 0x80U) != 0U;
    word.reverseMotor = (bytes[1] & 0x01U) != 0U;
    word.forwardLimitOff = (bytes[1] & 0x02U) != 0U;
    word.reverseLimitOff = (bytes[1] & 0x04U) != 0U;
    word.overrideLimits = (bytes[1] & 0x08U) != 0U;
    const std::uint32_t high = bytes[3];
    const std::uint32_t low = bytes[4];
    const std::uint32_t middle = bytes[5];
    if (word.mode == ControlMode::Follower)
        word.target = static_cast<std::int32_t>(low & id::deviceMask);
    else if (word.mode == ControlMode::Voltage)
        word.target = signExtend((middle << 8U) | low, 16);
    else if (word.mode != ControlMode::NoDrive)
        word.target = signExtend((high << 16U) | (middle << 8U) | low, 24);
    word.ramp = readU16le(bytes, 6);
    return word;
}

} // namespace mb::dmc60c::simulation
