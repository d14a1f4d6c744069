// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/simulatorstatus.h"

#include "families/dmc60c/protocol.h"
#include "wire/bytes.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace mb::dmc60c::simulation {
namespace {

using Payload = std::array<std::uint8_t, 8>;

/// First argument is bit 0.
std::uint8_t bits(std::initializer_list<bool> flags)
{
    std::uint8_t byte = 0;
    int at = 0;
    for (const bool flag : flags)
        byte = static_cast<std::uint8_t>(byte | (static_cast<unsigned>(flag) << at++));
    return byte;
}

std::uint8_t octet(std::int64_t value, int shift)
{
    return static_cast<std::uint8_t>((static_cast<std::uint64_t>(value) >> shift) & 0xFFU);
}

bool fits(std::int64_t value, int width)
{
    const std::int64_t half = std::int64_t{1} << (width - 1);
    return value >= -half && value < half;
}

void writeFixed8x8(Payload &data, std::size_t at, double value)
{
    const double raw = std::clamp(std::round(value * 256.0), -32768.0, 32767.0);
    writeU16le(data, at, static_cast<std::uint16_t>(static_cast<std::int32_t>(raw) & 0xFFFF));
}

CanFrame frame(std::uint32_t message, int device, const Payload &data)
{
    return extendedFrame(message | static_cast<std::uint32_t>(device), data);
}

} // namespace

CanFrame generalFrame(int device, const GeneralState &state)
{
    const LimitPin &fwd = state.forward;
    const LimitPin &rev = state.reverse;
    const int width = state.mode == static_cast<int>(ControlMode::Voltage) ? 16 : 24;
    const bool divided = !fits(state.error, width);
    const std::int64_t half = std::int64_t{1} << (width - 1);
    const std::int64_t error = std::clamp(divided ? state.error >> 8 : state.error, -half, half - 1);
    Payload data{};
    writeU16le(data, 0, static_cast<std::uint16_t>(state.duty & 0xFFFF));
    data[2] = bits(
        {fwd.level, fwd.hit, fwd.disabled, fwd.normallyClosed, rev.level, rev.hit, rev.disabled, rev.normallyClosed});
    data[3] = bits({state.limitOverride, fwd.disabledByFrame, rev.disabledByFrame, fwd.softHit, fwd.softEnabled,
        rev.softHit, rev.softEnabled, state.currentLimitActive});
    data[4] = bits({state.overTemperature, state.underVoltage, state.gateDriver, false, false, false, false, divided});
    data[4] = static_cast<std::uint8_t>(data[4] | (state.mode << 3));
    data[5] = octet(error, 0);
    data[6] = octet(error, 8);
    data[7] = width == 24 ? octet(error, 16) : std::uint8_t{0};
    return frame(id::statusGeneral, device, data);
}

CanFrame encoderFrame(int device, const EncoderState &state)
{
    const bool farAway = !fits(state.position, 24);
    const bool fast = !fits(state.velocity, 16);
    const std::int32_t position = farAway ? state.position >> 3 : state.position;
    const std::int32_t velocity = fast ? std::clamp(state.velocity >> 2, -32768, 32767) : state.velocity;
    Payload data{};
    data[0] = octet(position, 16);
    data[1] = octet(position, 8);
    data[2] = octet(position, 0);
    writeU16be(data, 3, static_cast<std::uint16_t>(velocity & 0xFFFF));
    data[7] = bits({farAway, fast, state.pinA, state.pinB, state.pinIndex});
    return frame(id::statusEncoder, device, data);
}

CanFrame analogFrame(int device, const AnalogState &state)
{
    Payload data{};
    writeFixed8x8(data, 0, state.input);
    writeFixed8x8(data, 2, state.current);
    writeFixed8x8(data, 4, state.temperature);
    writeFixed8x8(data, 6, state.bus);
    return frame(id::statusAnalog, device, data);
}

} // namespace mb::dmc60c::simulation
