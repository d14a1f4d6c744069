// SPDX-License-Identifier: GPL-3.0-or-later
// Orders that meet something else: a stop, an answer that is lost, a move that waits, a reset of the position.
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
using SupermodifiedOrders = test::OneNode;

// Of another master

TEST(SupermodifiedForeignStop, EndsAMotionAndIsNoOrderToANodeThatRests)
{
    for (const std::string_view stop : {"55 AA 04 02 1B 00 1B", "55 AA 00 02 CB 00 CB"}) {
        Bench bench;
        const Simulator &node = bench.add("supermodified:4,dialect=D3");
        const auto device = bench.connect(4);
        VirtualSerialLink other(*LinkAddress::parse("sim:serial"), bench.line);
        ASSERT_TRUE(other.open());
        ASSERT_TRUE(other.setBaudrate(bench.host.baudrate()));
        const auto tellUntil = [&](auto isDone) { // some collide with our own questions
            for (int i = 0; i < 40 && !isDone(); ++i) {
                EXPECT_TRUE(other.send(test::bytesOf(stop)));
                bench.clock.advance(7300us);
            }
        };
        bench.clock.advance(99ms); // between two questions of our own
        tellUntil([i = 0]() mutable { return i++ == 3; });
        EXPECT_FALSE(device->liveness().foreignMaster) << stop;
        bench.clock.advance(2s);
        ASSERT_TRUE(device->liveness().heard);
        SetPointStream stream(*device, bench.clock);
        ASSERT_TRUE(stream.start(setPoint(Mode::Position, 0.0), 60s));
        bench.clock.advance(500ms);
        ASSERT_TRUE(node.isOutputOn()) << stream.reason().english();
        bench.sent.clear();
        tellUntil([&] { return !stream.isRunning(); });
        EXPECT_EQ(stream.end(), SetPointStream::End::ForeignMaster) << stop;
        bench.clock.advance(2s);
        EXPECT_FALSE(node.isOutputOn());
        EXPECT_EQ(bench.count(Command::Start), 0) << stop;
        EXPECT_FALSE(device->liveness().moving);
    }
}

// A Start of which nobody knows whether it was done (supermodified/README.md#start)

TEST(SupermodifiedStart, AStopWhileItIsOnTheWireLosesNoPosition)
{
    for (int moment = 0; moment < 25; ++moment) {
        Bench bench;
        Simulator &node = bench.add("supermodified:4");
        const auto device = bench.connect(4);
        const auto channel = *device->telemetry()->find("position");
        const auto position = [&] { return device->telemetry()->latest(channel)->value; };
        ASSERT_TRUE(device->command(setPoint(Mode::Position, 3000.0)));
        bench.clock.advance(2s);
        device->stop();
        bench.clock.advance(200ms);
        const double rest = position();
        ASSERT_NEAR(rest, 3000.0, 30.0);
        bench.sent.clear();
        ASSERT_TRUE(device->command(setPoint(Mode::Position, rest)));
        ASSERT_TRUE(bench.clock.runUntil([&] { return bench.count(Command::Start) == 1; }, 200ms));
        bench.clock.advance(200us * moment);
        device->stop();
        for (int i = 0; i < 20; ++i) {
            bench.clock.advance(10ms);
            ASSERT_NEAR(position(), rest, 30.0) << moment;
        }
        EXPECT_FALSE(device->liveness().restarted) << moment;
        ASSERT_TRUE(device->command(setPoint(Mode::Position, rest)));
        bench.clock.advance(1s);
        EXPECT_NEAR(position(), rest, 30.0) << moment;
        EXPECT_NEAR(node.position(), rest, 30.0) << moment << ": it was told to stay";
    }
}

TEST_F(SupermodifiedOrders, AStartWhoseAnswerIsLostLosesNoPosition)
{
    order(setPoint(Mode::Position, 3000.0), 2s);
    device->stop();
    bench.clock.advance(200ms);
    const double rest = position();
    bench.sent.clear();
    ASSERT_TRUE(device->command(setPoint(Mode::Position, rest)));
    ASSERT_TRUE(bench.clock.runUntil([&] { return bench.count(Command::Start) == 1; }, 200ms));
    ASSERT_TRUE(bench.clock.runUntil([&] { return node.isOutputOn(); }, 20ms));
    bench.line.setLoss(1.0);
    bench.clock.advance(20ms);
    bench.line.setLoss(0.0);
    bench.clock.advance(1s);
    EXPECT_GE(bench.count(Command::Start), 2);
    EXPECT_NEAR(position(), rest, 30.0);
    EXPECT_NEAR(node.position(), rest, 30.0);
    EXPECT_FALSE(device->liveness().restarted);
}

// Moves that wait

TEST(SupermodifiedRelease, AMoveThatAnotherNodeKeepsIsCheckedOnceMoreToo)
{
    Bench bench;
    bench.add("supermodified:4");
    Simulator &other = bench.add("supermodified:5,dialect=D1");
    const auto lead = bench.connect(4);
    const auto member = bench.connect(5);
    bench.clock.advance(100ms);
    ASSERT_TRUE(run(bench.clock, member->write(Bench::index("gain.p"), 65535)));
    ASSERT_TRUE(member->command(setPoint(Mode::Position, 20000.0)));
    bench.clock.advance(4s);
    ASSERT_NEAR(other.position(), 20000.0, 100.0);
    ASSERT_TRUE(member->command(setPoint(Mode::Position, 0.0)));
    ASSERT_TRUE(member->command(buffered(setPoint(Mode::Position, 50000.0))));
    ASSERT_TRUE(lead->command(buffered(setPoint(Mode::Position, 100.0))));
    bench.clock.advance(4s);
    ASSERT_NEAR(other.position(), 0.0, 100.0);
    bench.sent.clear();
    const auto released = lead->releaseMoves();
    ASSERT_FALSE(released) << "a step of 50000 wraps";
    EXPECT_EQ(released.error().fault, Fault::OutOfRange);
    bench.clock.advance(100ms);
    EXPECT_EQ(bench.count(Command::DoMove), 0);
}

TEST(SupermodifiedRelease, AMoveThatAnotherNodeHasNotAcknowledgedYetIsNotLeftBehind)
{
    Bench bench;
    bench.add("supermodified:4");
    bench.add("supermodified:5");
    const auto lead = bench.connect(4);
    const auto member = bench.connect(5);
    ASSERT_TRUE(lead->command(buffered(setPoint(Mode::Position, 100.0))));
    bench.clock.advance(500ms);
    ASSERT_TRUE(member->command(buffered(setPoint(Mode::Position, 100.0))));
    EXPECT_FALSE(lead->releaseMoves());
    bench.clock.advance(500ms);
    EXPECT_TRUE(lead->releaseMoves());
}

/// Within four seconds, in the direction of the target.
double farthestTowards(double target, Bench &bench, const Simulator &node)
{
    double farthest = 0.0;
    for (int i = 0; i < 400; ++i) {
        bench.clock.advance(10ms);
        farthest = std::max(farthest, node.position() / std::copysign(1.0, target));
    }
    return farthest;
}

TEST(SupermodifiedRelease, AProfiledMoveIsWatchedAlthoughAnotherWaits)
{
    int passed = 0;
    for (const double target : {3000.0, -3000.0, 3001.0, 4000.0, 5003.0, 7777.0}) {
        Bench bench;
        Simulator &node = bench.add("supermodified:4,motor=cim,dialect=D1");
        const auto device = bench.connect(4);
        ASSERT_TRUE(device->command(ramp(target, 6000.0, 40000.0)));
        bench.clock.advance(200ms);
        ASSERT_TRUE(device->command(buffered(setPoint(Mode::Position, 0.0))));
        const double farthest = farthestTowards(target, bench, node);
        EXPECT_LT(farthest, std::abs(target) + 850.0) << target;
        passed += node.isOutputOn() ? 0 : 1;
    }
    EXPECT_GT(passed, 0) << "the simulated firmware has the fault of the real one";
}

TEST(SupermodifiedRelease, AProfiledMoveThatWaitedIsWatchedFromItsReleaseOfAnotherNodeToo)
{
    int passed = 0;
    for (const double target : {3000.0, -3000.0, 3001.0, 4000.0, 5003.0, 7777.0}) {
        Bench bench;
        bench.add("supermodified:4");
        Simulator &node = bench.add("supermodified:5,motor=cim,dialect=D1");
        const auto lead = bench.connect(4);
        const auto member = bench.connect(5);
        ASSERT_TRUE(lead->command(buffered(setPoint(Mode::Position, 100.0))));
        ASSERT_TRUE(member->command(buffered(ramp(target, 6000.0, 40000.0))));
        bench.clock.advance(500ms);
        ASSERT_TRUE(lead->releaseMoves());
        const double farthest = farthestTowards(target, bench, node);
        EXPECT_LT(farthest, std::abs(target) + 850.0) << target;
        passed += node.isOutputOn() ? 0 : 1;
    }
    EXPECT_GT(passed, 0) << "the simulated firmware has the fault of the real one";
}

TEST(SupermodifiedRelease, ThatAStopOvertookHasBegunNothing)
{
    Bench bench;
    bench.add("supermodified:4");
    bench.add("supermodified:5");
    const auto lead = bench.connect(4);
    const auto member = bench.connect(5);
    for (Device *one : {lead.get(), member.get()})
        ASSERT_TRUE(one->command(buffered(setPoint(Mode::Velocity, 300.0))));
    bench.clock.advance(500ms);
    bench.line.setLoss(1.0);
    bench.sent.clear();
    ASSERT_TRUE(bench.clock.runUntil([&] { return !bench.sent.empty(); }, 1s)) << "a question is under way";
    ASSERT_TRUE(lead->releaseMoves());
    lead->stop();
    bench.line.setLoss(0.0);
    bench.clock.advance(500ms);
    ASSERT_EQ(bench.count(Command::DoMove), 0);
    EXPECT_NE(member->liveness().mode, Mode::Velocity);
    const auto released = member->releaseMoves();
    ASSERT_FALSE(released) << "the other node still has its own";
    EXPECT_EQ(released.error().fault, Fault::Unsafe);
    ASSERT_TRUE(lead->command(buffered(setPoint(Mode::Velocity, 100.0))));
    bench.clock.advance(500ms);
    ASSERT_TRUE(member->releaseMoves());
    bench.clock.advance(100ms);
    EXPECT_EQ(member->liveness().mode, Mode::Velocity);
}

TEST(SupermodifiedRelease, BeginsWhatTheNodeKeepsAlthoughAnotherIsOrderedBehindIt)
{
    Bench bench;
    bench.add("supermodified:4");
    bench.add("supermodified:5");
    const auto lead = bench.connect(4);
    const auto member = bench.connect(5);
    for (Device *one : {lead.get(), member.get()})
        ASSERT_TRUE(one->command(buffered(setPoint(Mode::Velocity, 300.0))));
    bench.clock.advance(500ms);
    bench.sent.clear();
    ASSERT_TRUE(bench.clock.runUntil([&] { return !bench.sent.empty(); }, 1s)) << "a question is under way";
    ASSERT_TRUE(lead->releaseMoves());
    ASSERT_TRUE(member->command(buffered(ramp(5000.0, 800.0, 800.0))));
    bench.clock.advance(500ms);
    ASSERT_EQ(bench.count(Command::DoMove), 3) << "to both, then to each";
    EXPECT_EQ(member->liveness().mode, Mode::Velocity);
    EXPECT_EQ(member->gate().kept().state, KeptMove::State::Acknowledged) << "the one behind it";
}

SetPoint by(double distance)
{
    SetPoint move = setPoint(Mode::Position, distance);
    move.relative = true;
    return move;
}

/// Of the frames that tell to begin the one behind so many others is lost: 0 is that to all.
void releaseAndLose(Bench &bench, Device &lead, int before)
{
    bench.sent.clear();
    bench.line.setLoss(before == 0 ? 1.0 : 0.0);
    ASSERT_TRUE(lead.releaseMoves());
    const auto isSent = [&bench](int frames) {
        return bench.clock.runUntil([&] { return bench.count(Command::DoMove) >= frames; }, 500ms);
    };
    ASSERT_TRUE(isSent(before));
    bench.line.setLoss(1.0);
    ASSERT_TRUE(isSent(before + 1));
    bench.line.setLoss(0.0);
}

TEST_F(SupermodifiedOrders, AMoveThatIsReleasedBeginsAlthoughTheNodeMissedThatOrRefusedIt)
{
    order(buffered(by(1000.0)), 300ms);
    releaseAndLose(bench, *device, 0);
    bench.clock.advance(100ms);
    EXPECT_FALSE(device->gate().keepsMove());
    EXPECT_GT(node.position(), 20.0) << "within 100 ms";
    bench.clock.advance(2s);
    EXPECT_NEAR(node.position(), 1000.0, 20.0);
    order(buffered(by(500.0)), 300ms);
    node.disturb("error", 0x43); // what is told to all is dropped silently then
    ASSERT_TRUE(device->releaseMoves());
    bench.clock.advance(2s);
    EXPECT_FALSE(device->gate().keepsMove());
    EXPECT_NEAR(node.position(), 1500.0, 20.0) << "once";
    EXPECT_TRUE(device->command(setPoint(Mode::Position, 0.0)));
}

TEST(SupermodifiedRelease, WhatIsReleasedBeginsOnceAlthoughItIsToldTwice)
{
    for (const int lost : {0, 1, 2}) {
        Bench bench;
        const Simulator &first = bench.add("supermodified:4");
        const Simulator &second = bench.add("supermodified:5,dialect=D2");
        const auto lead = bench.connect(4);
        const auto member = bench.connect(5);
        for (Device *one : {lead.get(), member.get()})
            ASSERT_TRUE(one->command(buffered(by(1000.0))));
        bench.clock.advance(500ms);
        releaseAndLose(bench, *lead, lost);
        bench.clock.advance(2s);
        EXPECT_NEAR(first.position(), 1000.0, 20.0) << lost;
        EXPECT_NEAR(second.position(), 1000.0, 20.0) << lost;
        EXPECT_FALSE(lead->gate().keepsMove() || member->gate().keepsMove()) << lost;
    }
}

TEST(SupermodifiedRelease, OfWhichANodeNeverHeardIsNotMadeUpForByTheReleaseOfAnother)
{
    Bench bench;
    const Simulator &node = bench.add("supermodified:4");
    bench.add("supermodified:5");
    const auto lead = bench.connect(4);
    const auto member = bench.connect(5);
    ASSERT_TRUE(lead->command(buffered(by(2000.0))));
    bench.clock.advance(300ms);
    bench.sent.clear();
    bench.line.setLoss(1.0);
    ASSERT_TRUE(lead->releaseMoves());
    ASSERT_TRUE(bench.clock.runUntil([&] { return bench.count(Command::DoMove) > 1; }, 500ms));
    EXPECT_EQ(lead->gate().kept().state, KeptMove::State::Released);
    bench.line.setLoss(0.0);
    lead->stop();
    bench.clock.advance(300ms);
    EXPECT_EQ(lead->gate().kept().state, KeptMove::State::Stale);
    ASSERT_TRUE(lead->command(setPoint(Mode::Velocity, 0.0)));
    ASSERT_TRUE(member->command(buffered(by(100.0))));
    bench.clock.advance(500ms);
    const auto released = member->releaseMoves();
    ASSERT_FALSE(released) << "the other would begin its own";
    EXPECT_EQ(released.error().fault, Fault::Unsafe);
    bench.clock.advance(500ms);
    EXPECT_NEAR(node.position(), 0.0, 5.0);
}

TEST_F(SupermodifiedOrders, AMoveThatWasNeverSentIsNotKeptAfterAStop)
{
    order(setPoint(Mode::Position, 0.0), 300ms);
    bench.sent.clear();
    ASSERT_TRUE(bench.clock.runUntil([&] { return !bench.sent.empty(); }, 1s)) << "a question is under way";
    ASSERT_TRUE(device->command(buffered(setPoint(Mode::Velocity, 300.0))));
    device->stop();
    bench.clock.advance(500ms);
    ASSERT_EQ(bench.count(Command::BufferVelocity), 0);
    EXPECT_FALSE(device->gate().keepsMove());
}

TEST_F(SupermodifiedOrders, AMoveThatWasRefusedIsNotKeptAfterAStop)
{
    order(setPoint(Mode::Position, 0.0), 300ms);
    bench.sent.clear();
    ASSERT_TRUE(device->command(buffered(setPoint(Mode::Velocity, 300.0))));
    for (int i = 0; i < 300; ++i) {
        node.disturb("error", 0x44); // is reported instead of every answer
        bench.clock.advance(1ms);
    }
    ASSERT_EQ(bench.count(Command::BufferVelocity), 4);
    device->stop();
    bench.clock.advance(500ms);
    EXPECT_FALSE(device->gate().keepsMove());
}

TEST_F(SupermodifiedOrders, AMoveThatMayHaveBeenTakenIsKeptAfterAStop)
{
    order(setPoint(Mode::Position, 0.0), 300ms);
    bench.sent.clear();
    bench.line.setLoss(1.0);
    ASSERT_TRUE(device->command(buffered(setPoint(Mode::Velocity, 300.0))));
    ASSERT_TRUE(bench.clock.runUntil([&] { return bench.count(Command::BufferVelocity) == 2; }, 1s));
    bench.line.setLoss(0.0);
    for (int i = 0; i < 300; ++i) {
        node.disturb("error", 0x44); // the second time it is refused
        bench.clock.advance(1ms);
    }
    device->stop();
    bench.clock.advance(500ms);
    EXPECT_EQ(device->gate().kept().state, KeptMove::State::Stale);
}

TEST_F(SupermodifiedOrders, AMoveThatWaitsIsNotWhatTheNodeDoes)
{
    order(buffered(setPoint(Mode::Velocity, 300.0)), 300ms);
    EXPECT_FALSE(device->liveness().mode) << "it was started, and stays where it is";
    order(setPoint(Mode::Velocity, 500.0), 300ms);
    order(buffered(ramp(5000.0, 2000.0, 20000.0)), 300ms);
    EXPECT_EQ(device->liveness().mode, Mode::Velocity);
    ASSERT_TRUE(device->releaseMoves());
    bench.clock.advance(300ms);
    EXPECT_EQ(device->liveness().mode, Mode::RampPosition);
}

TEST_F(SupermodifiedOrders, AMoveThatWaitsDoesNotStopTheOneThatRuns)
{
    order(ramp(20000.0, 2000.0, 20000.0), 700ms);
    ASSERT_GT(node.position(), 500.0);
    ASSERT_LT(node.position(), 3000.0);
    order(buffered(ramp(5000.0, 2000.0, 20000.0)), 300ms);
    order(buffered(setPoint(Mode::Velocity, 100.0)), 300ms);
    EXPECT_EQ(device->liveness().mode, Mode::RampPosition);
    order(buffered(ramp(5000.0, 2000.0, 20000.0)), 4s);
    EXPECT_GT(node.position(), 6500.0);
    EXPECT_TRUE(node.isOutputOn());
    order(buffered(setPoint(Mode::Velocity, 100.0)), 300ms);
    ASSERT_TRUE(device->releaseMoves());
    bench.clock.advance(300ms);
    EXPECT_EQ(device->liveness().mode, Mode::Velocity);
}

// A question without answer (supermodified/README.md#restarts)

TEST_F(SupermodifiedOrders, ADistanceIsNotMovedOnceMoreAfterAQuestionWithoutAnswer)
{
    order(by(300.0), 1s);
    order(by(200.0), 20ms); // it is on its way
    for (int i = 0; i < 10; ++i) {
        bench.line.setLoss(1.0);
        bench.clock.advance(60ms);
        bench.line.setLoss(0.0);
        bench.clock.advance(200ms);
    }
    EXPECT_NEAR(node.position(), 500.0, 5.0);
    EXPECT_TRUE(node.isOutputOn());
    EXPECT_EQ(bench.count(Command::MoveAbsolute), 0) << "where it ends is only believed";
}

// The position is reset (supermodified/README.md#hang)

TEST_F(SupermodifiedOrders, NothingStartsANodeWhileItsPositionIsReset)
{
    order(setPoint(Mode::Position, 500.0), 1s);
    auto zeroing = device->zeroPosition();
    zeroing.start();
    ASSERT_TRUE(bench.clock.runUntil([&] { return bench.count(Command::ResetPosition) == 1; }, 1s));
    bench.clock.advance(1ms);
    bench.line.setLoss(1.0); // its answer
    bench.clock.advance(8ms);
    bench.line.setLoss(0.0);
    bench.sent.clear();
    const auto started = device->command(setPoint(Mode::Position, 1000.0));
    ASSERT_FALSE(started);
    EXPECT_EQ(started.error().fault, Fault::Unsafe);
    ASSERT_TRUE(bench.clock.runUntil([&] { return zeroing.isFinished(); }, 5s));
    EXPECT_TRUE(zeroing.result());
    EXPECT_EQ(bench.count(Command::Start), 0);
    EXPECT_TRUE(device->command(setPoint(Mode::Position, 0.0)));
}

} // namespace
} // namespace mb::supermodified
