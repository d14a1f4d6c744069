// SPDX-License-Identifier: GPL-3.0-or-later
// Distances count from the set-point of the loop, so they add up (supermodified/README.md#overflow).
#include "families/supermodified/movebounds.h"
#include "families/supermodifiedbench.h"

#include <optional>

namespace mb::supermodified {
namespace {

using namespace std::chrono_literals;
using mb::test::run;
using test::Bench;
using test::buffered;
using test::ramp;
using test::setPoint;

SetPoint by(double distance, std::uint32_t number)
{
    SetPoint made = setPoint(Mode::Position, distance);
    made.relative = true;
    made.order = number;
    return made;
}

/// P is 4000, so that 536869 ticks are as far as a step may go.
class SupermodifiedDistances : public test::OneNode {
protected:
    void useFactoryGain() { EXPECT_TRUE(run(bench.clock, device->write(Bench::index("gain.p"), 4000))); }
};

TEST_F(SupermodifiedDistances, DistancesThatAddUpToMoreThanTheLoopCanAreRefusedWithTheSecond)
{
    useFactoryGain();
    order(by(400000.0, 1), 100ms);
    bench.sent.clear();
    const auto second = device->command(by(400000.0, 2));
    ASSERT_FALSE(second) << "its set-point would be 800000 ahead of the motor, and P of that wraps";
    EXPECT_EQ(second.error().fault, Fault::OutOfRange);
    EXPECT_TRUE(device->command(by(-400000.0, 3))) << "back to where it began";
    bench.clock.advance(100ms);
    EXPECT_EQ(bench.count(Command::MoveRelative), 1);
    for (int i = 0; i < 40; ++i) {
        bench.clock.advance(25ms);
        ASSERT_GT(node.position(), -500.0) << "the wrong way";
    }
}

TEST_F(SupermodifiedDistances, ADistanceQueuedBehindAnotherIsNotSentWhereBothAreTooMuch)
{
    useFactoryGain();
    ASSERT_TRUE(device->command(by(400000.0, 1)));
    (void)device->command(by(400000.0, 2));
    bench.clock.advance(300ms);
    EXPECT_EQ(bench.count(Command::MoveRelative), 1);
    EXPECT_FALSE(device->command(setPoint(Mode::Position, 1000.0))) << "why it ended is said until it is stopped";
}

TEST_F(SupermodifiedDistances, ADistanceAfterAPositionCountsFromThatPosition)
{
    useFactoryGain();
    order(setPoint(Mode::Position, 400000.0), 100ms);
    EXPECT_EQ(device->command(by(400000.0, 1)).error().fault, Fault::OutOfRange);
    order(setPoint(Mode::Position, 1000.0), 100ms);
    EXPECT_TRUE(device->command(by(400000.0, 2)));
}

TEST_F(SupermodifiedDistances, ADistanceBehindABufferedPositionCountsFromTheOneThatIsNotOverYet)
{
    useFactoryGain();
    order(setPoint(Mode::Position, 400000.0), 100ms);
    SetPoint kept = setPoint(Mode::Position, 0.0);
    kept.buffered = true;
    order(kept, 100ms);
    bench.sent.clear();
    EXPECT_EQ(device->command(by(400000.0, 1)).error().fault, Fault::OutOfRange)
        << "800000 ahead, nothing was released";
    bench.clock.advance(1s);
    EXPECT_EQ(bench.count(Command::MoveRelative), 0);
    EXPECT_GT(node.position(), -500.0);
}

TEST_F(SupermodifiedDistances, ADistanceAfterAVelocityNeedsAHaltFirst)
{
    useFactoryGain();
    order(setPoint(Mode::Velocity, 8000.0), 500ms);
    const auto refused = device->command(by(100.0, 1));
    ASSERT_FALSE(refused) << "nobody knows from where it counts";
    EXPECT_EQ(refused.error().fault, Fault::Unsafe);
    EXPECT_NE(refused.error().text().find("halt it first"), std::string::npos) << refused.error().text();
    order(by(0.0, 2), 300ms);
    const double where = node.position();
    order(by(1000.0, 3), 1s);
    EXPECT_NEAR(node.position(), where + 1000.0, 100.0);
}

TEST_F(SupermodifiedDistances, ADistanceAfterAProfileCountsFromTheWorstOfItsWay)
{
    useFactoryGain();
    order(ramp(500000.0, 2000.0, 40000.0), 300ms);
    EXPECT_EQ(device->command(by(100000.0, 1)).error().fault, Fault::OutOfRange) << "it may have arrived";
    EXPECT_TRUE(device->command(by(1000.0, 2)));
}

TEST_F(SupermodifiedDistances, AfterAStartADistanceCountsFromZero)
{
    useFactoryGain();
    order(setPoint(Mode::Velocity, 8000.0), 500ms);
    device->stop();
    bench.clock.advance(500ms);
    EXPECT_TRUE(device->command(by(500000.0, 1)));
    bench.clock.advance(100ms);
    EXPECT_EQ(bench.count(Command::MoveRelative), 1);
}

TEST_F(SupermodifiedDistances, WhereSomebodyElseMovedItADistanceIsRefused)
{
    useFactoryGain();
    order(by(50.0, 1), 200ms);
    ASSERT_TRUE(device->check(by(100.0, 2)));
    VirtualSerialLink other(*LinkAddress::parse("sim:serial"), bench.line);
    ASSERT_TRUE(other.open());
    ASSERT_TRUE(other.setBaudrate(bench.host.baudrate()));
    for (int i = 0; i < 40 && !device->liveness().foreignMaster; ++i) {
        ASSERT_TRUE(other.send(test::bytesOf("55 AA 04 02 1A 00 1A")));
        bench.clock.advance(7300us);
    }
    EXPECT_TRUE(device->liveness().foreignMaster);
    EXPECT_EQ(device->check(by(100.0, 2)).error().fault, Fault::Unsafe);
}

TEST_F(SupermodifiedDistances, ABufferedPositionIsCheckedOnceMoreWhenItIsReleased)
{
    bench.clock.advance(100ms);
    ASSERT_TRUE(run(bench.clock, device->write(Bench::index("gain.p"), 65535)));
    order(setPoint(Mode::Position, 20000.0), 4s);
    ASSERT_NEAR(node.position(), 20000.0, 100.0);
    ASSERT_TRUE(device->command(setPoint(Mode::Position, 0.0)));
    SetPoint kept = setPoint(Mode::Position, 50000.0);
    kept.buffered = true;
    order(kept, 4s);
    ASSERT_NEAR(node.position(), 0.0, 100.0);
    bench.sent.clear();
    EXPECT_EQ(device->releaseMoves().error().fault, Fault::OutOfRange);
    bench.clock.advance(100ms);
    EXPECT_EQ(bench.count(Command::DoMove), 0);
}

TEST_F(SupermodifiedDistances, AfterAReleaseADistanceCountsFromWhereTheReleasedMoveGoes)
{
    useFactoryGain();
    order(buffered(setPoint(Mode::Position, 400000.0)), 100ms);
    order(setPoint(Mode::Position, 1000.0), 100ms);
    ASSERT_TRUE(device->releaseMoves());
    bench.clock.advance(100ms);
    const auto refused = device->check(by(400000.0, 1));
    ASSERT_FALSE(refused) << "its set-point would be 800000 ahead of the motor";
    EXPECT_EQ(refused.error().fault, Fault::OutOfRange);
    order(setPoint(Mode::Position, 0.0), 100ms);
    order(buffered(by(-300000.0, 2)), 100ms);
    ASSERT_TRUE(device->releaseMoves());
    bench.clock.advance(100ms);
    EXPECT_TRUE(device->check(by(600000.0, 3))) << "300000 ahead";
}

TEST_F(SupermodifiedDistances, ABufferedDistanceIsCheckedFromWhereTheSetPointIsAtItsRelease)
{
    useFactoryGain();
    order(buffered(by(400000.0, 1)), 100ms);
    order(setPoint(Mode::Position, 400000.0), 100ms);
    bench.sent.clear();
    EXPECT_EQ(device->releaseMoves().error().fault, Fault::OutOfRange) << "800000 ahead of the motor";
    bench.clock.advance(100ms);
    EXPECT_EQ(bench.count(Command::DoMove), 0);
}

TEST_F(SupermodifiedDistances, AHigherPIsRefusedWhileTheMotorIsFarFromItsSetPoint)
{
    useFactoryGain();
    order(setPoint(Mode::Position, 100000.0), 100ms);
    bench.sent.clear();
    const auto refused = run(bench.clock, device->write(Bench::index("gain.p"), 40000));
    ASSERT_FALSE(refused) << "40000 times 100000 wraps";
    EXPECT_EQ(refused.error().fault, Fault::OutOfRange);
    EXPECT_EQ(bench.count(Command::P), 0);
    EXPECT_TRUE(run(bench.clock, device->write(Bench::index("gain.p"), 20000)));
    device->stop();
    bench.clock.advance(100ms);
    EXPECT_TRUE(run(bench.clock, device->write(Bench::index("gain.p"), 40000)));
    order(setPoint(Mode::Velocity, 20000.0), 100ms);
    EXPECT_EQ(run(bench.clock, device->write(Bench::index("gain.p"), 65535)).error().fault, Fault::OutOfRange)
        << "65535 times 2 s of it wraps";
}

// What was sent and not acknowledged is not known

TEST_F(SupermodifiedDistances, AProfileWhoseWriteAStopBrokeOffIsWrittenAnew)
{
    bench.clock.advance(100ms);
    bench.sent.clear();
    ASSERT_TRUE(device->command(ramp(3000.0, 5000.0, 800.0)));
    ASSERT_TRUE(bench.clock.runUntil([&] { return bench.count(Command::ProfileVelocity) == 1; }, 1s));
    bench.clock.advance(2ms); // the node has it, and its EEPROM is busy
    device->stop();
    bench.clock.advance(500ms);
    EXPECT_EQ(device->check(ramp(3000.0, 0.0, 800.0)).error().fault, Fault::Unsafe) << "how fast is not known";
    bench.sent.clear();
    order(ramp(3000.0, 800.0, 800.0), 2s);
    EXPECT_EQ(bench.count(Command::ProfileVelocity), 1);
    EXPECT_LT(node.speed(), 1000.0);
}

TEST_F(SupermodifiedDistances, APIsWrittenWhileTheMotorRunsOn)
{
    SetPointStream stream(*device, bench.clock);
    ASSERT_TRUE(stream.start(setPoint(Mode::Velocity, 500.0), 60s));
    bench.clock.advance(500ms);
    bench.sent.clear();
    for (int i = 0; i < 20; ++i) {
        ASSERT_TRUE(run(bench.clock, device->write(Bench::index("gain.p"), 4000 + i)));
        bench.clock.advance(std::chrono::milliseconds(3 + i));
    }
    EXPECT_TRUE(stream.isRunning());
    EXPECT_EQ(bench.count(Command::P), 20);
    EXPECT_EQ(bench.count(Command::Stop), 0);
    EXPECT_GT(node.speed(), 400.0);
}

TEST_F(SupermodifiedDistances, APWhoseWriteIsCancelledBoundsAsMuchAsTheGreaterOne)
{
    useFactoryGain();
    bench.sent.clear();
    {
        auto writing = device->write(Bench::index("gain.p"), 65535);
        writing.start();
        ASSERT_TRUE(bench.clock.runUntil([&] { return bench.count(Command::P) == 1; }, 1s));
    }
    bench.clock.advance(500ms);
    EXPECT_TRUE(device->check(setPoint(Mode::Position, 10.0)));
    EXPECT_EQ(device->check(setPoint(Mode::Position, 40000.0)).error().fault, Fault::OutOfRange)
        << "65535 may be in the node";
}

} // namespace
} // namespace mb::supermodified
