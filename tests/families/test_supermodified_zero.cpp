// SPDX-License-Identifier: GPL-3.0-or-later
// supermodified/README.md#start: resetting the position of a motor that runs makes it jump.
#include "families/supermodified/simulatordrive.h"
#include "families/supermodifiedbench.h"

#include <algorithm>

namespace mb::supermodified {
namespace {

using namespace std::chrono_literals;
using mb::test::run;
using test::Bench;
using test::setPoint;
using SupermodifiedZeroNode = test::OneNode;

double positionOf(Device &device)
{
    const auto latest = device.telemetry()->latest(*device.telemetry()->find("position"));
    return latest ? latest->value : NAN;
}

TEST(SupermodifiedZero, StopsThenResetsAndNothingMovesUntilSomebodyStartsIt)
{
    for (const std::string dialect : {"D1", "D2", "D3"}) {
        Bench bench;
        Simulator &node = bench.add("supermodified:4,dialect=" + dialect);
        const auto device = bench.connect(4);
        ASSERT_TRUE(device->command(setPoint(Mode::Position, 3000.0)));
        bench.clock.advance(2s);
        ASSERT_NEAR(positionOf(*device), 3000.0, 20.0);
        bench.sent.clear();
        const auto origin = device->gate().origin();
        ASSERT_TRUE(run(bench.clock, device->zeroPosition())) << dialect;
        EXPECT_NE(device->gate().origin(), origin) << "positions count from another place";
        EXPECT_FALSE(node.isOutputOn());
        EXPECT_TRUE(device->isSeenStopped());
        const auto frames = bench.framesSent();
        const auto stop = std::find_if(frames.begin(), frames.end(), [](auto &f) { return f.is(Command::Stop); });
        const auto reset
            = std::find_if(frames.begin(), frames.end(), [](auto &f) { return f.is(Command::ResetPosition); });
        ASSERT_NE(reset, frames.end());
        EXPECT_LT(stop, reset);
        EXPECT_EQ(bench.count(Command::Start), 0);
        const double rest = node.position();
        bench.clock.advance(1s);
        EXPECT_NEAR(positionOf(*device), 0.0, 20.0);
        EXPECT_NEAR(node.position(), rest, 20.0);
        EXPECT_FALSE(node.isOutputOn()) << "only the user starts it again";
        ASSERT_TRUE(device->command(setPoint(Mode::Position, 0.0)));
        bench.clock.advance(1s);
        EXPECT_TRUE(node.isOutputOn());
        EXPECT_NEAR(node.position(), rest, 20.0) << "no jump";
    }
}

TEST_F(SupermodifiedZeroNode, AStopThatIsRefusedAtFirstIsAcknowledgedBeforeTheReset)
{
    order(setPoint(Mode::Velocity, 2000.0), 500ms);
    node.disturb("error", 0x43);
    auto task = device->zeroPosition();
    task.start();
    while (!task.isFinished()) {
        ASSERT_TRUE(bench.clock.step());
        ASSERT_FALSE(bench.count(Command::ResetPosition) > 0 && node.isOutputOn());
    }
    EXPECT_TRUE(task.result());
    EXPECT_EQ(bench.count(Command::ResetPosition), 1);
}

TEST_F(SupermodifiedZeroNode, NothingIsResetWhileTheStopIsNotAcknowledged)
{
    order(setPoint(Mode::Velocity, 2000.0), 500ms);
    const double before = position();
    bench.line.setLoss(1.0);
    const auto origin = device->gate().origin();
    const auto zeroed = run(bench.clock, device->zeroPosition());
    ASSERT_FALSE(zeroed);
    EXPECT_EQ(device->gate().origin(), origin);
    EXPECT_EQ(zeroed.error().fault, Fault::Unsafe);
    EXPECT_EQ(bench.count(Command::ResetPosition), 0);
    bench.line.setLoss(0.0);
    bench.clock.advance(1s);
    EXPECT_FALSE(node.isOutputOn()) << "the stop goes on";
    EXPECT_GE(position(), before) << "positions are those of before";
}

TEST_F(SupermodifiedZeroNode, AResetThatOutlivesItsDeviceEndsWithNothing)
{
    auto zeroing = device->zeroPosition();
    zeroing.start();
    ASSERT_TRUE(bench.clock.runUntil([this] { return bench.count(Command::ResetPosition) > 0; }, 1s));
    ASSERT_FALSE(zeroing.isFinished());
    EXPECT_FALSE(device->command(setPoint(Mode::Velocity, 500.0))) << "it is being reset";
    device.reset();
    zeroing.cancel();
    EXPECT_FALSE(zeroing.isValid());
}

TEST_F(SupermodifiedZeroNode, ThePlotBeginsANewLineAndNoSpeedIsInvented)
{
    order(setPoint(Mode::Position, 5000.0), 3s);
    ASSERT_TRUE(run(bench.clock, device->zeroPosition()));
    for (int i = 0; i < 50; ++i) {
        bench.clock.advance(10ms);
        EXPECT_LT(std::abs(latest("velocity")), 2000.0);
    }
}

TEST(SupermodifiedZero, OtherFamiliesSayThatTheyCannot)
{
    mb::test::SimulatedSession bench;
    bench.scan();
    const auto zeroed = run(bench.clock, bench.device(5)->zeroPosition());
    ASSERT_FALSE(zeroed);
    EXPECT_EQ(zeroed.error().fault, Fault::Unsupported);
}

TEST(SupermodifiedZeroDrive, AJumpOfTheCounterIsNoSpeed)
{
    struct Running : simulation::Drive {
        Running()
            : Drive(Dialect::D3, *motorByName("25d"), 5.0, 1)
        {
            restart(settings, now);
            start();
            moveTo(2000, false);
            pass(2s);
            EXPECT_LT(std::abs(position() - 2000), 60);
            EXPECT_NEAR(reportedVelocity(), 0, 40);
        }
        void pass(Duration time) { advance(now += time); }
        simulation::LoopSettings settings{1000, 20, 16000, 1000, 800};
        Instant now{};
    };
    Running zeroed;
    zeroed.resetPosition();
    zeroed.pass(50ms); // the next measurement falls into it
    EXPECT_NEAR(zeroed.reportedVelocity(), 0, 40);
    Running started;
    started.stop();
    started.pass(1s);
    started.start();
    started.pass(50ms); // the next measurement falls into it
    EXPECT_NEAR(started.reportedVelocity(), 0, 40);
    Running restarted;
    restarted.moveAt(800, false);
    restarted.pass(1s);
    EXPECT_NE(restarted.reportedVelocity(), 0);
    restarted.restart(restarted.settings, restarted.now);
    EXPECT_EQ(restarted.reportedVelocity(), 0) << "nothing is measured yet";
    restarted.pass(3s);
    EXPECT_NEAR(restarted.reportedVelocity(), 0, 40);
}

} // namespace
} // namespace mb::supermodified
