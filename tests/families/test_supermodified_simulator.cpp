// SPDX-License-Identifier: GPL-3.0-or-later
// The simulated node from outside, with literal frames; SIM = as the vendor's
// images behaved when they were executed.
#include "families/supermodified/simulatorcontrol.h"
#include "families/supermodified/simulatorprofile.h"
#include "families/supermodifiedbench.h"

#include <cmath>

namespace mb::supermodified {
namespace {

using namespace std::chrono_literals;
using test::Bench;
using test::bytesOf;
using test::examples;
using test::framesIn;

/// A node at 115200 and a host that speaks bytes.
struct Talk : Bench {
    explicit Talk(std::string_view unit)
        : simulator(add(unit))
    {
        EXPECT_TRUE(host.setBaudrate(115200));
    }
    Simulator &simulator;

    std::vector<std::uint8_t> answer(std::string_view hex)
    {
        say(hex);
        return heard;
    }
};

TEST(SupermodifiedSimulator, AnswersEveryExampleOfTheDatasheetAndRefusesTheFourMisprints)
{
    for (const test::Example &example : examples) {
        const bool group = example.host.substr(6, 2) == "10";
        Talk talk(group ? "supermodified:16,baud=115200" : "supermodified:4,baud=115200");
        const auto bytes = test::correctedBytes(example);
        const auto command = static_cast<Command>(bytes[4]);
        const bool moves = bytes[4] >= 0x07 && bytes[4] <= 0x0C;
        if (moves || command == Command::Halt || command == Command::GlobalHalt)
            talk.say("55 AA 04 01 19 00 19");
        if (!example.right.empty()) {
            EXPECT_EQ(talk.answer(example.host), bytesOf("55 AA 01 04 FA 01 52 A9")) << example.name;
        }
        talk.heard.clear();
        ASSERT_TRUE(talk.host.send(bytes));
        talk.clock.advance(80ms);
        const auto frames = framesIn(talk.heard);
        ASSERT_EQ(frames.size(), example.node.empty() ? 0U : 1U) << example.name;
        if (example.node.empty())
            continue;
        const Frame printed = framesIn(bytesOf(example.node)).front();
        EXPECT_EQ(frames.front().command, printed.command) << example.name;
        EXPECT_EQ(frames.front().from, printed.from) << example.name;
        if (!frames.front().is(Command::GetWarnings)) { // trap: an empty ring answers no byte at all, the datasheet one
            EXPECT_EQ(frames.front().size, printed.size) << example.name;
        }
    }
}

TEST(SupermodifiedSimulator, KeepsWhatWasSetAndGivesFactoryValues)
{
    Talk talk("supermodified:4,baud=115200,gains=default");
    EXPECT_EQ(talk.answer("55 AA 04 01 64 00 64"), bytesOf("55 AA 01 04 64 02 A0 0F C9")); // R6 FW
    EXPECT_EQ(talk.answer("55 AA 04 01 66 00 66"), bytesOf("55 AA 01 04 66 02 E8 03 8F")); // R8 FW
    EXPECT_EQ(talk.answer("55 AA 04 01 6D 00 6D"), bytesOf("55 AA 01 04 6D 01 0F 63"));    // R12 FW
    talk.say("55 AA 04 01 00 02 D0 07 D5");
    EXPECT_EQ(talk.answer("55 AA 04 01 64 00 64"), bytesOf("55 AA 01 04 64 02 D0 07 B1"));
    talk.simulator.setPowered(false);
    talk.simulator.setPowered(true);
    EXPECT_EQ(talk.answer("55 AA 04 01 64 00 64"), bytesOf("55 AA 01 04 64 02 D0 07 B1")) << "stored";
}

TEST(SupermodifiedSimulator, SpeaksTheWidthsOfItsDialect)
{
    Talk second("supermodified:4,baud=115200,dialect=D2");
    EXPECT_EQ(second.answer("55 AA 04 01 67 00 67"), bytesOf("55 AA 01 04 67 04 20 03 00 00 40")); // R9 FW32
    EXPECT_EQ(second.answer("55 AA 04 01 07 02 F4 01 F0"), bytesOf("55 AA 01 04 FA 01 12 E9"));    // R18 FW
    EXPECT_EQ(second.answer("55 AA 04 01 1E 00 1E"), bytesOf("55 AA 01 04 FA 01 11 EA"));          // S32, R17 FW
    Talk third("supermodified:4,baud=115200,dialect=D3");
    EXPECT_EQ(third.answer("55 AA 04 01 6F 00 6F").size(), 15U);
    EXPECT_EQ(third.answer("55 AA 04 01 1D 04 A0 86 01 00 3E"), bytesOf("55 AA 01 04 1D 00 1D")); // S31 LIB
    EXPECT_EQ(third.answer("55 AA 04 01 74 00 74").size(), 11U);
    EXPECT_EQ(third.answer("55 AA 04 01 1E 00 1E"), bytesOf("55 AA 01 04 1E 00 1E")); // S32 LIB
}

TEST(SupermodifiedSimulator, AnErrorInTheQueueReplacesTheAnswerAndKeepsTheCommandFromBeingExecuted)
{
    Talk talk("supermodified:4,baud=115200");
    talk.say("55 AA 04 01 19 00 19");
    ASSERT_TRUE(talk.simulator.isOutputOn());
    talk.simulator.disturb("error", 0x43);
    EXPECT_EQ(talk.answer("55 AA 04 01 1B 00 1B"), bytesOf("55 AA 01 04 FA 01 43 B8"))
        << "a stop is refused (supermodified/README.md#refused-stop)";
    EXPECT_TRUE(talk.simulator.isOutputOn());
    talk.simulator.disturb("error", 0x43);
    talk.say("55 AA 00 01 CB 00 CB");
    EXPECT_TRUE(talk.simulator.isOutputOn()) << "a broadcast stop is ignored silently";
    talk.say("55 AA 04 01 6F 00 6F");
    EXPECT_EQ(talk.answer("55 AA 04 01 1B 00 1B"), bytesOf("55 AA 01 04 1B 00 1B"));
    EXPECT_FALSE(talk.simulator.isOutputOn());
}

TEST(SupermodifiedSimulator, ResetOfThePositionMakesARunningMotorJumpAndStartDoesNot)
{
    Talk talk("supermodified:4,baud=115200");
    talk.say("55 AA 04 01 19 00 19");
    talk.say("55 AA 04 01 08 04 E8 03 00 00 E7"); // 1000
    talk.clock.advance(1s);
    const double before = talk.simulator.position();
    talk.say("55 AA 04 01 18 00 18");
    talk.clock.advance(1s);
    EXPECT_GT(talk.simulator.position(), before + 500.0) << "supermodified/README.md#start";
    const double rest = talk.simulator.position();
    talk.say("55 AA 04 01 1B 00 1B");
    talk.say("55 AA 04 01 19 00 19");
    talk.clock.advance(1s);
    EXPECT_NEAR(talk.simulator.position(), rest, 20.0);
    EXPECT_EQ(talk.answer("55 AA 04 01 6F 00 6F")[6], 0) << "Start zeroes the position (supermodified/README.md#start)";
}

TEST(SupermodifiedSimulator, AHalfFrameSwallowsTheNextOne)
{
    Talk talk("supermodified:4,baud=115200");
    talk.say("55 AA 04");
    EXPECT_EQ(talk.answer("55 AA 04 01 64 00 64").size(), 0U); // SIM: vanished, or a complaint to a garbage id
    Talk newest("supermodified:4,baud=115200,halfpacket=1");
    newest.say("55 AA 04");
    EXPECT_EQ(newest.answer("55 AA 04 01 64 00 64"), bytesOf("55 AA 01 04 FA 01 51 AA")); // R21 FW-src
    EXPECT_EQ(newest.answer("55 AA 04 01 64 00 64").size(), 9U);
}

TEST(SupermodifiedSimulator, LevelOneMakesEveryReadingFail)
{
    Talk talk("supermodified:4,baud=115200");
    EXPECT_EQ(talk.answer("55 AA 04 01 1C 01 01 1C"), bytesOf("55 AA 01 04 1C 00 1C"));
    EXPECT_EQ(talk.answer("55 AA 04 01 6F 00 6F"), bytesOf("55 AA 01 04 FA 01 15 EE")); // R23 FW
    EXPECT_EQ(talk.answer("55 AA 04 01 1C 01 00 1D"), bytesOf("55 AA 01 04 1C 00 1C"));
    EXPECT_EQ(talk.answer("55 AA 04 01 6F 00 6F").size(), 11U);
    talk.say("55 AA 04 01 73 00 73");
    EXPECT_EQ(talk.answer("55 AA 04 01 73 00 73"), bytesOf("55 AA 01 04 73 01 15 67"))
        << "noise of the ring (supermodified/README.md#errors)";
}

TEST(SupermodifiedSimulator, TheDurationOverwritesTheReportedLimitUntilARestart)
{
    Talk talk("supermodified:4,baud=115200");
    talk.say("55 AA 04 01 06 02 10 27 33");
    EXPECT_EQ(talk.answer("55 AA 04 01 69 00 69"), bytesOf("55 AA 01 04 69 02 10 27 5C"))
        << "supermodified/README.md#settings";
    EXPECT_EQ(talk.answer("55 AA 04 01 6A 00 6A"), bytesOf("55 AA 01 04 6A 02 88 13 F3"));
    talk.simulator.setPowered(false);
    talk.simulator.setPowered(true);
    EXPECT_EQ(talk.answer("55 AA 04 01 69 00 69"), bytesOf("55 AA 01 04 69 02 88 13 F0"));
    EXPECT_EQ(talk.answer("55 AA 04 01 6A 00 6A"), bytesOf("55 AA 01 04 6A 02 10 27 5F"));
}

TEST(SupermodifiedSimulator, AMaskMakesItActOnTheAnswersOfOthers)
{
    Talk talk("supermodified:4,baud=115200,mask=240");
    talk.say("55 AA 01 05 19 00 19"); // the acknowledgement of node 5 to host 1
    EXPECT_TRUE(talk.simulator.isOutputOn()) << "supermodified/README.md#masks";
    EXPECT_TRUE(talk.heard.empty()) << "silently";
}

TEST(SupermodifiedSimulator, WritingItsEepromTakesItsTime)
{
    Talk talk("supermodified:4,baud=115200");
    const auto time = [&talk](std::string_view hex) {
        talk.heard.clear();
        EXPECT_TRUE(talk.host.send(bytesOf(hex)));
        const Instant begin = talk.clock.now();
        EXPECT_TRUE(talk.clock.runUntil([&talk] { return !talk.heard.empty(); }, 100ms));
        return talk.clock.now() - begin;
    };
    EXPECT_LT(time("55 AA 04 01 64 00 64"), 2ms);
    EXPECT_GT(time("55 AA 04 01 00 02 D0 07 D5"), 3400us);
    EXPECT_GT(time("55 AA 04 01 17 04 00 C2 01 00 D0"), 10ms);
}

TEST(SupermodifiedSimulator, NodeIdAndRateChangeWithARestartOnly)
{
    Talk talk("supermodified:4,baud=115200");
    EXPECT_EQ(talk.answer("55 AA 04 01 15 01 05 11"), bytesOf("55 AA 01 04 15 00 15"));
    EXPECT_EQ(talk.answer("55 AA 04 01 6F 00 6F").size(), 11U);
    talk.simulator.setPowered(false);
    talk.simulator.setPowered(true);
    EXPECT_EQ(talk.answer("55 AA 04 01 6F 00 6F").size(), 0U);
    EXPECT_EQ(talk.answer("55 AA 05 01 6F 00 6F").size(), 11U);
}

TEST(SupermodifiedSimulator, TooLongFramesSpoilTheChecksumOrCrashIt)
{
    Talk talk("supermodified:4,baud=115200");
    EXPECT_EQ(talk.answer("55 AA 04 01 1C 14 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 01 01 02 02 01 09"),
        bytesOf("55 AA 01 04 FA 01 52 A9"))
        << "supermodified/README.md#error-reactions";
    std::string crash = "55 AA 04 01 1C 28";
    for (int i = 0; i < 40; ++i)
        crash += " 00";
    talk.say(crash + " 34");
    EXPECT_TRUE(talk.answer("55 AA 04 01 6F 00 6F").empty());
}

TEST(SupermodifiedSimulator, StallsAfterTwoSecondsAndSaysSo)
{
    Talk talk("supermodified:4,baud=115200");
    talk.say("55 AA 04 01 19 00 19");
    talk.simulator.disturb("stall", 1);
    talk.say("55 AA 04 01 08 04 E8 03 00 00 E7");
    talk.clock.advance(1500ms);
    EXPECT_TRUE(talk.simulator.isOutputOn());
    talk.clock.advance(1s);
    EXPECT_FALSE(talk.simulator.isOutputOn());
    EXPECT_EQ(talk.answer("55 AA 04 01 6F 00 6F"), bytesOf("55 AA 01 04 FA 01 01 FA"));
}

TEST(SupermodifiedSimulator, TheProductOfItsIntegralWrapsBeforeItIsDivided)
{
    simulation::LoopSettings gains{};
    gains.p = 1; // lets the sum be up to 65535 times 255
    gains.i = 2000;
    simulation::Control control(Dialect::D1, gains);
    control.restart();
    EXPECT_LT(control.step(1000000), 0.0);
    EXPECT_GT(control.step(100000), 0.0) << "2000 times 1100000 is beyond 31 bits";
}

TEST(SupermodifiedSimulator, ItsStoredGainsStepWell)
{
    for (const std::string_view dialect : {"D1", "D3"}) {
        Talk talk("supermodified:4,baud=115200,dialect=" + std::string(dialect));
        talk.say("55 AA 04 01 19 00 19");
        const double target = dialect == "D1" ? 512.0 : 4096.0;
        const auto move
            = request(4, 1, Command::MoveAbsolute, *dialectFrom(dialect), static_cast<std::int64_t>(target));
        ASSERT_TRUE(talk.host.send(uartBytes(*move)));
        double most = 0.0;
        for (int i = 0; i < 500; ++i) {
            talk.clock.advance(1ms);
            most = std::max(most, talk.simulator.position());
        }
        EXPECT_LT(most, 1.05 * target) << dialect;
        EXPECT_NEAR(talk.simulator.position(), target, 0.03 * target) << dialect;
    }
}

TEST(SupermodifiedSimulator, ProfiledMovesKeepTheirPaceAndVelocityReadsElevenPercentHigh)
{
    Talk talk("supermodified:4,baud=115200");
    talk.say("55 AA 04 01 19 00 19");
    talk.say("55 AA 04 01 07 02 D0 07 D2"); // 2000 ticks/s
    talk.clock.advance(2s);
    const double real = talk.simulator.speed();
    EXPECT_NEAR(real, 2000.0 * 0.897, 100.0) << "supermodified/README.md#speeds";
    const auto reply = framesIn(talk.answer("55 AA 04 01 71 00 71"));
    ASSERT_EQ(reply.size(), 1U);
    const auto reported = valueOf(reply[0].payload(), Format::I16);
    EXPECT_NEAR(static_cast<double>(reported.value_or(0)), 2000.0, 120.0);
    talk.say("55 AA 04 01 1A 00 1A");
    talk.clock.advance(500ms);
    EXPECT_NEAR(talk.simulator.speed(), 0.0, 50.0);
    EXPECT_TRUE(talk.simulator.isOutputOn()) << "halt holds";
}

TEST(SupermodifiedSimulator, AVelocityWhoseSquareDoesNotFitIntoItsBitsMakesAProfilePassItsTarget)
{
    const auto endOf = [](Dialect dialect, std::uint32_t velocity, std::int64_t target) {
        const simulation::LoopSettings settings{0, 0, 0, 1000, velocity}; // it never gets that fast
        simulation::Profile profile(dialect, settings);
        profile.moveTo(target);
        for (int loop = 0; loop < 5000; ++loop)
            profile.step();
        return profile.setPoint();
    };
    for (const Dialect dialect : {Dialect::D1, Dialect::D2}) {
        EXPECT_EQ(endOf(dialect, 46'340, 1000), 1000);
        EXPECT_GT(endOf(dialect, 46'341, 1000), 5000);
        EXPECT_LT(endOf(dialect, 60'000, -1000), -5000);
    }
    EXPECT_EQ(endOf(Dialect::D3, 60'000, 1000), 1000);
}

TEST(SupermodifiedSimulator, FaultsOnDemand)
{
    Talk drop("supermodified:4,baud=115200,fault=drop@2,fault=corrupt@3,fault=delay@4:30");
    const std::string_view ask = "55 AA 04 01 64 00 64";
    EXPECT_EQ(drop.answer(ask).size(), 9U);
    EXPECT_EQ(drop.answer(ask).size(), 0U);
    EXPECT_TRUE(framesIn(drop.answer(ask)).empty());
    ASSERT_TRUE(drop.host.send(bytesOf(ask)));
    drop.heard.clear();
    drop.clock.advance(25ms);
    EXPECT_TRUE(drop.heard.empty());
    drop.clock.advance(10ms);
    EXPECT_EQ(drop.heard.size(), 9U);
    Talk power("supermodified:4,baud=115200,fault=power@2");
    power.say("55 AA 04 01 19 00 19");
    power.say(ask);
    EXPECT_TRUE(power.heard.empty());
    EXPECT_FALSE(power.simulator.isOutputOn());
    power.clock.advance(200ms);
    EXPECT_EQ(power.answer(ask).size(), 9U);
}

TEST(SupermodifiedSimulator, RefusesOptionsThatItDoesNotHave)
{
    Bench bench;
    for (const std::string_view text : {"supermodified:0", "supermodified:128", "supermodified:4,dialect=D4",
             "supermodified:4,colour=red", "supermodified:4,baud=0", "supermodified:4,motor=none"}) {
        const auto simulated = simulate(bench.host, bench.clock, *SimulatedUnit::parse(text));
        ASSERT_FALSE(simulated) << text;
        EXPECT_EQ(simulated.error().fault, Fault::OutOfRange) << text;
    }
}

TEST(SupermodifiedSimulator, WhatIsWrongWithABroadcastIsQueuedUnansweredAndRefusesTheNextStop)
{
    constexpr std::string_view stop = "55 AA 04 01 1B 00 1B";
    for (const auto &[broadcast, refusal] :
        {std::pair{"55 AA 00 01 CA 00 CA", "55 AA 01 04 FA 01 14 EF"},       // halt, and it is not started
            std::pair{"55 AA 00 01 CB 00 00", "55 AA 01 04 FA 01 52 A9"}}) { // a bad LRC
        Talk talk("supermodified:4,baud=115200");
        EXPECT_TRUE(talk.answer(broadcast).empty()) << broadcast;
        EXPECT_EQ(talk.answer(stop), bytesOf(refusal)) << broadcast;
        EXPECT_EQ(talk.answer(stop), bytesOf("55 AA 01 04 1B 00 1B")) << broadcast;
    }
    Talk driven("supermodified:4,baud=115200");
    driven.say("55 AA 04 01 19 00 19");
    driven.say("55 AA 00 01 CB 00 00");
    EXPECT_TRUE(driven.simulator.isOutputOn()) << "it was not stopped";
    driven.say(stop);
    EXPECT_TRUE(driven.simulator.isOutputOn()) << "nor by the refused one";
    driven.say(stop);
    EXPECT_FALSE(driven.simulator.isOutputOn());
}

} // namespace
} // namespace mb::supermodified
