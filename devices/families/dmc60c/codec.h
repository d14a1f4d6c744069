// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/dmc60c/protocol.h"
#include "model/parameter.h"
#include "wire/canframe.h"

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// The host's half of the protocol: requests are encoded, replies decoded. Pure functions without state. A decoder
/// yields nothing for a frame that is not exactly that message (29-bit identifier, no remote frame, its one legal
/// length).
namespace mb::dmc60c {

// Requests, host to device

struct VendorCommand {
    Command command = Command::GetFwver;
    std::uint16_t param1 = 0;
    std::uint16_t param2 = 0;
};

/// CANCTRL0 (README.md#byte-orders). `target` is raw: duty units, counts per 100 ms, counts, 8.16 A or V, or a device number.
struct Control {
    ControlMode mode = ControlMode::NoDrive;
    std::int32_t target = 0; ///< 24 bits with sign
    std::uint16_t ramp = 0;  ///< duty units per 500 µs, 0 = immediate; open-loop modes only
    int slot = 0;
    std::optional<bool> brake;
    bool reverseMotor = false;
    bool reverseSensor = false;
    bool overrideLimits = false;
    bool disableForwardLimit = false; ///< means something only with overrideLimits, as the next
    bool disableReverseLimit = false;
};

[[nodiscard]] CanFrame encodeEnumerate();
[[nodiscard]] CanFrame encodeVendorCommand(int device, std::uint16_t session, const VendorCommand &command);
/// One frame of bulk data, 1…8 bytes.
[[nodiscard]] CanFrame encodeVendorData(int device, std::span<const std::uint8_t> bytes);
[[nodiscard]] CanFrame encodeParamRequest(int device, std::uint16_t session, std::uint8_t parameter);
[[nodiscard]] CanFrame encodeParamSet(int device, std::uint16_t session, std::uint8_t parameter, std::uint32_t field);
[[nodiscard]] CanFrame encodeControl(int device, const Control &control);

/// The 32-bit value field of PARAMSET and PARAMRESP, one rule per wire type (README.md#parameters): signed types are sign-extended.
[[nodiscard]] std::uint32_t fieldOf(WireType type, std::int64_t raw);
[[nodiscard]] std::int64_t rawOf(WireType type, std::uint32_t field);

// Replies, device to host

struct EnumResponse0 {
    int device = 0;
    std::uint16_t session = 0;
    std::uint32_t productId = 0;
};

struct EnumResponse1 {
    int device = 0;
    std::uint16_t session = 0;
    ImageType image = ImageType::Application;
    std::uint16_t application = 0; ///< noApplication without a valid one
    std::uint16_t bootloader = 0;
};

struct VendorStatus {
    int device = 0;
    CommandStatus status = CommandStatus::NoError;
    std::uint8_t test = 0;   ///< terc, of the two J1 tests only
    std::uint16_t count = 0; ///< bytes that follow in VENDORDIN frames
};

struct ParamResponse {
    int device = 0;
    std::uint8_t parameter = 0;
    std::uint32_t field = 0;
    ParameterStatus status = ParameterStatus::NoError;
};

struct LimitSwitch {
    bool pin = false; ///< level high
    bool hit = false;
    bool disabled = false;
    bool normallyClosed = false;
};

struct StatusGeneral {
    int device = 0;
    std::int16_t duty = 0; ///< ±32767 is ±100 %
    LimitSwitch forward;
    LimitSwitch reverse;
    bool limitOverride = false; ///< the control frame replaces the stored enables
    bool forwardDisabledByFrame = false;
    bool reverseDisabledByFrame = false;
    bool softForwardHit = false;
    bool softForwardEnabled = false;
    bool softReverseHit = false;
    bool softReverseEnabled = false;
    bool currentLimitActive = false;
    bool overTemperature = false;
    bool underVoltage = false;
    bool gateDriver = false;
    ControlMode mode = ControlMode::NoDrive; ///< may hold a reserved code
    bool errorDivided = false;
    std::int32_t error = 0; ///< raw closed-loop error after sign and scale flag
};

struct StatusEncoder {
    int device = 0;
    std::int32_t position = 0; ///< counts, after the scale flag
    std::int32_t velocity = 0; ///< counts per 100 ms, after the scale flag
    bool positionDivided = false;
    bool velocityDivided = false;
    bool pinA = false;
    bool pinB = false;
    bool pinIndex = false;
};

struct StatusAnalog {
    int device = 0;
    double analogIn = 0.0;    ///< V, 0…3.3
    double current = 0.0;     ///< A, negative flows from M− to M+
    double temperature = 0.0; ///< °C
    double busVoltage = 0.0;  ///< V
};

struct FirmwareVersions {
    ImageType image = ImageType::Application;
    std::uint16_t application = 0;
    std::uint16_t bootloader = 0;
};

/// Whether this is the message with identifier `base` and `size` bytes.
[[nodiscard]] bool isMessage(const CanFrame &frame, std::uint32_t base, std::size_t size);
[[nodiscard]] constexpr int deviceOf(const CanFrame &frame)
{
    return static_cast<int>(frame.id & id::deviceMask);
}

[[nodiscard]] std::optional<EnumResponse0> decodeEnumResponse0(const CanFrame &frame);
[[nodiscard]] std::optional<EnumResponse1> decodeEnumResponse1(const CanFrame &frame);
[[nodiscard]] std::optional<VendorStatus> decodeVendorStatus(const CanFrame &frame);
/// 1…8 bytes of bulk data; a view into `frame`.
[[nodiscard]] std::optional<std::span<const std::uint8_t>> decodeVendorData(const CanFrame &frame);
[[nodiscard]] std::optional<ParamResponse> decodeParamResponse(const CanFrame &frame);
[[nodiscard]] std::optional<StatusGeneral> decodeStatusGeneral(const CanFrame &frame);
[[nodiscard]] std::optional<StatusEncoder> decodeStatusEncoder(const CanFrame &frame);
[[nodiscard]] std::optional<StatusAnalog> decodeStatusAnalog(const CanFrame &frame);

/// Closed-loop error in the unit of the active mode: duty units, counts per 100 ms, counts, A or V.
[[nodiscard]] double errorOf(const StatusGeneral &status);

/// Bulk data of GetFwver, GetFlashSeqnum and GetDescriptors, complete.
[[nodiscard]] std::optional<FirmwareVersions> decodeFirmwareVersions(std::span<const std::uint8_t> bytes);
[[nodiscard]] std::optional<std::uint32_t> decodeFlashSequence(std::span<const std::uint8_t> bytes);
/// Field number and text (Latin-1 turned into UTF-8, a counted NUL dropped), unknown fields included; nothing when
/// truncated.
using DescriptorList = std::vector<std::pair<std::uint8_t, std::string>>;
[[nodiscard]] std::optional<DescriptorList> decodeDescriptors(std::span<const std::uint8_t> bytes);

/// "1.23" of 0x0117, empty for noApplication. The minor is a number of its own, so 1.9 is older than 1.23.
[[nodiscard]] std::string versionText(std::uint16_t version);
/// UTF-8 to Latin-1; nothing when a character is not in Latin-1, or is NUL.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> toLatin1(std::string_view text);

} // namespace mb::dmc60c
