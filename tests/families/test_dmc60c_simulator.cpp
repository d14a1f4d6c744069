// SPDX-License-Identifier: GPL-3.0-or-later
// Discovery, descriptors, parameters and options of the simulated DMC60C, in literal bytes.
#include "families/dmc60c/simulatorparameters.h"
#include "families/dmc60c/simulatorstatus.h"
#include "families/dmc60csimulatorbench.h"

namespace mb::test {
namespace {

using namespace std::chrono_literals;
using namespace dmc60c;
using namespace dmc60csim;

TEST(Dmc60cSimulator, IsSilentUntilItHasHeardAFrame)
{
    Dmc60cBench bench;
    bench.advance(2s);
    EXPECT_TRUE(bench.heard().empty());
    bench.send("123#00"); // any valid frame
    bench.advance(300ms);
    EXPECT_GT(bench.count(id::statusGeneral), 25U);
}

TEST(Dmc60cSimulator, AnswersEnumerationWithBothHalvesAfterItsNumberInMilliseconds)
{
    Dmc60cBench bench;
    bench.send("00000240#");
    ASSERT_TRUE(bench.hears("0206F005#341203012060")); // E2
    const Instant request = Instant{} + 67us;          // a frame without data takes 67 bits and its stuff bits
    const Duration delay = bench.heard().back().time - request;
    EXPECT_GE(delay, 5ms);
    EXPECT_LE(delay, 5ms + 300us);
    EXPECT_TRUE(bench.hears("0206F005#3412000017010901", 1ms));
}

TEST(Dmc60cSimulator, UnassignedBootloaderEnumeratesAsInTheReference)
{
    Dmc60cBench bench("dmc60c:0,session=0xBEEF,state=bootloader");
    bench.send("00000240#");
    EXPECT_TRUE(bench.hears("0206F000#EFBE03012060"));
    EXPECT_TRUE(bench.hears("0206F000#EFBE0100FFFF0901", 1ms)); // E4
    EXPECT_EQ(bench.count(id::statusGeneral), 0U);
}

TEST(Dmc60cSimulator, UnassignedApplicationTakesItsDelayFromTheSession)
{
    Dmc60cBench bench("dmc60c:0,session=0x1250"); // 0x50 × 0.5 ms
    bench.send("00000240#");
    ASSERT_NE(bench.next(id::enumResponse), nullptr);
    EXPECT_GE(bench.clock().now().time_since_epoch(), 40ms);
    EXPECT_LE(bench.clock().now().time_since_epoch(), 41ms);
}

TEST(Dmc60cSimulator, IgnoresEnumerationWhileAnAnswerIsPending)
{
    Dmc60cBench bench;
    for (int i = 0; i < 10; ++i)
        bench.send("00000240#");
    bench.advance(100ms);
    EXPECT_EQ(bench.count(id::enumResponse), 2U);
}

TEST(Dmc60cSimulator, SendsTheDescriptorsOfTheReference)
{
    Dmc60cBench bench("dmc60c:5,session=0x1234,serial=2103343A79F2");
    bench.wake();
    bench.send("0206FC05#3412600000000000"); // V5
    bench.advance(10ms);
    const std::vector<std::string> expected{"0206FCC5#00002700", "0206FC85#0106444D43363043",
        "0206FC85#030F446967696C65", "0206FC85#6E7420444D433630", "0206FC85#43060C3231303333",
        "0206FC85#34334137394632"};
    EXPECT_EQ(bench.answers(), expected);
}

TEST(Dmc60cSimulator, TellsItsVersions)
{
    Dmc60cBench application;
    application.send("0206FC05#3412610000000000"); // V10
    EXPECT_TRUE(application.hears("0206FCC5#00000600"));
    EXPECT_TRUE(application.hears("0206FC85#000017010901")); // V12
    Dmc60cBench bootloader("dmc60c:5,session=0x1234,state=bootloader");
    bootloader.send("0206FC05#3412610000000000");
    EXPECT_TRUE(bootloader.hears("0206FC85#0100FFFF0901")); // V13
}

TEST(Dmc60cSimulator, StaysSilentWhenSessionNumberOrLengthIsWrong)
{
    Dmc60cBench bench;
    bench.wake();
    bench.send("0206FC05#3512610000000000");
    bench.send("0206FC06#3412610000000000");
    bench.send("0206FC05#34126100000000");
    bench.send("02061805#35123D");
    bench.send("02061805#34123D00");
    bench.send("02061885#34123D000028");
    bench.send("00000240#00");
    bench.advance(500ms);
    EXPECT_TRUE(bench.answers().empty());
}

TEST(Dmc60cSimulator, AnswersParametersAsInTheReference)
{
    Dmc60cBench bench("dmc60c:5,session=0x1234,gains=default");
    bench.wake();
    const std::vector<std::pair<CanFrame, const char *>> rows{
        {parameterRequest(61), "02061845#3D0000280000"},                         // P2
        {*canFrameFromText("02061885#34123D00002800"), "02061845#3D0000280000"}, // P3
        {*canFrameFromText("02061885#34123FF4010000"), "02061845#3FF401000000"}, // P5
        {*canFrameFromText("02061885#34124001000000"), "02061845#400100000000"}, // P6
        {*canFrameFromText("02061885#34120A9A190000"), "02061845#0A9A19000000"}, // P8
        {*canFrameFromText("02061885#34120A0080FDFF"), "02061845#0A0080FDFF00"}, // P9
        {*canFrameFromText("02061885#341211FF7F0000"), "02061845#11FF7F000000"}, // P11
        {*canFrameFromText("02061885#34120518FCFFFF"), "02061845#0518FCFFFF00"}, // P12
        {parameterSet(93, 51), "02061845#5D0000000002"},                         // P14
        {parameterRequest(200), "02061845#C80000000001"},                        // P15
        {parameterSet(200, 1), "02061845#C80000000001"},
        {parameterRequest(9), "02061845#091608000000"},  // P20
        {parameterRequest(32), "02061845#200000640000"}, // P21
        {parameterSet(20, -1), "02061845#14FFFFFFFF00"}, // P23
        {parameterRequest(18), "02061845#120080FFFF00"},
        {parameterSet(18, 0x8000), "02061845#120000000002"}, // dmc60c/README.md#byte-orders
        {parameterSet(51, 0), "02061845#330000000001"},
    };
    for (const auto &[request, answer] : rows) {
        bench.send(request);
        EXPECT_TRUE(bench.hears(answer)) << toText(request) << " wants " << answer;
    }
}

TEST(Dmc60cSimulator, ServesAll55ParametersWithTheirDefaultsAndRanges)
{
    Dmc60cBench bench("dmc60c:5,session=0x1234,gains=default");
    bench.wake();
    for (const simulation::Row &row : simulation::rows()) {
        bench.send(parameterRequest(row.id));
        const CanFrame *answer = bench.next(id::paramResponse);
        ASSERT_NE(answer, nullptr) << int{row.id};
        EXPECT_EQ(answer->data[0], row.id);
        EXPECT_EQ(readU32le(answer->bytes(), 1), row.fallback) << int{row.id};
        EXPECT_EQ(answer->data[5], 0);
        if (row.rule == simulation::Rule::Counter || row.rule == simulation::Rule::ReadOnly)
            continue;
        for (const std::int64_t value : {row.low, row.high, row.low - 1, row.high + 1}) {
            const bool wraps
                = row.high == 2147483647 && (value == row.high + 1 ? row.low < 0 : value == row.low - 1 && row.low < 0);
            if (wraps || value > 0xFFFFFFFFLL)
                continue;
            const bool legal = value >= row.low && value <= row.high;
            bench.send(parameterSet(row.id, value));
            answer = bench.next(id::paramResponse);
            ASSERT_NE(answer, nullptr) << int{row.id};
            EXPECT_EQ(answer->data[5], legal ? 0 : 2) << int{row.id} << " = " << value;
            EXPECT_EQ(readU32le(answer->bytes(), 1), legal ? static_cast<std::uint32_t>(value & 0xFFFFFFFF) : 0U);
        }
    }
}

TEST(Dmc60cSimulator, BootloaderServesNoParametersAndNoStatus)
{
    Dmc60cBench bench("dmc60c:5,session=0x1234,state=bootloader");
    bench.wake();
    bench.send(parameterRequest(61));
    bench.send("02060005#0000000000400000");
    bench.advance(1s);
    EXPECT_TRUE(bench.heard().empty());
    bench.send(vendorCommand(0x50));
    EXPECT_TRUE(bench.hears("0206FCC5#01000000"));
    bench.send(vendorCommand(0x62));
    EXPECT_TRUE(bench.hears("0206FCC5#01000000"));
    bench.send(vendorCommand(0xF0));
    EXPECT_TRUE(bench.hears("0206FCC5#04000000"));
}

TEST(Dmc60cSimulator, NewNumberAnswersFromItselfAndMovesEveryIdentifier)
{
    Dmc60cBench bench("dmc60c:0,session=0x1234");
    bench.wake();
    bench.send("0206FC00#3412010000000000");
    EXPECT_TRUE(bench.hears("0206FCC0#02000000")); // V3
    bench.send("0206FC00#3412010005000000");
    EXPECT_TRUE(bench.hears("0206FCC5#00000000")); // V2
    bench.forget();
    bench.advance(200ms);
    ASSERT_FALSE(bench.heard().empty());
    for (const CanFrame &frame : bench.heard())
        EXPECT_EQ(frame.id & id::deviceMask, 5U);
    bench.send(vendorCommand(0x61));
    EXPECT_NE(bench.next(id::vendorDin), nullptr);
}

TEST(Dmc60cSimulator, TakesANameWithItsNulAndRefusesTooMuchData)
{
    Dmc60cBench bench;
    bench.wake();
    bench.send(vendorCommand(0x02, 4));
    bench.send("0206FC45#41726D00"); // V9
    EXPECT_TRUE(bench.hears("0206FCC5#00000000"));
    bench.send(vendorCommand(0x60));
    EXPECT_NE(bench.next(id::vendorStatus), nullptr);
    const CanFrame *first = bench.next(id::vendorDin);
    ASSERT_NE(first, nullptr);
    EXPECT_EQ(toText(*first).substr(0, 19), "0206FC85#010341726D");
    bench.send(vendorCommand(0x02, 4));
    bench.send("0206FC45#4172614D00");
    EXPECT_TRUE(bench.hears("0206FCC5#03000000"));
    bench.send(vendorCommand(0x02, 66));
    EXPECT_TRUE(bench.hears("0206FCC5#02000000"));
}

TEST(Dmc60cSimulator, ACommandEndsATransferAndLooseDataIsIgnored)
{
    Dmc60cBench bench;
    bench.wake();
    bench.send("0206FC45#4172614D00");
    bench.send(vendorCommand(0x02, 8));
    bench.send("0206FC45#417261");
    bench.send(vendorCommand(0x61));
    bench.send("0206FC45#4172614D00");
    bench.advance(1s);
    const std::vector<std::string> expected{"0206FCC5#00000600", "0206FC85#000017010901"};
    EXPECT_EQ(bench.answers(), expected);
}

TEST(Dmc60cSimulator, PinTestsAnswerAsWithoutALoopBack)
{
    Dmc60cBench bench;
    bench.send(vendorCommand(0xF4));
    EXPECT_TRUE(bench.hears("0206FCC5#09040000")); // V24
    bench.send(vendorCommand(0xF3));
    EXPECT_TRUE(bench.hears("0206FCC5#08000000"));
    bench.send(vendorCommand(0x99));
    EXPECT_TRUE(bench.hears("0206FCC5#01000000"));
}

TEST(Dmc60cSimulator, StatusFramesComeAtTheirPeriods)
{
    Dmc60cBench bench;
    bench.wake();
    bench.advance(1s);
    EXPECT_NEAR(static_cast<double>(bench.count(id::statusGeneral)), 100.0, 1.0);
    EXPECT_NEAR(static_cast<double>(bench.count(id::statusEncoder)), 10.0, 1.0);
    EXPECT_NEAR(static_cast<double>(bench.count(id::statusAnalog)), 10.0, 1.0);
    bench.send(parameterSet(93, 50));
    bench.send(parameterSet(92, 1));
    bench.send(parameterSet(91, 500));
    bench.advance(5ms);
    bench.forget();
    bench.advance(1s);
    EXPECT_NEAR(static_cast<double>(bench.count(id::statusGeneral)), 20.0, 1.0);
    EXPECT_NEAR(static_cast<double>(bench.count(id::statusEncoder)), 1000.0, 1.0);
    EXPECT_NEAR(static_cast<double>(bench.count(id::statusAnalog)), 2.0, 1.0);
}

TEST(Dmc60cSimulator, SameSeedSameFrames)
{
    const auto record = [](std::uint64_t seed) {
        Dmc60cBench bench("dmc60c:5", seed);
        bench.send("00000240#");
        bench.drive("02060005#0000000000200000", 500ms);
        std::string all;
        for (const CanFrame &frame : bench.heard())
            all += toText(frame) + "\n";
        return all;
    };
    EXPECT_EQ(record(3), record(3));
    EXPECT_NE(record(3), record(4));
}

TEST(Dmc60cSimulator, RefusesUnknownOptionsAndValues)
{
    Dmc60cBench bench;
    for (const char *text : {"dmc60c:64", "dmc60c:5,colour=red", "dmc60c:5,motor=steam", "dmc60c:5,load=0",
             "dmc60c:5,load=9x", "dmc60c:5,session=0", "dmc60c:5,session=65536", "dmc60c:5,session=0x",
             "dmc60c:5,firmware=1", "dmc60c:5,firmware=1.300", "dmc60c:5,firmware=255.255", "dmc60c:5,state=asleep",
             "dmc60c:5,crc=D", "dmc60c:5,velocity=fast", "dmc60c:5,gains=best", "dmc60c:5,serial=1234567890123"}) {
        const auto unit = SimulatedUnit::parse(text);
        ASSERT_TRUE(unit) << text;
        const auto made = simulate(bench.port(), bench.clock(), *unit);
        ASSERT_FALSE(made) << text;
        EXPECT_EQ(made.error().fault, Fault::OutOfRange);
    }
}

TEST(Dmc60cSimulator, LeavesNothingBehind)
{
    Dmc60cBench bench;
    bench.drive("02060005#0000000000400000", 100ms);
    bench.removeDevice();
    bench.advance(1s);
    EXPECT_EQ(bench.clock().armed(), 0U);
    EXPECT_EQ(bench.port().received().size(), 0U);
    EXPECT_EQ(bench.port().traffic().size(), 0U);
    EXPECT_EQ(bench.port().stateChanged().size(), 1U) << "its own, which counts the line";
}

TEST(Dmc60cStatusFrames, EncodeTheVectorsOfTheReference)
{
    using namespace simulation;
    GeneralState general;
    general.duty = 16384;
    general.mode = 0;
    EXPECT_EQ(toText(generalFrame(5, general)), "02061405#0040110000000000"); // S1
    general = {};
    general.mode = 2;
    general.error = -512 - 8388608 * 2;                              // too long for 24 bits
    EXPECT_EQ(toText(generalFrame(5, general)).substr(17, 2), "90"); // divided, as in S3
    general = {};
    general.duty = 8192;
    general.mode = 3;
    general.error = 98304;
    EXPECT_EQ(toText(generalFrame(5, general)), "02061405#0020110018008001"); // S4
    general = {};
    general.underVoltage = true;
    EXPECT_EQ(toText(generalFrame(5, general)), "02061405#000011007A000000"); // S6
    general.duty = -32768;
    general.forward = {true, true, false, true, true, false, false};
    general.reverse = {false, false, true, false, false, true, true};
    general.limitOverride = true;
    general.currentLimitActive = true;
    general.underVoltage = false;
    general.gateDriver = true;
    general.mode = 5;
    EXPECT_EQ(toText(generalFrame(5, general)), "02061405#00804BE32C000000");                                    // S7
    EXPECT_EQ(toText(encoderFrame(5, {123456, -300, true, false, true})), "02061485#01E240FED4000014");          // S8
    EXPECT_EQ(toText(encoderFrame(5, {-67108864, -131072, false, false, false})), "02061485#8000008000000003");  // S10
    EXPECT_EQ(toText(encoderFrame(5, {67108856, 131068, false, false, false})), "02061485#7FFFFF7FFF000003");    // S11
    EXPECT_EQ(toText(analogFrame(5, {3.296875, 59.99609375, -10.0, 27.99609375})), "020614C5#4C03FF3B00F6FF1B"); // S13
}

} // namespace
} // namespace mb::test
