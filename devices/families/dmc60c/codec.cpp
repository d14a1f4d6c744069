// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/codec.h"

#include "wire/bytes.h"
#include "wire/fixedpoint.h"

#include <array>

namespace mb::dmc60c {
namespace {

std::uint32_t withDevice(std::uint32_t base, int device)
{
    return base | (static_cast<std::uint32_t>(device) & id::deviceMask);
}

bool bit(std::uint8_t byte, int number)
{
    return ((byte >> number) & 1U) != 0U;
}

std::uint8_t flag(bool set, int number)
{
    return static_cast<std::uint8_t>(set ? 1U << number : 0U);
}

double fixed8x8(std::span<const std::uint8_t> bytes, std::size_t at)
{
    return fromFixed(signExtend(readU16le(bytes, at), 16), 256.0);
}

LimitSwitch limitSwitch(std::uint8_t flags, int first)
{
    return {bit(flags, first), bit(flags, first + 1), bit(flags, first + 2), bit(flags, first + 3)};
}

/// README.md#status-general: the low 16 bits in open-loop mode, all 24 elsewhere, nothing without drive.
std::int32_t generalError(ControlMode mode, std::span<const std::uint8_t> b, bool divided)
{
    if (mode == ControlMode::NoDrive)
        return 0;
    const std::uint32_t low = readU16le(b, 5);
    const std::int32_t value
        = mode == ControlMode::Voltage ? signExtend(low, 16) : signExtend(low | (std::uint32_t{b[7]} << 16U), 24);
    return divided ? value * 256 : value;
}

} // namespace

CanFrame encodeEnumerate()
{
    return extendedFrame(id::enumerate, std::span<const std::uint8_t>{});
}

CanFrame encodeVendorCommand(int device, std::uint16_t session, const VendorCommand &command)
{
    std::array<std::uint8_t, 8> data{};
    writeU16le(data, 0, session);
    writeU16le(data, 2, static_cast<std::uint16_t>(command.command));
    writeU16le(data, 4, command.param1);
    writeU16le(data, 6, command.param2);
    return extendedFrame(withDevice(id::vendorCommand, device), data);
}

CanFrame encodeVendorData(int device, std::span<const std::uint8_t> bytes)
{
    return extendedFrame(withDevice(id::vendorDout, device), bytes);
}

CanFrame encodeParamRequest(int device, std::uint16_t session, std::uint8_t parameter)
{
    std::array<std::uint8_t, 3> data{};
    writeU16le(data, 0, session);
    data[2] = parameter;
    return extendedFrame(withDevice(id::paramRequest, device), data);
}

CanFrame encodeParamSet(int device, std::uint16_t session, std::uint8_t parameter, std::uint32_t field)
{
    std::array<std::uint8_t, 7> data{};
    writeU16le(data, 0, session);
    data[2] = parameter;
    writeU32le(data, 3, field);
    return extendedFrame(withDevice(id::paramSet, device), data);
}

CanFrame encodeControl(int device, const Control &control)
{
    const auto target = static_cast<std::uint32_t>(control.target);
    std::array<std::uint8_t, 8> data{};
    data[0] = static_cast<std::uint8_t>(static_cast<unsigned>(control.mode) | flag(control.brake.has_value(), 4)
        | flag(control.brake.value_or(false), 5) | flag(control.slot == 1, 6) | flag(control.reverseSensor, 7));
    data[1] = static_cast<std::uint8_t>(flag(control.reverseMotor, 0) | flag(control.disableForwardLimit, 1)
        | flag(control.disableReverseLimit, 2) | flag(control.overrideLimits, 3));
    data[3] = static_cast<std::uint8_t>(
        (target >> 16U) & 0xFFU); // high byte first, then low, then middle: README.md#byte-orders
    writeU16le(data, 4, static_cast<std::uint16_t>(target & 0xFFFFU));
    writeU16le(data, 6, control.ramp);
    return extendedFrame(withDevice(id::control, device), data);
}

std::uint32_t fieldOf(WireType type, std::int64_t raw)
{
    return type == WireType::Boolean ? (raw != 0 ? 1U : 0U) : static_cast<std::uint32_t>(raw & 0xFFFFFFFF);
}

std::int64_t rawOf(WireType type, std::uint32_t field)
{
    switch (type) {
    case WireType::Int16:
    case WireType::Int32:
    case WireType::Fixed16x16: return signExtend(field, 32);
    case WireType::Boolean:
    case WireType::Uint8:
    case WireType::Uint16:
    case WireType::Uint31:
    case WireType::Uint32:
    case WireType::Flags32:
    case WireType::Flags64: return field;
    }
    return field;
}

bool isMessage(const CanFrame &frame, std::uint32_t base, std::size_t size)
{
    return frame.extended && !frame.remote && !frame.error && frame.size == size
        && (frame.id & id::messageMask) == base;
}

std::optional<EnumResponse0> decodeEnumResponse0(const CanFrame &frame)
{
    if (!isMessage(frame, id::enumResponse, 6))
        return std::nullopt;
    return EnumResponse0{deviceOf(frame), readU16le(frame.bytes(), 0), readU32le(frame.bytes(), 2)};
}

std::optional<EnumResponse1> decodeEnumResponse1(const CanFrame &frame)
{
    if (!isMessage(frame, id::enumResponse, 8))
        return std::nullopt;
    const auto b = frame.bytes();
    return EnumResponse1{deviceOf(frame), readU16le(b, 0), static_cast<ImageType>(readU16le(b, 2) & 3U),
        readU16le(b, 4), readU16le(b, 6)};
}

std::optional<VendorStatus> decodeVendorStatus(const CanFrame &frame)
{
    if (!isMessage(frame, id::vendorStatus, 4))
        return std::nullopt;
    const auto b = frame.bytes();
    return VendorStatus{deviceOf(frame), static_cast<CommandStatus>(b[0]), b[1], readU16le(b, 2)};
}

std::optional<std::span<const std::uint8_t>> decodeVendorData(const CanFrame &frame)
{
    if (frame.size == 0 || !isMessage(frame, id::vendorDin, frame.size))
        return std::nullopt;
    return frame.bytes();
}

std::optional<ParamResponse> decodeParamResponse(const CanFrame &frame)
{
    if (!isMessage(frame, id::paramResponse, 6))
        return std::nullopt;
    const auto b = frame.bytes();
    return ParamResponse{deviceOf(frame), b[0], readU32le(b, 1), static_cast<ParameterStatus>(b[5])};
}

std::optional<StatusGeneral> decodeStatusGeneral(const CanFrame &frame)
{
    if (!isMessage(frame, id::statusGeneral, 8))
        return std::nullopt;
    const auto b = frame.bytes();
    StatusGeneral s;
    s.device = deviceOf(frame);
    s.duty = static_cast<std::int16_t>(signExtend(readU16le(b, 0), 16));
    s.forward = limitSwitch(b[2], 0);
    s.reverse = limitSwitch(b[2], 4);
    s.limitOverride = bit(b[3], 0);
    s.forwardDisabledByFrame = bit(b[3], 1);
    s.reverseDisabledByFrame = bit(b[3], 2);
    s.softForwardHit = bit(b[3], 3);
    s.softForwardEnabled = bit(b[3], 4);
    s.softReverseHit = bit(b[3], 5);
    s.softReverseEnabled = bit(b[3], 6);
    s.currentLimitActive = bit(b[3], 7);
    s.overTemperature = bit(b[4], 0);
    s.underVoltage = bit(b[4], 1);
    s.gateDriver = bit(b[4], 2);
    s.mode = static_cast<ControlMode>((b[4] >> 3U) & 0xFU);
    s.errorDivided = bit(b[4], 7);
    s.error = generalError(s.mode, b, s.errorDivided);
    return s;
}

std::optional<StatusEncoder> decodeStatusEncoder(const CanFrame &frame)
{
    if (!isMessage(frame, id::statusEncoder, 8))
        return std::nullopt;
    const auto b = frame.bytes();
    StatusEncoder s;
    s.device = deviceOf(frame);
    s.positionDivided = bit(b[7], 0);
    s.velocityDivided = bit(b[7], 1);
    s.pinA = bit(b[7], 2);
    s.pinB = bit(b[7], 3);
    s.pinIndex = bit(b[7], 4);
    const std::uint32_t position = (std::uint32_t{b[0]} << 16U) | readU16be(b, 1);
    s.position = signExtend(position, 24) * (s.positionDivided ? 8 : 1);
    s.velocity = signExtend(readU16be(b, 3), 16) * (s.velocityDivided ? 4 : 1);
    return s;
}

std::optional<StatusAnalog> decodeStatusAnalog(const CanFrame &frame)
{
    if (!isMessage(frame, id::statusAnalog, 8))
        return std::nullopt;
    const auto b = frame.bytes();
    return StatusAnalog{deviceOf(frame), fixed8x8(b, 0), fixed8x8(b, 2), fixed8x8(b, 4), fixed8x8(b, 6)};
}

double errorOf(const StatusGeneral &status)
{
    const bool fixed = status.mode == ControlMode::Current || status.mode == ControlMode::VoltageCompensated;
    return fixed ? fromFixed(status.error, 65536.0) : status.error;
}

std::optional<FirmwareVersions> decodeFirmwareVersions(std::span<const std::uint8_t> bytes)
{
    if (bytes.size() != 6)
        return std::nullopt;
    return FirmwareVersions{static_cast<ImageType>(readU16le(bytes, 0) & 3U), readU16le(bytes, 2), readU16le(bytes, 4)};
}

std::optional<std::uint32_t> decodeFlashSequence(std::span<const std::uint8_t> bytes)
{
    if (bytes.size() != 4)
        return std::nullopt;
    return readU32le(bytes, 0);
}

std::optional<DescriptorList> decodeDescriptors(std::span<const std::uint8_t> bytes)
{
    DescriptorList list;
    while (!bytes.empty()) {
        if (bytes.size() < 2 || bytes.size() < 2U + bytes[1])
            return std::nullopt;
        std::string text;
        for (const std::uint8_t c : bytes.subspan(2, bytes[1])) {
            if (c >= 0x80U) {
                text += static_cast<char>(0xC0U | (c >> 6U));
                text += static_cast<char>(0x80U | (c & 0x3FU));
            } else if (c != 0) {
                text += static_cast<char>(c);
            }
        }
        list.emplace_back(bytes[0], std::move(text));
        bytes = bytes.subspan(2U + bytes[1]);
    }
    return list;
}

std::string versionText(std::uint16_t version)
{
    if (version == noApplication)
        return {};
    return std::to_string(version >> 8U) + '.' + std::to_string(version & 0xFFU);
}

std::optional<std::vector<std::uint8_t>> toLatin1(std::string_view text)
{
    std::vector<std::uint8_t> out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto c = static_cast<std::uint8_t>(text[i]);
        if (c == 0)
            return std::nullopt;
        if (c < 0x80U) {
            out.push_back(c);
            continue;
        }
        const auto next = i + 1 < text.size() ? static_cast<std::uint8_t>(text[i + 1]) : std::uint8_t{0};
        if ((c != 0xC2U && c != 0xC3U) || (next & 0xC0U) != 0x80U)
            return std::nullopt;
        out.push_back(static_cast<std::uint8_t>(((c & 3U) << 6U) | (next & 0x3FU)));
        ++i;
    }
    return out;
}

} // namespace mb::dmc60c
