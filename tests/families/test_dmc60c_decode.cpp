// SPDX-License-Identifier: GPL-3.0-or-later
// Golden vectors (dmc60c/README.md#vectors), as the monitor names them, and their corrupted twins. The marks of
// the sources are explained in test_dmc60c_codec.cpp.
#include "families/dmc60c/codec.h"
#include "families/dmc60c/decode.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace mb::dmc60c {
namespace {

CanFrame decodedFrame(std::string_view text)
{
    const auto parsed = canFrameFromText(text);
    EXPECT_TRUE(parsed) << text;
    return parsed.value_or(CanFrame{});
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
        const auto decoded = decodeCan(decodedFrame(vector.text), {});
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
    EXPECT_EQ(decodeCan(decodedFrame("0206F03F#0100020017010A01"), {})->address, 63);
    EXPECT_EQ(decodeCan(decodedFrame("0206FCC0#02000000"), {})->address, 0);
    EXPECT_EQ(decodeCan(decodedFrame("00000240#"), {})->address, 0);
}

TEST(Dmc60cDecode, GivesUnitsThatFollowTheModeOrTheParameter)
{
    const auto unit = [](std::string_view text, std::string_view name) {
        const auto decoded = decodeCan(decodedFrame(text), {});
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

TEST(Dmc60cDecode, DataHasAsManyFieldsAsTheFrameHasBytes)
{
    EXPECT_FALSE(decodeCan(decodedFrame("0206FC85#"), {}));
    for (std::size_t size = 1; size <= 8; ++size) {
        const auto decoded = decodeCan(decodedFrame("0206FC85#" + std::string(2 * size, '7')), {});
        ASSERT_TRUE(decoded) << size;
        ASSERT_EQ(decoded->fields.size(), size);
        EXPECT_EQ(decoded->fields.back().name, "byte" + std::to_string(size - 1));
        EXPECT_EQ(decoded->fields.back().value, 0x77);
    }
}

/// The two decoders of a general status: what the program acts on, and what the monitor shows.
TEST(Dmc60cDecode, EveryFlagOfAGeneralStatusIsOneBitForBothDecoders)
{
    const std::vector<std::pair<std::string_view, std::function<bool(const StatusGeneral &)>>> flags{
        {"fFwdLimitPin", [](const auto &s) { return s.forward.pin; }},
        {"fFwdLimitHit", [](const auto &s) { return s.forward.hit; }},
        {"fFwdLimitDisabled", [](const auto &s) { return s.forward.disabled; }},
        {"fFwdLimitNormalClosed", [](const auto &s) { return s.forward.normallyClosed; }},
        {"fRevLimitPin", [](const auto &s) { return s.reverse.pin; }},
        {"fRevLimitHit", [](const auto &s) { return s.reverse.hit; }},
        {"fRevLimitDisabled", [](const auto &s) { return s.reverse.disabled; }},
        {"fRevLimitNormalClosed", [](const auto &s) { return s.reverse.normallyClosed; }},
        {"fFwdRevLimitOverride", [](const auto &s) { return s.limitOverride; }},
        {"fFwdLimitDisableOvrd", [](const auto &s) { return s.forwardDisabledByFrame; }},
        {"fRevLimitDisableOvrd", [](const auto &s) { return s.reverseDisabledByFrame; }},
        {"fSoftFwdLimitHit", [](const auto &s) { return s.softForwardHit; }},
        {"fSoftFwdLimitEnabled", [](const auto &s) { return s.softForwardEnabled; }},
        {"fSoftRevLimitHit", [](const auto &s) { return s.softReverseHit; }},
        {"fSoftRevLimitEnabled", [](const auto &s) { return s.softReverseEnabled; }},
        {"fCurrentLimitActive", [](const auto &s) { return s.currentLimitActive; }},
        {"fOverTempFault", [](const auto &s) { return s.overTemperature; }},
        {"fUnderVoltageFault", [](const auto &s) { return s.underVoltage; }},
        {"fGateDriverFault", [](const auto &s) { return s.gateDriver; }}};
    for (std::size_t bit = 0; bit < flags.size(); ++bit) {
        CanFrame frame = decodedFrame("02061405#0000000000000000");
        frame.data[2 + bit / 8] = static_cast<std::uint8_t>(1U << bit % 8);
        const auto status = decodeStatusGeneral(frame);
        const auto shown = decodeCan(frame, {});
        ASSERT_TRUE(status && shown);
        for (std::size_t other = 0; other < flags.size(); ++other) {
            EXPECT_EQ(flags[other].second(*status), other == bit) << flags[other].first << " of bit " << bit;
            const auto field = std::find_if(shown->fields.begin(), shown->fields.end(),
                [&](const DecodedField &f) { return f.name == flags[other].first; });
            ASSERT_NE(field, shown->fields.end()) << flags[other].first;
            EXPECT_EQ(field->value, other == bit ? 1.0 : 0.0) << flags[other].first << " of bit " << bit;
        }
        EXPECT_EQ(status->mode, ControlMode{0});
        EXPECT_FALSE(status->errorDivided);
    }
    CanFrame divided = decodedFrame("02061405#0000000080010000");
    EXPECT_TRUE(decodeStatusGeneral(divided)->errorDivided);
    EXPECT_EQ(decodeStatusGeneral(divided)->error, 256);
    divided.data[4] = 0;
    EXPECT_FALSE(decodeStatusGeneral(divided)->errorDivided);
    EXPECT_EQ(decodeStatusGeneral(divided)->error, 1);
}

TEST(Dmc60cDecode, AParameterThatNobodyKnowsIsAWholeNumberWithoutUnit)
{
    const auto decoded = decodeCan(decodedFrame("02061845#C8FEFFFFFF01"), {});
    ASSERT_TRUE(decoded);
    EXPECT_EQ(decoded->fields.at(1).name, "value");
    EXPECT_EQ(decoded->fields.at(1).value, -2.0);
    EXPECT_EQ(decoded->fields.at(1).unit, "");
}

bool anyDecoderTakes(const CanFrame &f)
{
    return decodeEnumResponse0(f) || decodeEnumResponse1(f) || decodeVendorStatus(f) || decodeVendorData(f)
        || decodeParamResponse(f) || decodeStatusGeneral(f) || decodeStatusEncoder(f) || decodeStatusAnalog(f);
}

TEST(Dmc60cDecode, RefusesTheCorruptedTwinOfEveryGoldenFrame)
{
    for (const Decoded &vector : decodedVectors()) {
        const CanFrame good = decodedFrame(vector.text);
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
        const CanFrame good = decodedFrame(vector.text);
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
    EXPECT_FALSE(decodeEnumResponse1(decodedFrame("0206F005#341203012060")));
    EXPECT_FALSE(decodeEnumResponse0(decodedFrame("0206F000#EFBE0100FFFF0901")));
    const auto first = decodeEnumResponse0(decodedFrame("0206F005#341203012060"));
    ASSERT_TRUE(first);
    EXPECT_EQ(first->device, 5);
    EXPECT_EQ(first->session, 0x1234);
    EXPECT_EQ(first->productId >> 20U, productDmc60c);
    const auto second = decodeEnumResponse1(decodedFrame("0206F03F#0100020017010A01"));
    ASSERT_TRUE(second);
    EXPECT_EQ(second->image, ImageType::AuxiliaryBootloader);
    EXPECT_EQ(versionText(second->application), "1.23");
    EXPECT_EQ(versionText(second->bootloader), "1.10");
}

TEST(Dmc60cDecode, IgnoresForeignTraffic)
{
    EXPECT_FALSE(decodeCan(decodedFrame("02061445#0000000000000000"), {})) << "API 0x051 is nobody's";
    EXPECT_FALSE(decodeCan(decodedFrame("0206F040#341203012060"), {}));
    EXPECT_FALSE(decodeCan(decodedFrame("02050005#0F00000000000000"), {})) << "another manufacturer";
    EXPECT_FALSE(decodeCan(decodedFrame("240#"), {}));
}

} // namespace
} // namespace mb::dmc60c
