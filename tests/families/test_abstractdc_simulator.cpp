// SPDX-License-Identifier: GPL-3.0-or-later
// The drive's side of the same vectors, as literal frames, and what is wrong with the firmware.
#include "abstractdcbench.h"
#include "families/abstractdc/simulatorflash.h"
#include "families/abstractdc/simulatorregulator.h"

namespace mb::abstractdc {
namespace {

using Frames = std::vector<std::string>;

class AbstractDcSimulator : public Drives {
protected:
    /// Of dialect F with offset 0: the last controller output.
    std::string voltage() { return ask("384#04").at(0); }
    int output() { return canFrameFromText(voltage())->data[0]; }
};

TEST_F(AbstractDcSimulator, AnswersLogsOfDialectF)
{
    add("abstractdc:0,gains=default");
    clock.advance(100ms);
    EXPECT_EQ(ask("384#01"), Frames{"400#00000000"});
    EXPECT_EQ(ask("384#00"), Frames{"480#00000000"});
    EXPECT_EQ(ask("384#02"), Frames{"500#00000000"});
    EXPECT_EQ(ask("384#03"), Frames{"600#FA000000"}) << "25 °C, 10 counts each";
    EXPECT_EQ(ask("384#04"), Frames{"680#00000000"});
    for (const char *nothing : {"384#05", "384#0100", "384#", "00000384#01", "385#01"})
        EXPECT_EQ(ask(nothing), Frames{}) << nothing;
}

TEST_F(AbstractDcSimulator, AddsItsOffsetToEveryAnswerButTheVoltage)
{
    add("abstractdc:5");
    EXPECT_EQ(ask("389#01"), Frames{"405#00000000"});
    EXPECT_EQ(ask("389#04"), Frames{"680#00000000"});
    EXPECT_EQ(ask("384#01"), Frames{"405#00000000"}) << "900 is for all";
}

TEST_F(AbstractDcSimulator, RunsDirectlyAndReportsWhatItWasTold)
{
    Simulator &drive = add("abstractdc:0");
    send("064#0464000000"); // S14
    EXPECT_TRUE(drive.isOutputOn());
    EXPECT_EQ(voltage(), "680#64000000");
    clock.advance(500ms);
    EXPECT_GT(drive.speed(), 0.0);
    send("064#049CFFFFFF");
    EXPECT_EQ(voltage(), "680#9CFFFFFF"); // R8
    send("064#0000000000");               // S16
    EXPECT_FALSE(drive.isOutputOn());
    EXPECT_EQ(voltage(), "680#9CFFFFFF") << "abstractdc/README.md#stale-logs: it stays";
}

TEST_F(AbstractDcSimulator, AnOutputIsCastToSixteenBitsBeforeItIsClamped)
{
    EXPECT_EQ(simulation::pwmOf(300), 255);
    EXPECT_EQ(simulation::pwmOf(40000), -255);
    EXPECT_EQ(simulation::pwmOf(47968), -255);
    EXPECT_EQ(simulation::pwmOf(-100), -100);
}

TEST_F(AbstractDcSimulator, APositionTooFarAwayRunsTheMotorBackwards)
{
    Simulator &drive = add("abstractdc:0,gains=default");
    send("0C8#030000350C00"); // S8: P = 0.8
    send("0C8#030340420F00");
    send("064#0360EA0000"); // 60 000
    clock.advance(200ms);
    EXPECT_LT(drive.speed(), 0.0);
}

TEST_F(AbstractDcSimulator, ComputesInIntegersWithItsGains)
{
    Simulator &drive = add("abstractdc:0,gains=default");
    drive.disturb("stall", 1.0);
    for (const char *frame : {"0C8#010040420F00", "0C8#0101E8030000", "0C8#010340420F00"}) // S1, S2, S4
        send(frame);
    send("064#0164000000"); // 100 counts/s
    clock.advance(21ms);
    const int first = output();
    EXPECT_GE(first, 100) << "P";
    EXPECT_LE(first, 102) << "and I of a part of a loop";
    clock.advance(20040us);
    EXPECT_EQ(output() - first, 2) << "I of a whole one";
    send("064#0101000000"); // error 1: I adds 1000·20/1000000 = 0.02, cut to nothing
    clock.advance(500ms);
    const std::string before = voltage();
    clock.advance(500ms);
    EXPECT_EQ(voltage(), before);
}

TEST_F(AbstractDcSimulator, NothingLimitsTheIntegral)
{
    Simulator &drive = add("abstractdc:0,gains=default");
    drive.disturb("stall", 1.0);
    send("0C8#010140420F00"); // I = 1 per ms
    send("0C8#010340420F00");
    send("064#0164000000");
    clock.advance(1s);
    const auto output = canFrameFromText(voltage());
    ASSERT_TRUE(output);
    EXPECT_GT(output->data[1] * 256 + output->data[2] * 65536, 65536) << "100 · 1000 ms";
}

TEST_F(AbstractDcSimulator, ANegativeDivisorTurnsTheCurrentLoopRound)
{
    Simulator &drive = add("abstractdc:0,gains=default");
    drive.disturb("stall", 1.0);
    send("0C8#0200E0930400"); // S5
    send("0C8#0203C0BDF0FF"); // S7
    send("064#0264000000");
    clock.advance(21ms);
    EXPECT_EQ(voltage(), "680#E2FFFFFF") << "-30";
}

TEST_F(AbstractDcSimulator, SpeedIsMeasuredInItsModeOnlyAndFrozenElsewhere)
{
    add("abstractdc:0");
    send("064#0464000000");
    clock.advance(1s);
    EXPECT_EQ(ask("384#01"), Frames{"400#00000000"}) << "turning, but not in speed mode";
    send("064#01F4010000");
    clock.advance(1s);
    const std::string measured = ask("384#01").at(0);
    EXPECT_NE(measured, "400#00000000");
    send("064#0000000000");
    clock.advance(1s);
    EXPECT_EQ(ask("384#01").at(0), measured) << "standing, but the log still says so";
}

TEST_F(AbstractDcSimulator, TheDocumentsCodesDoOtherThingsToTheFirmware)
{
    Simulator &drive = add("abstractdc:0");
    send("064#0410270000"); // S26: position 10000 for D
    EXPECT_EQ(voltage(), "680#10270000") << "direct";
    clock.advance(100ms);
    EXPECT_GT(drive.speed(), 0.0);
    send("064#0000000000");
    send("0C8#020440420F00"); // D's divisor is F's averaging: 16 960 samples of a buffer of 500
    clock.advance(11s);
    EXPECT_TRUE(happened("memory-overrun"));
}

TEST_F(AbstractDcSimulator, AnAveragingThatIsLoweredBehindItsSampleOverwritesTheMemory)
{
    add("abstractdc:0,gains=default");
    send("0C8#020464000000"); // 100
    clock.advance(3100ms);    // and 54 or 55 of the next
    send("0C8#02043C000000"); // 60, which are yet to come
    clock.advance(12s);
    EXPECT_FALSE(happened("memory-overrun"));
    send("0C8#020464000000");
    clock.advance(1300ms);
    send("0C8#020401000000");
    clock.advance(12s);
    EXPECT_TRUE(happened("memory-overrun"));
}

TEST_F(AbstractDcSimulator, ARaisedAveragingTellsAPartOfTheCurrentUntilItHasAveragedOnce)
{
    Simulator &drive = add("abstractdc:0,gains=default");
    drive.disturb("stall", 1.0);
    send("064#04FF000000");
    clock.advance(1s);
    const auto current = [this] {
        const auto frame = canFrameFromText(ask("384#02").at(0));
        return frame->data[0] + 256 * frame->data[1];
    };
    const int whole = current();
    ASSERT_GT(whole, 80);
    send("0C8#020432000100"); // 65536 more than 50
    EXPECT_LE(current(), 4) << "of one or two samples";
    clock.advance(500ms);
    EXPECT_NEAR(current(), whole / 2, 5);
    clock.advance(600ms);
    EXPECT_NEAR(current(), whole, 5) << "of 50 samples, for it takes 16 bits of the number";
}

TEST_F(AbstractDcSimulator, ANegativeDivisorKeepsTheIntegralAcrossModes)
{
    Simulator &drive = add("abstractdc:0,gains=default");
    drive.disturb("stall", 1.0);
    send("0C8#010140420F00"); // I = 1 per ms
    for (const bool negative : {false, true}) {
        send(negative ? "0C8#0103C0BDF0FF" : "0C8#010340420F00");
        send("064#0164000000");
        clock.advance(1s);
        send("064#0000000000");
        const std::string last = voltage();
        send("064#0100000000"); // no error
        clock.advance(21ms);
        EXPECT_EQ(voltage(), negative ? last : "680#00000000");
        send("064#0000000000");
    }
}

TEST_F(AbstractDcSimulator, LegacyDrivesObeyEightBytesAndIgnoreFive)
{
    Simulator &legacy = add("abstractdc:0,dialect=L");
    send("064#0464000000");
    EXPECT_FALSE(legacy.isOutputOn());
    send("064#0400000064000000"); // S25
    EXPECT_TRUE(legacy.isOutputOn());
    send("064#0000000000");
    EXPECT_TRUE(legacy.isOutputOn()) << "five bytes stop nothing here";
    send("064#0000000000000000"); // S17
    EXPECT_FALSE(legacy.isOutputOn());
    EXPECT_EQ(ask("384#01"), Frames{"3E8#00000000"});
    EXPECT_EQ(ask("384#00").at(0).substr(0, 4), "44C#");
    EXPECT_EQ(ask("384#02"), Frames{"4B0#00000000"});
    EXPECT_EQ(ask("384#03"), Frames{});
    EXPECT_EQ(ask("384#04"), Frames{});
}

TEST_F(AbstractDcSimulator, TodaysDrivesIgnoreEightBytes)
{
    Simulator &drive = add("abstractdc:0");
    send("0C8#0100000040420F00"); // S22
    send("064#0400000064000000");
    EXPECT_FALSE(drive.isOutputOn());
    send("064#0464000000");
    send("064#0000000000000000"); // S17
    EXPECT_TRUE(drive.isOutputOn());
}

TEST_F(AbstractDcSimulator, TheOldestCannotBeStopped)
{
    Simulator &oldest = add("abstractdc:9,dialect=LL");
    EXPECT_EQ(ask("384#01"), Frames{});
    EXPECT_EQ(ask("320#00"), Frames{}) << "no broadcast";
    EXPECT_EQ(ask("329#00"), Frames{"455#00000000"});
    send("06D#0300000064000000");
    EXPECT_TRUE(oldest.isOutputOn());
    send("06D#0000000000000000"); // speed 0 for it: whatever the loop makes of that, it is not off by order
    EXPECT_EQ(ask("329#01").size(), 1U);
}

TEST_F(AbstractDcSimulator, DialectDHasTheDocumentsCodes)
{
    Simulator &drive = add("abstractdc:5,dialect=D");
    EXPECT_EQ(ask("389#00"), Frames{});
    EXPECT_EQ(ask("389#04"), Frames{"485#00000000"});
    EXPECT_EQ(ask("389#03"), Frames{"505#00000000"});
    EXPECT_EQ(ask("389#05"), Frames{"685#00000000"});
    send("069#0564000000");
    EXPECT_TRUE(drive.isOutputOn());
    send("069#0000000000");
    EXPECT_FALSE(drive.isOutputOn());
}

TEST(AbstractDcFlash, The51stSaveMakesTheNextStartLoadSomethingElse)
{
    simulation::SettingsFlash flash;
    EXPECT_EQ(flash.load(0), simulation::Record{}) << "blank";
    const simulation::Record current{300000, 100, 0, -1000000, 1};
    flash.save(1, current);
    for (int i = 0; i < 50; ++i)
        flash.save(0, {1000 + i, 7, 0, 1000000, 1});
    EXPECT_EQ(flash.load(0).p, 1049);
    flash.save(0, {1050, 7, 0, 1000000, 1});
    EXPECT_EQ(flash.load(0), (simulation::Record{1, -1, -1, -1, 0xFFFF}))
        << "abstractdc/README.md#saves, as seen in the firmware";
    EXPECT_EQ(flash.load(1), current);
    flash.save(0, {1051, 7, 0, 1000000, 1});
    EXPECT_EQ(flash.load(1).averaging, 65535) << "the 52nd has overwritten the current page";
}

TEST(AbstractDcFlash, SavesThatDoNotFitAnyMoreWriteNothing)
{
    struct Guarded {
        simulation::SettingsFlash flash;
        std::array<std::int32_t, 8> behind{};
    };
    for (int page = 0; page < 3; ++page) {
        Guarded memory;
        for (int i = 0; i < 300; ++i)
            memory.flash.save(page, {1000 + i, 7, 3, 1000000, 1});
        EXPECT_EQ(memory.behind, (std::array<std::int32_t, 8>{})) << "page " << page;
    }
}

TEST_F(AbstractDcSimulator, NoResetSwitchesOnWhatHasNoSupply)
{
    Simulator &drive = add("abstractdc:0,fault=reset@1.5"); // half a second from now
    drive.setPowered(false);
    clock.advance(2s);
    EXPECT_EQ(ask("384#01"), Frames{});
    drive.setPowered(true);
    EXPECT_EQ(ask("384#01").size(), 1U);
}

TEST_F(AbstractDcSimulator, TellsTheCurrentOfItsMotor)
{
    Simulator &drive = add("abstractdc:0");
    ASSERT_TRUE(drive.current().has_value());
    EXPECT_EQ(*drive.current(), 0.0);
    drive.disturb("stall", 1.0);
    send("064#04FF7F0000"); // full duty
    clock.advance(200ms);
    EXPECT_GT(std::abs(*drive.current()), 1.0);
}

TEST_F(AbstractDcSimulator, SavedGainsSurviveThePowerOthersDoNot)
{
    Simulator &drive = add("abstractdc:0,gains=default");
    drive.disturb("stall", 1.0);
    send("0C8#010040420F00");
    send("0C8#010340420F00");
    send("0C8#01"); // S10
    send("0C8#010000000000");
    EXPECT_TRUE(happened("settings-saved"));
    drive.setPowered(false);
    EXPECT_EQ(ask("384#01"), Frames{});
    drive.setPowered(true);
    send("064#0164000000");
    clock.advance(21ms);
    EXPECT_EQ(voltage(), "680#64000000");
}

TEST_F(AbstractDcSimulator, OnlyThreeAnswersWaitAtATime)
{
    add("abstractdc:0");
    for (int i = 0; i < 6; ++i)
        ASSERT_TRUE(host.send(*canFrameFromText("384#01")));
    ASSERT_TRUE(host.send(*canFrameFromText("384#00")));
    clock.advance(10ms);
    EXPECT_EQ(heard.size(), 3U) << "the requests were on the bus first, all other answers found no mailbox";
}

TEST_F(AbstractDcSimulator, GlitchesAreOffByOneWrap)
{
    add("abstractdc:0,glitches=2");
    EXPECT_EQ(ask("384#00"), Frames{"480#00000000"});
    EXPECT_EQ(ask("384#00"), Frames{"480#0100FFFF"}) << "-65535";
}

TEST_F(AbstractDcSimulator, RefusesWhatItDoesNotKnow)
{
    for (const char *text : {"abstractdc:100", "abstractdc:1,dialect=X", "abstractdc:1,motor=none",
             "abstractdc:1,load=0", "abstractdc:1,frob=1"}) {
        const auto made = simulate(host, clock, *SimulatedUnit::parse(text));
        ASSERT_FALSE(made) << text;
        EXPECT_EQ(made.error().fault, Fault::OutOfRange);
    }
}

} // namespace
} // namespace mb::abstractdc
