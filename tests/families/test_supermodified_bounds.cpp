// SPDX-License-Identifier: GPL-3.0-or-later
// What a node must not be asked, or not be told: questions that hang it (supermodified/README.md#hang), profiles that pass their target (supermodified/README.md#passed-target),
// steps that overflow its loop, and settings that it stores.
#include "families/supermodifiedbench.h"

#include <cmath>

namespace mb::supermodified {
namespace {

using namespace std::chrono_literals;
using mb::test::run;
using test::Bench;
using test::buffered;
using test::ramp;
using test::setPoint;
using SupermodifiedBoundsNode = test::OneNode;

/// Events of one simulated node.
struct Heard {
    explicit Heard(Simulator &unit)
        : events(unit.events().add([this](const SimulatorEvent &event) { log.push_back(event); }))
    {
    }
    [[nodiscard]] int count(std::string_view what) const
    {
        return static_cast<int>(
            std::count_if(log.begin(), log.end(), [what](const SimulatorEvent &e) { return e.what == what; }));
    }
    std::vector<SimulatorEvent> log;
    Subscription events;
};

// supermodified/README.md#hang

TEST(SupermodifiedEncoder, AStartedNodeHangsOnceItsEncoderIsAskedInTheWrongMoment)
{
    struct Row {
        std::string_view dialect;
        std::string_view question;
        bool hangs;
    };
    for (const Row &row : {Row{"D1", "55 AA 04 01 70 00 70", true}, Row{"D1", "55 AA 04 01 18 00 18", true},
             Row{"D2", "55 AA 04 01 18 00 18", true}, Row{"D2", "55 AA 04 01 70 00 70", false},
             Row{"D1", "55 AA 04 01 6F 00 6F", false}, Row{"D3", "55 AA 04 01 18 00 18", false}}) {
        Bench bench("sim:serial?bitrate=57600");
        Simulator &node = bench.add("supermodified:4,dialect=" + std::string(row.dialect));
        const Heard heard(node);
        bench.say("55 AA 04 01 19 00 19");
        ASSERT_TRUE(node.isOutputOn());
        for (int i = 0; i < 500; ++i) {
            bench.say(row.question);
            bench.clock.advance(370us);
        }
        EXPECT_EQ(heard.count("hung"), row.hangs ? 1 : 0) << row.dialect << ' ' << row.question;
        bench.say("55 AA 04 01 1B 00 1B");
        EXPECT_EQ(node.isOutputOn(), row.hangs) << "a stop is not heard any more";
    }
}

TEST(SupermodifiedEncoder, ANodeThatIsNotStartedOrTheOptionOffNeverHangs)
{
    for (const std::string option : {"", ",hang=0"}) {
        Bench bench("sim:serial?bitrate=57600");
        const Heard heard(bench.add("supermodified:4,dialect=D1" + option));
        if (!option.empty())
            bench.say("55 AA 04 01 19 00 19");
        for (int i = 0; i < 1000; ++i)
            bench.say("55 AA 04 01 70 00 70");
        EXPECT_EQ(heard.count("hung"), 0);
    }
}

TEST(SupermodifiedEncoder, ADrivenD1IsHeardForTenMinutes)
{
    Bench bench;
    Simulator &node = bench.add("supermodified:4,dialect=D1");
    const Heard heard(node);
    const auto device = bench.connect(4);
    ASSERT_TRUE(run(bench.clock, device->setRate(*device->telemetry()->find("position.absolute"), 20.0)));
    for (int minute = 0; minute < 10; ++minute) {
        ASSERT_TRUE(device->command(setPoint(Mode::Velocity, minute % 2 == 0 ? 1500.0 : -1500.0)));
        bench.sent.clear();
        bench.clock.advance(55s);
        EXPECT_EQ(bench.count(Command::GetAbsolutePosition), 0) << "minute " << minute;
        ASSERT_TRUE(device->liveness().heard) << "minute " << minute;
        device->stop();
        bench.clock.advance(5s);
        ASSERT_FALSE(node.isOutputOn()) << "minute " << minute;
        EXPECT_GT(bench.count(Command::GetAbsolutePosition), 20) << "a stopped one tells it";
    }
    EXPECT_EQ(heard.count("hung"), 0);
}

TEST(SupermodifiedEncoder, ANodeThatSomebodyElseStartedIsNotAsked)
{
    Bench bench;
    Simulator &node = bench.add("supermodified:4,dialect=D1");
    ASSERT_TRUE(bench.host.setBaudrate(57600));
    bench.say("55 AA 04 01 19 00 19");
    ASSERT_TRUE(node.isOutputOn());
    const auto device = bench.connect(4);
    bench.sent.clear();
    bench.clock.advance(60s);
    EXPECT_EQ(bench.count(Command::GetAbsolutePosition), 0);
    EXPECT_TRUE(device->liveness().heard);
    device->stop();
    bench.clock.advance(3s);
    EXPECT_FALSE(node.isOutputOn());
    EXPECT_GT(bench.count(Command::GetAbsolutePosition), 0);
}

TEST(SupermodifiedEncoder, AStopGoesBeforeEveryStartOfANodeThatMayBeStarted)
{
    for (int i = 0; i < 200; ++i) { // each in another moment of the loop
        Bench bench;
        Simulator &node = bench.add("supermodified:4,dialect=D1");
        const Heard heard(node);
        ASSERT_TRUE(bench.host.setBaudrate(57600));
        bench.say("55 AA 04 01 19 00 19");
        ASSERT_TRUE(node.isOutputOn());
        const auto device = bench.connect(4);
        bench.clock.advance(13us * i);
        ASSERT_TRUE(device->command(setPoint(Mode::Position, 0.0)));
        bench.clock.advance(300ms);
        ASSERT_EQ(heard.count("hung"), 0) << i;
        ASSERT_TRUE(node.isOutputOn());
        if (i > 0)
            continue;
        const auto frames = bench.framesSent();
        const auto start = std::find_if(frames.begin() + 1, frames.end(), [](auto &f) { return f.is(Command::Start); });
        ASSERT_NE(start, frames.end());
        EXPECT_NE(std::find_if(frames.begin() + 1, start, [](auto &f) { return f.is(Command::Stop); }), start);
    }
}

TEST(SupermodifiedEncoder, AStartWhoseAnswerIsLostIsNotRepeatedWithoutAStop)
{
    Bench bench;
    Simulator &node = bench.add("supermodified:4,dialect=D1");
    const auto device = bench.connect(4);
    bench.clock.advance(200ms);
    bench.sent.clear();
    ASSERT_TRUE(device->command(setPoint(Mode::Position, 0.0)));
    ASSERT_TRUE(bench.clock.runUntil([&] { return bench.count(Command::Start) == 1; }, 200ms));
    ASSERT_TRUE(bench.clock.runUntil([&] { return node.isOutputOn(); }, 20ms));
    bench.line.setLoss(1.0);
    bench.clock.advance(20ms);
    bench.line.setLoss(0.0);
    bench.clock.advance(500ms);
    EXPECT_TRUE(node.isOutputOn());
    bool stopped = true;
    for (const Frame &frame : bench.framesSent()) {
        if (frame.is(Command::Start)) {
            EXPECT_TRUE(stopped);
            stopped = false;
        }
        stopped |= frame.is(Command::Stop);
    }
    EXPECT_GE(bench.count(Command::Start), 2);
}

// supermodified/README.md#passed-target

TEST(SupermodifiedProfile, AFastOnePassesItsTargetInD1AndD2AndIsStopped)
{
    int passed = 0;
    for (const std::string dialect : {"D1", "D2", "D3"}) {
        for (const double target : {3000.0, -3000.0, 3001.0, 4000.0, 5003.0, 7777.0}) {
            Bench bench;
            Simulator &node = bench.add("supermodified:4,motor=cim,dialect=" + dialect);
            const auto device = bench.connect(4);
            SetPointStream stream(*device, bench.clock);
            ASSERT_TRUE(stream.start(ramp(target, 6000.0, 40000.0), 60s));
            double farthest = 0.0;
            for (int i = 0; i < 400; ++i) {
                bench.clock.advance(10ms);
                farthest = std::max(farthest, node.position() / std::copysign(1.0, target));
            }
            const double limit = std::abs(target) + 6000.0 * 6000.0 / 80000.0;
            EXPECT_LT(farthest, limit + 400.0)
                << dialect << ' ' << target << ": it coasts, and positions come 50 times a second";
            if (stream.isRunning())
                continue;
            ++passed;
            EXPECT_NE(dialect, "D3");
            EXPECT_EQ(stream.end(), SetPointStream::End::Refused);
            EXPECT_NE(stream.reason().english().find("passed its target"), std::string::npos) << stream.reason();
            EXPECT_FALSE(node.isOutputOn());
        }
    }
    EXPECT_GT(passed, 0) << "the simulated firmware has the fault of the real one";
}

TEST(SupermodifiedProfile, AShortRelativeOneMayPassItsTargetByHalfItsWay)
{
    Bench bench;
    Simulator &node = bench.add("supermodified:4,motor=25d");
    const auto device = bench.connect(4);
    ASSERT_TRUE(device->command(ramp(20000.0, 2400.0, 40000.0)));
    bench.clock.advance(12s);
    SetPoint move = ramp(600.0, 2400.0, 1000.0); // could stop within 2880 counts, but never gets as fast
    move.relative = true;
    move.order = 1;
    ASSERT_TRUE(device->command(move));
    bench.clock.advance(5s);
    ASSERT_NEAR(node.position(), 20600.0, 60.0);
    for (double torque = 0.0; torque > -5.0 && node.isOutputOn(); torque -= 0.005) { // somebody pulls at it
        node.disturb("load-torque", torque);
        bench.clock.advance(50ms);
        ASSERT_LT(node.position(), 20600.0 + 300.0 + 700.0) << "positions come 50 times a second";
    }
    EXPECT_FALSE(node.isOutputOn());
    EXPECT_GT(node.position(), 20600.0 + 300.0);
    EXPECT_NE(device->command(ramp(0.0, 2400.0, 1000.0)).error().text().find("passed its target"), std::string::npos);
}

TEST(SupermodifiedProfile, ARelativeOneCountsFromWhereItBegan)
{
    for (const double way : {1500.0, -1500.0}) {
        Bench bench;
        Simulator &node = bench.add("supermodified:4,motor=cim");
        const auto device = bench.connect(4);
        ASSERT_TRUE(device->command(ramp(20000.0, 2400.0, 40000.0)));
        bench.clock.advance(12s);
        ASSERT_NEAR(node.position(), 20000.0, 50.0);
        SetPoint move = ramp(way, 800.0, 10000.0);
        move.relative = true;
        move.order = 1;
        ASSERT_TRUE(device->command(move));
        bench.clock.advance(5s);
        EXPECT_TRUE(node.isOutputOn()) << "it arrived, and is not taken for one that passed";
        EXPECT_NEAR(node.position(), 20000.0 + way, 50.0);
    }
    int passed = 0;
    for (const double way : {3000.0, -3000.0, 3001.0, 4000.0, 5003.0, 7777.0}) {
        Bench bench;
        Simulator &node = bench.add("supermodified:4,motor=cim");
        const auto device = bench.connect(4);
        ASSERT_TRUE(device->command(ramp(20000.0, 2400.0, 40000.0)));
        bench.clock.advance(12s);
        SetPoint move = ramp(way, 6000.0, 40000.0);
        move.relative = true;
        move.order = 1;
        ASSERT_TRUE(device->command(move));
        double farthest = 0.0;
        for (int i = 0; i < 400; ++i) {
            bench.clock.advance(10ms);
            farthest = std::max(farthest, (node.position() - 20000.0) / std::copysign(1.0, way));
        }
        EXPECT_LT(farthest, std::abs(way) + 6000.0 * 6000.0 / 80000.0 + 400.0) << way;
        passed += node.isOutputOn() ? 0 : 1;
    }
    EXPECT_GT(passed, 0) << "the simulated firmware has the fault of the real one";
}

TEST(SupermodifiedProfile, ASlowOneArrives)
{
    for (const std::string dialect : {"D1", "D2"}) {
        for (const double velocity : {300.0, 800.0, 1700.0, 2500.0}) {
            Bench bench;
            Simulator &node = bench.add("supermodified:4,dialect=" + dialect);
            const auto device = bench.connect(4);
            ASSERT_TRUE(device->command(ramp(3000.0, velocity, 10000.0)));
            bench.clock.advance(13s);
            EXPECT_NEAR(node.position(), 3000.0, 20.0) << dialect << ' ' << velocity;
            EXPECT_TRUE(node.isOutputOn());
        }
    }
}

TEST_F(SupermodifiedBoundsNode, WhatIsFastOrStoredIsSaidBeforehand)
{
    EXPECT_EQ(device->caution(setPoint(Mode::RampPosition, 100.0)), "");
    EXPECT_EQ(device->caution(ramp(100.0, 800.0, 800.0)), "") << "these are in it already";
    const std::string both = device->caution(ramp(100.0, 2501.0, 800.0)).english();
    EXPECT_NE(both.find("profile.velocity becomes 2501, it was 800"), std::string::npos) << both;
    EXPECT_NE(both.find("may pass the target"), std::string::npos) << both;
    EXPECT_EQ(device->caution(setPoint(Mode::Velocity, 3000.0)), "");
    const std::string slower = device->caution(ramp(100.0, 2500.0, 800.0)).english();
    EXPECT_NE(slower.find("profile.velocity becomes 2500, it was 800"), std::string::npos) << slower;
    EXPECT_EQ(slower.find("may pass the target"), std::string::npos) << "not above 2500";
    const std::string steeper = device->caution(ramp(100.0, 800.0, 900.4)).english();
    EXPECT_EQ(steeper, "profile.acceleration becomes 900, it was 800: the device stores it");
}

TEST_F(SupermodifiedBoundsNode, AProfileIsWrittenOnceAndTheTableFollows)
{
    for (int i = 0; i < 5; ++i) {
        ASSERT_TRUE(device->command(ramp(100.0 * i, 1200.0, 3000.0)));
        bench.clock.advance(300ms);
        device->stop();
        bench.clock.advance(100ms);
    }
    EXPECT_EQ(bench.count(Command::ProfileVelocity), 1) << "each write costs a cycle of the EEPROM";
    EXPECT_EQ(bench.count(Command::ProfileAcceleration), 1);
    EXPECT_EQ(device->parameters().entry(Bench::index("profile.velocity")).raw, 1200);
    EXPECT_EQ(device->parameters().entry(Bench::index("profile.acceleration")).raw, 3000);
}

TEST_F(SupermodifiedBoundsNode, AProfileThatWasWrittenSinceStaysAfterAQuestionWithoutAnswer)
{
    ASSERT_TRUE(device->command(ramp(500.0, 1200.0, 3000.0)));
    bench.clock.advance(1s);
    ASSERT_TRUE(run(bench.clock, device->write(Bench::index("profile.velocity"), 900)));
    bench.sent.clear();
    bench.line.setLoss(1.0);
    bench.clock.advance(60ms);
    bench.line.setLoss(0.0);
    bench.clock.advance(1s);
    EXPECT_EQ(bench.count(Command::MoveProfiledAbsolute), 1) << "the move is sent once more";
    EXPECT_EQ(bench.count(Command::ProfileVelocity), 0);
    EXPECT_EQ(device->parameters().entry(Bench::index("profile.velocity")).raw, 900);
}

// Steps

TEST_F(SupermodifiedBoundsNode, AStepThatOverflowsIsRefusedAlthoughNobodyReadP)
{
    bench.clock.advance(100ms);
    bench.sent.clear();
    const auto refused = device->command(setPoint(Mode::Position, 3e6));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().fault, Fault::OutOfRange);
    EXPECT_EQ(bench.count(Command::Start), 0);
    ASSERT_TRUE(run(bench.clock, device->write(Bench::index("gain.p"), 2000)));
    EXPECT_EQ(device->command(setPoint(Mode::Position, 1.2e6)).error().fault, Fault::OutOfRange) << "with the new P";
}

TEST_F(SupermodifiedBoundsNode, AStepThatOverflowsFromWhereTheMotorIsByThenIsNotSent)
{
    bench.clock.advance(100ms);
    ASSERT_TRUE(run(bench.clock, device->write(Bench::index("gain.p"), 65535)));
    ASSERT_TRUE(device->command(setPoint(Mode::Velocity, 8000.0)));
    bench.clock.advance(8s);
    ASSERT_GT(node.position(), 33000.0);
    bench.sent.clear();
    EXPECT_FALSE(device->command(setPoint(Mode::Position, 0.0))) << "|P·e| must stay below 2^31";
    EXPECT_EQ(bench.count(Command::MoveAbsolute), 0);
}

TEST(SupermodifiedSteps, WithoutPNoStepIsTaken)
{
    Bench bench;
    bench.add("supermodified:4");
    Identity identity;
    identity.family = "supermodified";
    identity.address = 4;
    identity.dialect = "D1";
    ASSERT_TRUE(bench.host.setBaudrate(57600));
    const auto device = open(bench.host, bench.clock, identity);
    bench.clock.advance(500ms);
    EXPECT_EQ(device->command(setPoint(Mode::Position, 10.0)).error().fault, Fault::Unsafe);
    EXPECT_EQ(device->command(setPoint(Mode::RampPosition, 10.0)).error().fault, Fault::Unsafe);
    ASSERT_TRUE(run(bench.clock, device->read(Bench::index("gain.p"))));
    EXPECT_TRUE(device->command(setPoint(Mode::Position, 10.0)));
}

TEST(SupermodifiedSteps, AVelocityIsRefusedWhereAMotorThatDoesNotReachItOverflowsItsLoop)
{
    for (const Mode mode : {Mode::Velocity, Mode::RampVelocity}) {
        Bench bench;
        Simulator &node = bench.add("supermodified:4,dialect=D2,gains=default");
        const auto device = bench.connect(4);
        bench.clock.advance(100ms);
        bench.sent.clear();
        for (const SetPoint &order : {setPoint(mode, 270000.0), buffered(setPoint(mode, -270000.0))}) {
            const auto refused = device->command(order);
            ASSERT_FALSE(refused) << "4000 times 540000 wraps";
            EXPECT_EQ(refused.error().fault, Fault::OutOfRange);
            EXPECT_EQ(refused.error().remedy.english(), "at most 268434 counts/s with its P");
        }
        bench.clock.advance(100ms);
        EXPECT_EQ(bench.count(Command::Stop) + bench.count(Command::Start), 0);
        ASSERT_TRUE(device->command(setPoint(mode, 260000.0)));
        for (int i = 0; i < 300; ++i) {
            bench.clock.advance(10ms);
            ASSERT_GE(node.speed(), 0.0) << "full output is the same way all the time";
        }
    }
}

// The current limit (supermodified/README.md#settings)

TEST_F(SupermodifiedBoundsNode, ALimitThatIsOwedIsPutBackThoughTheNodeIsReadAnewOrTheProgramEndedMeanwhile)
{
    const auto limit = Bench::index("limit.current");
    const auto duration = Bench::index("limit.current.duration");
    for (const bool ended : {false, true}) {
        for (const std::int64_t next : {7000, 8000}) {
            ASSERT_TRUE(run(bench.clock, device->write(limit, 900)));
            bench.sent.clear();
            {
                const Subscription cut = bench.host.traffic().add([&](const Traffic &traffic) {
                    const auto frames = test::framesIn({traffic.bytes.begin(), traffic.bytes.end()});
                    if (traffic.direction == Direction::Received && !frames.empty()
                        && frames.back().is(Command::CurrentLimitDuration))
                        bench.line.setLoss(1.0);
                });
                EXPECT_FALSE(run(bench.clock, device->write(duration, 7000)));
                EXPECT_GT(bench.count(Command::CurrentLimit), 1) << "it tried";
                bench.line.setLoss(0.0);
            }
            bench.clock.advance(1s);
            ASSERT_FALSE(device->liveness().restarted);
            if (ended) {
                const DeviceProfile kept = device->knowledge().profile();
                device = bench.connect(4);
                device->knowledge().setProfile(kept);
            } else {
                ASSERT_TRUE(run(bench.clock, device->refresh()));
            }
            ASSERT_EQ(run(bench.clock, device->read(limit)).value_or(0), 7000) << "it says the duration";
            ASSERT_TRUE(run(bench.clock, device->write(duration, next)));
            node.setPowered(false);
            bench.clock.advance(1s);
            node.setPowered(true);
            bench.clock.advance(2s);
            EXPECT_EQ(run(bench.clock, device->read(limit)).value_or(0), 900);
            EXPECT_EQ(run(bench.clock, device->read(duration)).value_or(0), next);
        }
    }
}

TEST_F(SupermodifiedBoundsNode, ALimitThatIsOwedNoMoreIsNotPutBackOverTheOneThatTheNodeHas)
{
    DeviceProfile kept;
    kept.counters = {{"limit.current.owed", 900}, {"limit.current.owed.duration", 7000}};
    device->knowledge().setProfile(kept);
    ASSERT_TRUE(run(bench.clock, device->write(Bench::index("limit.current.duration"), 8000)));
    EXPECT_EQ(run(bench.clock, device->read(Bench::index("limit.current"))).value_or(0), 5000);
}

} // namespace
} // namespace mb::supermodified
