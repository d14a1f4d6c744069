// SPDX-License-Identifier: GPL-3.0-or-later
// Golden vectors (dmc60c/README.md#vectors), with where they come from: H! the vendor's compiled structs, H
// its source, F device firmware, R an independent host, D data sheet, W forum.
#include "families/dmc60c/codec.h"
#include "families/dmc60c/vendor.h"
#include "wire/fixedpoint.h"

#include <gtest/gtest.h>

#include <functional>

namespace mb::dmc60c {
namespace {

constexpr std::uint16_t session = 0x1234;

CanFrame frame(std::string_view text)
{
    const auto parsed = canFrameFromText(text);
    EXPECT_TRUE(parsed) << text;
    return parsed.value_or(CanFrame{});
}

struct Encoded {
    std::string_view name;
    std::string_view source;
    CanFrame made;
    std::string_view text;
};

Control control(ControlMode mode, std::int32_t target, std::uint16_t ramp = 0)
{
    Control c;
    c.mode = mode;
    c.target = target;
    c.ramp = ramp;
    return c;
}

Control with(Control c, const std::function<void(Control &)> &change)
{
    change(c);
    return c;
}

CanFrame vendor(Command command, std::uint16_t param1 = 0, std::uint16_t param2 = 0, int device = 5)
{
    return encodeVendorCommand(device, session, {command, param1, param2});
}

CanFrame set(std::uint8_t parameter, WireType type, std::int64_t raw)
{
    return encodeParamSet(5, session, parameter, fieldOf(type, raw));
}

std::int32_t q16(double value)
{
    return static_cast<std::int32_t>(toFixed(value, 65536.0));
}

const std::array<std::uint8_t, 4> nameBytes{'A', 'r', 'm', 0};
const std::array<std::uint8_t, 4> crcBytes{0x1B, 0x67, 0x48, 0x36};
const Control offControl = control(ControlMode::Voltage, 0);

const std::vector<Encoded> encodedTable{
    {"E1 enumerate", "H F W", encodeEnumerate(), "00000240#"},
    {"V5 GetDescriptors", "H! F R", vendor(Command::GetDescriptors), "0206FC05#3412600000000000"},
    {"V9 name bytes", "F", encodeVendorData(5, nameBytes), "0206FC45#41726D00"},
    {"V10 GetFwver", "H! F", vendor(Command::GetFwver), "0206FC05#3412610000000000"},
    {"V16 EnterBootloader", "H! F", vendor(Command::EnterBootloader), "0206FC05#3412F00000000000"},
    {"V18 SoftReset", "H! F", vendor(Command::SoftReset), "0206FC05#3412F10000000000"},
    {"V21 page 0 of the application", "H! F", vendor(Command::EraseWriteFlashPage, 0, 0), "0206FC05#3412F20000000000"},
    {"V25 last bytes of a page", "F", encodeVendorData(5, crcBytes), "0206FC45#1B674836"},
    {"P3 61 = 40 A", "H! R", set(61, WireType::Fixed16x16, q16(40.0)), "02061885#34123D00002800"},
    {"P5 63 = 500 ms", "H! R", set(63, WireType::Uint16, 500), "02061885#34123FF4010000"},
    {"P6 64 = enabled", "H! R", set(64, WireType::Boolean, 1), "02061885#34124001000000"},
    {"P8 10 = 0.1", "H! R", set(10, WireType::Fixed16x16, q16(0.1)), "02061885#34120A9A190000"},
    {"P9 10 = -2.5", "H! R", set(10, WireType::Fixed16x16, q16(-2.5)), "02061885#34120A0080FDFF"},
    {"P11 17 = 32767", "H! R", set(17, WireType::Int32, 32767), "02061885#341211FF7F0000"},
    {"P12 5 = -1000 counts", "H! R", set(5, WireType::Int32, -1000), "02061885#34120518FCFFFF"},
    {"P17 52 = 1", "H! R", set(52, WireType::Flags32, 1), "02061885#34123401000000"},
    {"dmc60c/README.md#byte-orders: 18 = -32768", "D", set(18, WireType::Int32, -32768), "02061885#3412120080FFFF"},
    {"C1 NoDrive", "H! F", encodeControl(5, Control{}), "02060005#0F00000000000000"},
    {"C3 duty -16384", "H! F", encodeControl(5, control(ControlMode::Voltage, -16384)), "02060005#000000FF00C00000"},
    {"C4 duty 32767", "H! F", encodeControl(5, control(ControlMode::Voltage, 32767)), "02060005#00000000FF7F0000"},
    {"C6 duty 10000, ramp 2500", "H! F", encodeControl(5, control(ControlMode::Voltage, 10000, 2500)),
        "02060005#000000001027C409"},
    {"C7 velocity 10240", "H!", encodeControl(5, control(ControlMode::Velocity, 10240)), "02060005#0100000000280000"},
    {"C9 velocity 13", "H!", encodeControl(5, control(ControlMode::Velocity, 13)), "02060005#010000000D000000"},
    {"C10 position 123456", "H!", encodeControl(5, control(ControlMode::Position, 123456)),
        "02060005#0200000140E20000"},
    {"C12 position 123456, slot 1, sensor reversed, ramp 1024", "H!",
        encodeControl(5,
            with(control(ControlMode::Position, 123456, 1024),
                [](Control &c) {
                    c.slot = 1;
                    c.reverseSensor = true;
                })),
        "02060005#C200000140E20004"},
    {"C13 12.5 A", "H!", encodeControl(5, control(ControlMode::Current, q16(12.5))), "02060005#0300000C00800000"},
    {"C15 6 V, ramp 1024", "H!", encodeControl(5, control(ControlMode::VoltageCompensated, q16(6.0), 1024)),
        "02060005#0400000600000004"},
    {"C16 -12 V", "H!", encodeControl(5, control(ControlMode::VoltageCompensated, q16(-12.0))),
        "02060005#040000F400000000"},
    {"C18 override to brake", "H! F R", encodeControl(5, with(offControl, [](Control &c) { c.brake = true; })),
        "02060005#3000000000000000"},
    {"C19 override to coast", "H! F R", encodeControl(5, with(offControl, [](Control &c) { c.brake = false; })),
        "02060005#1000000000000000"},
    {"C21 both switches disabled by the frame", "H! R",
        encodeControl(5,
            with(offControl,
                [](Control &c) {
                    c.overrideLimits = true;
                    c.disableForwardLimit = true;
                    c.disableReverseLimit = true;
                })),
        "02060005#000E000000000000"},
    {"C22 largest 8.16 target", "H!", encodeControl(5, control(ControlMode::Current, 0x7FFFFF)),
        "02060005#0300007FFFFF0000"},
};

const std::vector<Encoded> &encodedVectors()
{
    return encodedTable;
}

TEST(Dmc60cCodec, EncodesEveryGoldenRequest)
{
    for (const Encoded &vector : encodedVectors())
        EXPECT_EQ(toText(vector.made), vector.text) << vector.name << " (" << vector.source << ')';
}

TEST(Dmc60cCodec, ReversesTheMotorInBitZeroOfTheSecondByte)
{
    const CanFrame made
        = encodeControl(5, with(control(ControlMode::Follower, 9), [](Control &c) { c.reverseMotor = true; }));
    EXPECT_EQ(toText(made), "02060005#0501000009000000");
}

TEST(Dmc60cCodec, PutsEachOf64DeviceNumbersInTheIdentifier)
{
    for (int device = 0; device <= maxDeviceNumber; ++device) {
        EXPECT_EQ(encodeControl(device, Control{}).id, 0x02060000U + static_cast<unsigned>(device));
        EXPECT_EQ(encodeParamRequest(device, session, 1).id, 0x02061800U + static_cast<unsigned>(device));
    }
}

TEST(Dmc60cCodec, RequestsAParameterInThreeBytes)
{
    EXPECT_EQ(toText(encodeParamRequest(5, session, 61)), "02061805#34123D");
}

TEST(Dmc60cCodec, DecodesStatusIntoTheSameNumbersAsTheMonitor)
{
    const auto general = decodeStatusGeneral(frame("02061405#00804BE32C000000"));
    ASSERT_TRUE(general);
    EXPECT_EQ(general->device, 5);
    EXPECT_EQ(general->duty, -32768);
    EXPECT_TRUE(
        general->forward.pin && general->forward.hit && general->forward.normallyClosed && !general->forward.disabled);
    EXPECT_TRUE(general->reverse.disabled && !general->reverse.pin && !general->reverse.hit
        && !general->reverse.normallyClosed);
    EXPECT_TRUE(general->limitOverride && general->forwardDisabledByFrame && !general->reverseDisabledByFrame);
    EXPECT_TRUE(general->softReverseHit && general->softReverseEnabled && !general->softForwardHit
        && !general->softForwardEnabled);
    EXPECT_TRUE(
        general->currentLimitActive && general->gateDriver && !general->overTemperature && !general->underVoltage);
    EXPECT_EQ(general->mode, ControlMode::Follower);
    EXPECT_EQ(errorOf(*decodeStatusGeneral(frame("02061405#0020110018008001"))), 1.5);
    EXPECT_EQ(errorOf(*decodeStatusGeneral(frame("02061405#0000110090FEFFFF"))), -512.0);

    const auto encoder = decodeStatusEncoder(frame("02061485#01E240FED4000014"));
    ASSERT_TRUE(encoder);
    EXPECT_EQ(encoder->position, 123456);
    EXPECT_EQ(encoder->velocity, -300);
    EXPECT_TRUE(encoder->pinA && !encoder->pinB && encoder->pinIndex);
    EXPECT_EQ(decodeStatusEncoder(frame("02061485#8000008000000003"))->position, -67108864);
    EXPECT_EQ(decodeStatusEncoder(frame("02061485#7FFFFF7FFF000003"))->velocity, 131068);

    const auto analog = decodeStatusAnalog(frame("020614C5#4C03FF3B00F6FF1B"));
    ASSERT_TRUE(analog);
    EXPECT_EQ(analog->temperature, -10.0);
    EXPECT_EQ(analog->busVoltage, 27.99609375);
}

TEST(Dmc60cCodec, ReadsOnlySixteenErrorBitsInOpenLoopMode)
{
    const auto status
        = decodeStatusGeneral(frame("02061405#00001100000100AA")); // the last byte has no meaning in mode 0
    ASSERT_TRUE(status);
    EXPECT_EQ(errorOf(*status), 1.0);
    EXPECT_EQ(errorOf(*decodeStatusGeneral(frame("02061405#0000110080FFFF00"))), -256.0);
}

TEST(Dmc60cCodec, DecodesParameterAnswersByWireType)
{
    const auto field = [](std::string_view text) { return decodeParamResponse(frame(text))->field; };
    EXPECT_EQ(rawOf(WireType::Int32, field("02061845#14FFFFFFFF00")), -1);
    EXPECT_EQ(rawOf(WireType::Fixed16x16, field("02061845#3D0000280000")), 40 * 65536);
    EXPECT_EQ(rawOf(WireType::Uint32, field("02061845#14FFFFFFFF00")), 4294967295LL);
    const auto refused = decodeParamResponse(frame("02061845#5D0000000002"));
    EXPECT_EQ(refused->parameter, 93);
    EXPECT_EQ(refused->status, ParameterStatus::BadValue);
    EXPECT_EQ(decodeParamResponse(frame("02061845#C80000000001"))->status, ParameterStatus::BadParameter);
}

TEST(Dmc60cCodec, CarriesEveryWireTypeThereAndBack)
{
    for (const WireType type : {WireType::Boolean, WireType::Int16, WireType::Int32, WireType::Uint8, WireType::Uint16,
             WireType::Uint31, WireType::Uint32, WireType::Fixed16x16, WireType::Flags32}) {
        const RawRange range = rangeOf(type);
        for (const std::int64_t raw : {range.low, range.low + 1, (range.low + range.high) / 2, range.high})
            EXPECT_EQ(rawOf(type, fieldOf(type, raw)), raw) << static_cast<int>(type);
    }
}

TEST(Dmc60cCodec, ReassemblesTheDescriptorsOfTheReference)
{
    std::vector<std::uint8_t> bytes; // V7a–e
    for (const auto *const text : {"0206FC85#0106444D43363043", "0206FC85#030F446967696C65",
             "0206FC85#6E7420444D433630", "0206FC85#43060C3231303333", "0206FC85#34334137394632"}) {
        const CanFrame part = frame(text);
        const auto data = decodeVendorData(part);
        ASSERT_TRUE(data);
        bytes.insert(bytes.end(), data->begin(), data->end());
    }
    ASSERT_EQ(bytes.size(), 39U);
    const auto list = decodeDescriptors(bytes);
    ASSERT_TRUE(list);
    EXPECT_EQ(*list, (DescriptorList{{1, "DMC60C"}, {3, "Digilent DMC60C"}, {6, "2103343A79F2"}}));
    for (std::size_t cut = 1; cut < bytes.size(); ++cut) {
        const bool atBoundary = cut == 8 || cut == 25;
        EXPECT_EQ(decodeDescriptors(std::span(bytes).first(cut)).has_value(), atBoundary) << "cut at " << cut;
    }
}

TEST(Dmc60cCodec, KeepsUnknownDescriptorsDropsACountedNulAndReadsLatin1)
{
    const std::vector<std::uint8_t> bytes{9, 1, 'x', 1, 3, 'M', 0xFC, 0};
    EXPECT_EQ(*decodeDescriptors(bytes), (DescriptorList{{9, "x"}, {1, "M\xC3\xBC"}}));
}

TEST(Dmc60cCodec, TurnsNamesIntoLatin1)
{
    EXPECT_EQ(*toLatin1("M\xC3\xBC"), (std::vector<std::uint8_t>{'M', 0xFC}));
    EXPECT_FALSE(toLatin1("\xE2\x82\xAC")) << "the euro sign is not in Latin-1";
    EXPECT_FALSE(toLatin1("cut \xC3"));
    EXPECT_FALSE(toLatin1(std::string_view("a\0b", 3)));
}

TEST(Dmc60cCodec, ReadsVersionsAndTheFlashSequenceNumber)
{
    const auto bytes = [](std::string_view text) {
        const CanFrame f = frame(text);
        return std::vector<std::uint8_t>(f.bytes().begin(), f.bytes().end());
    };
    const auto v12 = decodeFirmwareVersions(bytes("0206FC85#000017010901"));
    ASSERT_TRUE(v12);
    EXPECT_EQ(v12->image, ImageType::Application);
    EXPECT_EQ(versionText(v12->application), "1.23");
    EXPECT_EQ(versionText(v12->bootloader), "1.9");
    const auto v13 = decodeFirmwareVersions(bytes("0206FC85#0100FFFF0901"));
    EXPECT_EQ(v13->image, ImageType::Bootloader);
    EXPECT_EQ(versionText(v13->application), "");
    EXPECT_EQ(decodeFlashSequence(bytes("0206FC85#45230100")), 74565U);
    EXPECT_FALSE(decodeFlashSequence(bytes("0206FC85#452301")));
    EXPECT_FALSE(decodeFirmwareVersions(bytes("0206FC85#0100FFFF09")));
}

TEST(Dmc60cCodec, ComputesTheArithmeticOfTheReference)
{
    EXPECT_NEAR(2070.0 / 65536.0, 0.031585693, 5e-10);
    EXPECT_EQ(q16(0.1), 0x199A) << "nearest, not truncated";
    EXPECT_EQ(q16(819.175), 0x03332CCD);
    EXPECT_EQ(toFixed(3.3 / 4096 / (0.0005 * 50), 65536.0), 2112);
}

TEST(Dmc60cOrders, AreWaitedForAndRepeatedAsTheReferenceSays)
{
    using namespace std::chrono_literals;
    using enum Command;
    const auto expect = [](std::initializer_list<Command> orders, int tries, Duration timeout) {
        for (const Command order : orders) {
            EXPECT_EQ(attemptsOf(order).tries, tries) << toString(order);
            EXPECT_EQ(attemptsOf(order).timeout, timeout) << toString(order);
        }
    };
    expect({FlashLEDs, GetDescriptors, GetFwver, GetFlashSeqnum}, 3, 250ms);
    expect({SetDevNumber}, 3, 500ms);
    expect({SetDevName, SetManName, SetProdName, SetManDate, SetHardwareVer, SetSN}, 3, 1s);
    expect({EnterBootloader, EraseWriteFlashPage}, 3, 2s);
    expect({SoftReset}, 1, 3s);
    expect({J1ShortTest, J1OpenTest}, 1, 2s);
}

} // namespace
} // namespace mb::dmc60c
