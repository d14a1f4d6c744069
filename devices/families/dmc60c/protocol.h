// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>

/// Names and numbers of the DMC60C protocol guide, shared by the codec and the simulator, and nothing else.
namespace mb::dmc60c {

constexpr int bitrate = 1'000'000;
constexpr int maxDeviceNumber = 63; ///< 0 = unassigned; firmware of 2016 refuses 63

/// README.md#identifiers: without the device number, which is bits 5…0.
namespace id {
constexpr std::uint32_t deviceMask = 0x3FU;
constexpr std::uint32_t messageMask = 0x1FFFFFC0U;
constexpr std::uint32_t enumerate = 0x00000240U; ///< sent exactly so, DLC 0
constexpr std::uint32_t enumResponse = 0x0206F000U;
constexpr std::uint32_t vendorCommand = 0x0206FC00U;
constexpr std::uint32_t vendorDout = 0x0206FC40U;
constexpr std::uint32_t vendorDin = 0x0206FC80U;
constexpr std::uint32_t vendorStatus = 0x0206FCC0U;
constexpr std::uint32_t paramRequest = 0x02061800U;
constexpr std::uint32_t paramResponse = 0x02061840U;
constexpr std::uint32_t paramSet = 0x02061880U;
constexpr std::uint32_t statusGeneral = 0x02061400U;
constexpr std::uint32_t statusEncoder = 0x02061480U;
constexpr std::uint32_t statusAnalog = 0x020614C0U;
constexpr std::uint32_t control = 0x02060000U;
} // namespace id

enum class ImageType : std::uint16_t { Application = 0, Bootloader = 1, AuxiliaryBootloader = 2 };
constexpr std::uint16_t noApplication = 0xFFFFU; ///< fwverApp without a valid application
constexpr std::uint32_t productDmc60c = 0x602U;  ///< pdid bits 31…20

/// README.md#vendor-commands
enum class Command : std::uint16_t {
    SetDevNumber = 0x01,
    SetDevName = 0x02,
    SetManName = 0x03,
    SetProdName = 0x04,
    SetManDate = 0x05,
    SetHardwareVer = 0x06,
    SetSN = 0x07,
    FlashLEDs = 0x50,
    GetDescriptors = 0x60,
    GetFwver = 0x61,
    GetFlashSeqnum = 0x62,
    EnterBootloader = 0xF0,
    SoftReset = 0xF1,
    EraseWriteFlashPage = 0xF2,
    J1ShortTest = 0xF3,
    J1OpenTest = 0xF4,
};

/// cerc: low byte of VENDORSTS bytes 0–1.
enum class CommandStatus : std::uint8_t {
    NoError = 0,
    NotSupported = 1,
    BadParameter = 2,
    DataRcvMore = 3,
    InBootloader = 4,
    CrcMismatch = 5,
    FlashWriteFailed = 6,
    AckReset = 7,
    TestPassed = 8,
    TestFailed = 9,
};

/// perc: byte 5 of PARAMRESP.
enum class ParameterStatus : std::uint8_t { NoError = 0, BadParameter = 1, BadValue = 2 };

/// Bits of parameters 51 and 52.
namespace faultbit {
constexpr std::uint32_t overCurrent = 0x01U;
constexpr std::uint32_t overTemperature = 0x02U;
constexpr std::uint32_t underVoltage = 0x04U;
constexpr std::uint32_t gateDriver = 0x08U;
constexpr std::uint32_t communication = 0x10U;
} // namespace faultbit

enum class Descriptor : std::uint8_t { DevName = 1, ManName = 2, ProdName = 3, ManDate = 4, HardwareVer = 5, SN = 6 };
constexpr int maxNameLength = 64; ///< accepted; above 28 some tools truncate

/// modeSelect of CANCTRL0 and STSGENERAL.
enum class ControlMode : std::uint8_t {
    Voltage = 0,
    Velocity = 1,
    Position = 2,
    Current = 3,
    VoltageCompensated = 4,
    Follower = 5,
    NoDrive = 15,
};

constexpr std::int32_t fullDuty = 32767; ///< 100 %; −32768 is full reverse, so 32768 must never be sent
constexpr int velocityPerSecond = 10;    ///< the wire counts per 100 ms

/// Times: README.md#stopping, README.md#flash, README.md#enumeration.
constexpr auto loopPeriod = std::chrono::microseconds(500);
constexpr auto heartbeat = std::chrono::milliseconds(104);
constexpr auto controlPeriod = std::chrono::milliseconds(20);
/// A quick loop answers each set-point by itself when they come every 20 ms. 3 % of the bus, while such a profile lasts.
constexpr auto glideBeat = std::chrono::milliseconds(5);
/// Between two frames as this program sends them, so that no heartbeat is missed while the bus delays one a little.
constexpr auto controlLimit = heartbeat - std::chrono::milliseconds(4);
constexpr auto faultHold = std::chrono::seconds(3);
constexpr auto flashDelay = std::chrono::seconds(15); ///< from the last change of a parameter to its flash write
constexpr auto enumWindow = std::chrono::milliseconds(150);
constexpr int enumRounds = 3;
constexpr auto defaultGeneralPeriod = std::chrono::milliseconds(10);
constexpr auto defaultEncoderPeriod = std::chrono::milliseconds(100);
constexpr auto defaultAnalogPeriod = std::chrono::milliseconds(100);

/// Flash pages: README.md#pages.
constexpr int pageSize = 4096;
constexpr int firstPage = 0; ///< written last
constexpr int lastPage = 30; ///< written first; its last instruction holds the version
constexpr int pageTransferSize = pageSize + 4;
constexpr std::uint32_t versionHexAddress = 0x1EFFCU;
constexpr std::uint32_t entryHexAddress = 0x400U;

/// Wire numbers of the parameters that code names; the table is in parameters.cpp.
namespace param {
constexpr std::uint8_t encoderPosition = 41;
constexpr std::uint8_t activeFaults = 51;
constexpr std::uint8_t stickyFaults = 52;
constexpr std::uint8_t overCurrentCount = 53;
constexpr std::uint8_t communicationCount = 57;
constexpr std::uint8_t analogPeriod = 91;
constexpr std::uint8_t encoderPeriod = 92;
constexpr std::uint8_t generalPeriod = 93;
} // namespace param

} // namespace mb::dmc60c
