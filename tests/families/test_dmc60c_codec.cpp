// SPDX-License-Identifier: GPL-3.0-or-later
// Golden vectors of the protocol reference, section 9, with where they come from: H! the vendor's compiled structs, H
// its source, F device firmware, R an independent host, D data sheet, W forum.
#include "families/dmc60c/codec.h"
#include "families/dmc60c/decode.h"
#include "wire/fixedpoint.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>

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
    {"trap 15: 18 = -32768", "D", set(18, WireType::Int32, -32768), "02061885#3412120080FFFF"},
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

/// What decodeCan makes of it, so that both decoders are held to the same vectors.
using Fields = std::map<std::string_view, double>;

struct Decoded {
    std::string_view name;
    std::string_view source;
    std::string_view text;
    std::string_view message;
    Fields fields;
};

const std::vector<Decoded> decodedTable{
    {"E2", "H! F", "0206F005#341203012060", "ENUMRSP0", {{"sessid", 0x1234}, {"pdid", 0x60200103}}},
    {"E4 bootloader, no application", "H! F", "0206F000#EFBE0100FFFF0901", "ENUMRSP1",
        {{"sessid", 0xBEEF}, {"imgtyp", 1}, {"fwverApp", 0xFFFF}, {"fwverBoot", 0x0109}}},
    {"E5 auxiliary bootloader", "H! F", "0206F03F#0100020017010A01", "ENUMRSP1",
        {{"sessid", 1}, {"imgtyp", 2}, {"fwverApp", 0x0117}, {"fwverBoot", 0x010A}}},
    {"V2 success from the new number", "H! F", "0206FCC5#00000000", "VENDORSTS", {{"cerc", 0}, {"cb", 0}}},
    {"V3 BadParameter from the old number", "H! F", "0206FCC0#02000000", "VENDORSTS", {{"cerc", 2}, {"cb", 0}}},
    {"V6 39 bytes follow", "H! F", "0206FCC5#00002700", "VENDORSTS", {{"cerc", 0}, {"cb", 39}}},
    {"V19 AckReset", "H! F", "0206FCC5#07000000", "VENDORSTS", {{"cerc", 7}}},
    {"V22 CrcMismatch", "H! F", "0206FCC5#05000000", "VENDORSTS", {{"cerc", 5}}},
    {"V24 J1 test failed at QEA", "H! D", "0206FCC5#09040000", "VENDORSTS", {{"cerc", 9}, {"terc", 4}, {"cb", 0}}},
    {"V12 data", "H! F", "0206FC85#000017010901", "VENDORDIN", {{"byte2", 0x17}, {"byte5", 1}}},
    {"P2 61 = 40 A", "H! R", "02061845#3D0000280000", "PARAMRESP", {{"paramid", 61}, {"value", 40.0}, {"perc", 0}}},
    {"P14 BadValue", "H! R", "02061845#5D0000000002", "PARAMRESP", {{"paramid", 93}, {"value", 0}, {"perc", 2}}},
    {"P15 BadParameter", "H! R", "02061845#C80000000001", "PARAMRESP", {{"paramid", 200}, {"perc", 1}}},
    {"P18 sticky faults", "H! R", "02061845#340500000000", "PARAMRESP", {{"paramid", 52}, {"value", 5}}},
    {"P20 current scale", "H! R", "02061845#091608000000", "PARAMRESP", {{"paramid", 9}, {"value", 2070.0 / 65536.0}}},
    {"P21 100.0", "H! R", "02061845#200000640000", "PARAMRESP", {{"paramid", 32}, {"value", 100.0}}},
    {"P23 sign extension", "H! R", "02061845#14FFFFFFFF00", "PARAMRESP", {{"paramid", 20}, {"value", -1.0}}},
    {"S1", "H! R", "02061405#0040110000000000", "STSGENERAL",
        {{"dtcApplied", 16384}, {"fFwdLimitPin", 1}, {"fRevLimitPin", 1}, {"fFwdLimitHit", 0}, {"modeSelect", 0},
            {"errCLoop", 0}}},
    {"S3 divided error", "H! R", "02061405#0000110090FEFFFF", "STSGENERAL",
        {{"modeSelect", 2}, {"fDivErrBy256", 1}, {"errCLoop", -512}}},
    {"S4 1.5 A", "H!", "02061405#0020110018008001", "STSGENERAL",
        {{"dtcApplied", 8192}, {"modeSelect", 3}, {"errCLoop", 1.5}}},
    {"S6 under-voltage, NoDrive", "H! R", "02061405#000011007A000000", "STSGENERAL",
        {{"modeSelect", 15}, {"fUnderVoltageFault", 1}, {"fOverTempFault", 0}, {"fGateDriverFault", 0}}},
    {"S7 flags", "H! R", "02061405#00804BE32C000000", "STSGENERAL",
        {{"dtcApplied", -32768}, {"fFwdLimitPin", 1}, {"fFwdLimitHit", 1}, {"fFwdLimitDisabled", 0},
            {"fFwdLimitNormalClosed", 1}, {"fRevLimitPin", 0}, {"fRevLimitHit", 0}, {"fRevLimitDisabled", 1},
            {"fRevLimitNormalClosed", 0}, {"fFwdRevLimitOverride", 1}, {"fFwdLimitDisableOvrd", 1},
            {"fRevLimitDisableOvrd", 0}, {"fSoftFwdLimitHit", 0}, {"fSoftFwdLimitEnabled", 0}, {"fSoftRevLimitHit", 1},
            {"fSoftRevLimitEnabled", 1}, {"fCurrentLimitActive", 1}, {"fGateDriverFault", 1}, {"modeSelect", 5}}},
    {"S8", "H! D R", "02061485#01E240FED4000014", "STSENCODER",
        {{"poscnt", 123456}, {"velcnt", -300}, {"fQEAPin", 1}, {"fQEBPin", 0}, {"fQEIdxPin", 1}}},
    {"S9", "H!", "02061485#FFFFFF7FFF000003", "STSENCODER", {{"poscnt", -8}, {"velcnt", 131068}}},
    {"S10", "H!", "02061485#8000008000000003", "STSENCODER", {{"poscnt", -67108864}, {"velcnt", -131072}}},
    {"S11", "H!", "02061485#7FFFFF7FFF000003", "STSENCODER", {{"poscnt", 67108856}, {"velcnt", 131068}}},
    {"S13", "H! F R", "020614C5#4C03FF3B00F6FF1B", "STSANALOG",
        {{"vltgAnalogIn", 3.296875}, {"crntOutput", 59.99609375}, {"tmpAmbient", -10.0}, {"vltgVbus", 27.99609375}}},
    {"E1", "H F W", "00000240#", "ENUM", {}},
    {"V5", "H! F R", "0206FC05#3412600000000000", "VENDORCMD",
        {{"sessid", 0x1234}, {"cmd", 0x60}, {"PARAM1", 0}, {"PARAM2", 0}}},
    {"V9", "F", "0206FC45#41726D00", "VENDORDOUT", {{"byte0", 0x41}, {"byte3", 0}}},
    {"P request", "D", "02061805#34123D", "PARAMREQ", {{"sessid", 0x1234}, {"paramid", 61}}},
    {"P9", "H! R", "02061885#34120A0080FDFF", "PARAMSET", {{"sessid", 0x1234}, {"paramid", 10}, {"value", -2.5}}},
    {"C3", "H! F", "02060005#000000FF00C00000", "CANCTRL0", {{"modeSelect", 0}, {"trgt", -16384}, {"vltgRampSet", 0}}},
    {"C12", "H!", "02060005#C200000140E20004", "CANCTRL0",
        {{"modeSelect", 2}, {"pidsltSelect", 1}, {"fRevFeedbackSensor", 1}, {"trgt", 123456}, {"vltgRampSet", 1024}}},
    {"C16", "H!", "02060005#040000F400000000", "CANCTRL0", {{"modeSelect", 4}, {"trgt", -12.0}}},
    {"C18", "H! F R", "02060005#3000000000000000", "CANCTRL0", {{"fOverrideBC", 1}, {"fBrakeCoast", 1}}},
    {"C21", "H! R", "02060005#000E000000000000", "CANCTRL0",
        {{"fRevMotor", 0}, {"fDisableFwdLimit", 1}, {"fDisableRevLimit", 1}, {"fEnableLimitOverride", 1}}},
    {"C22", "H!", "02060005#0300007FFFFF0000", "CANCTRL0", {{"trgt", 8388607.0 / 65536.0}}},
};

const std::vector<Decoded> &decodedVectors()
{
    return decodedTable;
}

TEST(Dmc60cDecode, NamesEveryGoldenFrameAndItsFields)
{
    for (const Decoded &vector : decodedVectors()) {
        const auto decoded = decodeCan(frame(vector.text), {});
        ASSERT_TRUE(decoded) << vector.name;
        EXPECT_EQ(decoded->message, vector.message) << vector.name;
        EXPECT_EQ(decoded->family, "dmc60c");
        EXPECT_EQ(decoded->control, vector.message == "CANCTRL0") << vector.name;
        Fields fields;
        for (const DecodedField &field : decoded->fields)
            fields[field.name] = field.value;
        EXPECT_EQ(fields.size(), decoded->fields.size()) << vector.name << ": a field occurs twice";
        for (const auto &[name, value] : vector.fields) {
            ASSERT_TRUE(fields.contains(name)) << vector.name << ' ' << name;
            EXPECT_EQ(fields[name], value) << vector.name << ' ' << name << " (" << vector.source << ')';
        }
    }
}

TEST(Dmc60cDecode, TakesTheAddressFromTheIdentifier)
{
    EXPECT_EQ(decodeCan(frame("0206F03F#0100020017010A01"), {})->address, 63);
    EXPECT_EQ(decodeCan(frame("0206FCC0#02000000"), {})->address, 0);
    EXPECT_EQ(decodeCan(frame("00000240#"), {})->address, 0);
}

TEST(Dmc60cDecode, GivesUnitsThatFollowTheModeOrTheParameter)
{
    const auto unit = [](std::string_view text, std::string_view name) {
        const auto decoded = decodeCan(frame(text), {});
        for (const DecodedField &field : decoded->fields) {
            if (field.name == name)
                return field.unit;
        }
        return std::string_view("missing");
    };
    EXPECT_EQ(unit("02061405#0020110018008001", "errCLoop"), "A");
    EXPECT_EQ(unit("02061405#0000110090FEFFFF", "errCLoop"), "counts");
    EXPECT_EQ(unit("02060005#040000F400000000", "trgt"), "V");
    EXPECT_EQ(unit("02061845#3D0000280000", "value"), "A");
}

bool anyDecoderTakes(const CanFrame &f)
{
    return decodeEnumResponse0(f) || decodeEnumResponse1(f) || decodeVendorStatus(f) || decodeVendorData(f)
        || decodeParamResponse(f) || decodeStatusGeneral(f) || decodeStatusEncoder(f) || decodeStatusAnalog(f);
}

TEST(Dmc60cDecode, RefusesTheCorruptedTwinOfEveryGoldenFrame)
{
    for (const Decoded &vector : decodedVectors()) {
        const CanFrame good = frame(vector.text);
        std::vector<CanFrame> twins(5, good);
        twins[0].extended = false; // 11 bits
        twins[0].id &= 0x7FFU;
        twins[1].remote = true;
        twins[2].id ^= 0x00000800U; // another API
        twins[3].id ^= 0x00010000U; // another manufacturer
        twins[4].error = true;
        for (const CanFrame &twin : twins) {
            EXPECT_FALSE(anyDecoderTakes(twin)) << vector.name << ' ' << toText(twin);
            EXPECT_FALSE(decodeCan(twin, {})) << vector.name << ' ' << toText(twin);
        }
    }
}

TEST(Dmc60cDecode, RefusesEveryOtherLength)
{
    for (const Decoded &vector : decodedVectors()) {
        if (vector.message.starts_with("VENDORD")) // 1…8 bytes are legal
            continue;
        const CanFrame good = frame(vector.text);
        for (std::uint8_t size = 0; size <= 8; ++size) {
            CanFrame twin = good;
            twin.size = size;
            const bool otherHalf = vector.message.starts_with("ENUMRSP") && (size == 6 || size == 8);
            if (size == good.size || otherHalf)
                continue;
            EXPECT_FALSE(anyDecoderTakes(twin)) << vector.name << " with " << int{size} << " bytes";
            EXPECT_FALSE(decodeCan(twin, {})) << vector.name << " with " << int{size} << " bytes";
        }
    }
}

TEST(Dmc60cDecode, TellsTheTwoEnumerationAnswersApartByLength)
{
    EXPECT_FALSE(decodeEnumResponse1(frame("0206F005#341203012060")));
    EXPECT_FALSE(decodeEnumResponse0(frame("0206F000#EFBE0100FFFF0901")));
    const auto first = decodeEnumResponse0(frame("0206F005#341203012060"));
    ASSERT_TRUE(first);
    EXPECT_EQ(first->device, 5);
    EXPECT_EQ(first->session, 0x1234);
    EXPECT_EQ(first->productId >> 20U, productDmc60c);
    const auto second = decodeEnumResponse1(frame("0206F03F#0100020017010A01"));
    ASSERT_TRUE(second);
    EXPECT_EQ(second->image, ImageType::AuxiliaryBootloader);
    EXPECT_EQ(versionText(second->application), "1.23");
    EXPECT_EQ(versionText(second->bootloader), "1.10");
}

TEST(Dmc60cDecode, IgnoresForeignTraffic)
{
    EXPECT_FALSE(decodeCan(frame("02061445#0000000000000000"), {})) << "API 0x051 is nobody's";
    EXPECT_FALSE(decodeCan(frame("0206F040#341203012060"), {}));
    EXPECT_FALSE(decodeCan(frame("02050005#0F00000000000000"), {})) << "another manufacturer";
    EXPECT_FALSE(decodeCan(frame("240#"), {}));
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

} // namespace
} // namespace mb::dmc60c
