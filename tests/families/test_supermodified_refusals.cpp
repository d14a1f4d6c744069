// SPDX-License-Identifier: GPL-3.0-or-later
// A move that is refused, a motor that switched itself off, a stop on a port that somebody else fills.
#include "families/supermodifiedbench.h"

#include <algorithm>

namespace mb::supermodified {
namespace {

using namespace std::chrono_literals;
using test::Bench;
using test::ramp;
using test::setPoint;
using SupermodifiedRefusals = test::OneNode;

/// The answer to the next frame with this command is an error.
Subscription refuseNext(Bench &bench, Simulator &node, Command command, std::uint8_t code)
{
    return bench.host.traffic().add([&node, command, code, done = false](const Traffic &traffic) mutable {
        const auto frames = test::framesIn({traffic.bytes.begin(), traffic.bytes.end()});
        if (done || traffic.direction != Direction::Sent || frames.empty() || !frames.back().is(command))
            return;
        done = true;
        node.disturb("error", code);
    });
}

TEST_F(SupermodifiedRefusals, AMoveThatIsItselfRefusedWasNotDoneAndIsSentAgain)
{
    order(setPoint(Mode::Position, 0.0), 300ms);
    SetPoint step = setPoint(Mode::Position, 500.0);
    step.relative = true;
    step.order = 1;
    bench.sent.clear();
    const Subscription refusing = refuseNext(bench, node, Command::MoveRelative, 0x44);
    ASSERT_TRUE(device->command(step));
    bench.clock.advance(800ms);
    EXPECT_EQ(bench.count(Command::MoveRelative), 2);
    EXPECT_NEAR(node.position(), 500.0, 20.0);
    EXPECT_TRUE(device->liveness().moving) << "it holds its place";
}

TEST_F(SupermodifiedRefusals, AMoveThatIsRefusedBecauseTheMotorIsNotStartedEndsTheMotion)
{
    order(setPoint(Mode::Velocity, 100.0), 300ms);
    ASSERT_TRUE(device->liveness().moving);
    ASSERT_TRUE(Line::of(bench.host, bench.clock)->driven().any());
    bench.sent.clear();
    const Subscription refusing = refuseNext(bench, node, Command::MoveVelocity, code::invalidForState);
    ASSERT_TRUE(device->command(setPoint(Mode::Velocity, 200.0)));
    bench.clock.advance(30ms);
    EXPECT_EQ(bench.count(Command::MoveVelocity), 1) << "not sent again";
    EXPECT_FALSE(Line::of(bench.host, bench.clock)->driven().any());
    const auto again = device->command(setPoint(Mode::Velocity, 300.0));
    ASSERT_FALSE(again);
    EXPECT_NE(again.error().text().find("not started"), std::string::npos) << again.error().text();
}

TEST_F(SupermodifiedRefusals, AMoveThatIsRefusedEachTimeIsGivenUpAfterFour)
{
    order(setPoint(Mode::Velocity, 100.0), 300ms);
    bench.sent.clear();
    const Subscription refusing = bench.host.traffic().add([this](const Traffic &traffic) {
        const auto frames = test::framesIn({traffic.bytes.begin(), traffic.bytes.end()});
        if (traffic.direction == Direction::Sent && !frames.empty() && frames.back().is(Command::MoveVelocity))
            node.disturb("error", 0x44);
    });
    ASSERT_TRUE(device->command(setPoint(Mode::Velocity, 200.0)));
    bench.clock.advance(1s);
    EXPECT_EQ(bench.count(Command::MoveVelocity), 4);
    const auto again = device->command(setPoint(Mode::Velocity, 300.0));
    ASSERT_FALSE(again);
    EXPECT_NE(again.error().text().find("refused"), std::string::npos) << again.error().text();
}

TEST_F(SupermodifiedRefusals, AReleaseOfBufferedMovesThatStillWaitsIsNotSentAfterAStop)
{
    SetPoint move = setPoint(Mode::Position, 1000.0);
    move.buffered = true;
    order(move, 500ms);
    bench.sent.clear();
    ASSERT_TRUE(bench.clock.runUntil([this] { return !bench.sent.empty(); }, 1s)) << "the line is busy";
    ASSERT_TRUE(device->releaseMoves());
    device->stop();
    bench.clock.advance(500ms);
    EXPECT_GE(bench.count(Command::Stop), 1);
    EXPECT_EQ(bench.count(Command::DoMove), 0);
    EXPECT_NEAR(node.position(), 0.0, 5.0);
}

TEST_F(SupermodifiedRefusals, ABufferedMoveOfWhichNobodyHeardIsNotReleased)
{
    order(setPoint(Mode::Position, 0.0), 300ms);
    SetPoint move = setPoint(Mode::Position, 1000.0);
    move.buffered = true;
    bench.line.setLoss(1.0);
    order(move, 3s);
    bench.line.setLoss(0.0);
    bench.clock.advance(500ms);
    bench.sent.clear();
    const auto released = device->releaseMoves();
    ASSERT_FALSE(released);
    EXPECT_NE(released.error().text().find("does not answer"), std::string::npos) << released.error().text();
    bench.clock.advance(500ms);
    EXPECT_EQ(bench.count(Command::DoMove), 0);
}

TEST_F(SupermodifiedRefusals, ANodeThatLosesItsSupplyAfterItsMotionFailedHasRestarted)
{
    order(setPoint(Mode::Velocity, 500.0), 1s);
    bench.line.setLoss(1.0);
    order(setPoint(Mode::Velocity, 600.0), 3s);
    ASSERT_FALSE(device->command(setPoint(Mode::Velocity, 700.0)));
    node.setPowered(false);
    bench.clock.advance(100ms);
    node.setPowered(true);
    bench.line.setLoss(0.0);
    bench.clock.advance(1s);
    EXPECT_TRUE(device->liveness().restarted);
}

TEST(SupermodifiedRestarts, BetweenTwoQuestionsEndTheStream)
{
    for (const SetPoint &move :
        {setPoint(Mode::Velocity, 200.0), setPoint(Mode::Position, 3000.0), ramp(3000.0, 2000.0, 4000.0)}) {
        for (int moment = 0; moment < 12; ++moment) {
            Bench bench;
            Simulator &node = bench.add("supermodified:4");
            const auto device = bench.connect(4);
            bench.clock.advance(200ms);
            SetPointStream stream(*device, bench.clock);
            ASSERT_TRUE(stream.start(move, 60s));
            bench.clock.advance(2s + moment * 1ms);
            ASSERT_TRUE(stream.isRunning());
            node.setPowered(false);
            node.setPowered(true);
            bench.clock.advance(500ms);
            EXPECT_FALSE(stream.isRunning()) << toString(move.mode) << ' ' << moment;
        }
    }
}

TEST_F(SupermodifiedRefusals, AMotorThatStalledIsNotDrivenAnyMore)
{
    order(setPoint(Mode::Velocity, 100.0), 300ms);
    ASSERT_TRUE(Line::of(bench.host, bench.clock)->driven().any());
    node.disturb("error", code::motorStalled);
    bench.clock.advance(100ms);
    EXPECT_FALSE(device->liveness().faults.empty());
    EXPECT_FALSE(Line::of(bench.host, bench.clock)->driven().any());
    EXPECT_FALSE(device->liveness().mode) << "nothing is in force";
}

TEST_F(SupermodifiedRefusals, WhatSwitchedAMotorOffIsOverOnceItIsStartedAgain)
{
    order(setPoint(Mode::Velocity, 100.0), 300ms);
    node.disturb("error", code::motorStalled);
    bench.clock.advance(100ms);
    device->stop();
    bench.clock.advance(100ms);
    EXPECT_EQ(device->liveness().faults, std::vector<std::string>{"motor_stalled"}) << "it stands until then";
    order(setPoint(Mode::Velocity, 100.0), 300ms);
    EXPECT_TRUE(node.isOutputOn());
    EXPECT_TRUE(device->liveness().faults.empty());
    const auto faults = mb::test::run(bench.clock, device->readFaults());
    ASSERT_TRUE(faults);
    const auto stalled = std::ranges::find(*faults, "motor_stalled", &FaultRecord::key);
    ASSERT_NE(stalled, faults->end());
    EXPECT_FALSE(stalled->active);
    EXPECT_TRUE(stalled->sticky) << "that it happened is kept";
}

TEST_F(SupermodifiedRefusals, AStopPassesWhatSomebodyElseHasQueuedOnThePort)
{
    ASSERT_TRUE(device->command(setPoint(Mode::Duty, 0.0)) || device->command(setPoint(Mode::Velocity, 500.0)));
    bench.clock.advance(1s);
    ASSERT_TRUE(node.isOutputOn());
    VirtualSerialLink ear(*LinkAddress::parse("sim:serial"), bench.line);
    ASSERT_TRUE(ear.open());
    ASSERT_TRUE(ear.setBaudrate(bench.host.baudrate()));
    std::vector<std::uint8_t> wire;
    const Subscription hearing = ear.received().add(
        [&wire](std::span<const std::uint8_t> bytes) { wire.insert(wire.end(), bytes.begin(), bytes.end()); });
    const std::vector<std::uint8_t> filler(200, 0xFF);
    for (int i = 0; i < 3; ++i)
        ASSERT_TRUE(bench.host.send(filler));
    device->stop();
    const auto stop = uartBytes(request(4, usualHostId, Command::Stop));
    const auto found = [&] { return std::search(wire.begin(), wire.end(), stop.begin(), stop.end()); };
    ASSERT_TRUE(bench.clock.runUntil([&] { return found() != wire.end(); }, 2s));
    EXPECT_LT(std::count(wire.begin(), found(), 0xFF), 300) << "two of three blocks are behind it";
}

TEST_F(SupermodifiedRefusals, AStartThatIsRefusedEachTimeIsGivenUpAfterFour)
{
    const Subscription refusing = bench.host.traffic().add([this](const Traffic &traffic) {
        const auto frames = test::framesIn({traffic.bytes.begin(), traffic.bytes.end()});
        if (traffic.direction == Direction::Sent && !frames.empty() && frames.back().is(Command::Start))
            node.disturb("error", 0x44);
    });
    bench.sent.clear();
    ASSERT_TRUE(device->command(setPoint(Mode::Velocity, 100.0)));
    bench.clock.advance(1s);
    EXPECT_EQ(bench.count(Command::Start), 4);
    EXPECT_FALSE(node.isOutputOn());
    EXPECT_FALSE(device->command(setPoint(Mode::Velocity, 200.0)));
}

TEST_F(SupermodifiedRefusals, ACodeWithoutANameIsToldByItsNumber)
{
    node.disturb("error", 0x7F);
    bench.clock.advance(500ms);
    node.disturb("error", 0x7F);
    bench.clock.advance(500ms);
    const auto faults = mb::test::run(bench.clock, device->readFaults());
    ASSERT_TRUE(faults);
    ASSERT_EQ(faults->size(), codeNames().size() + 1);
    EXPECT_EQ(faults->back().key, "code_7f");
    EXPECT_EQ(faults->back().count, 2);
}

} // namespace
} // namespace mb::supermodified
