// SPDX-License-Identifier: GPL-3.0-or-later
// How the simulated DMC60C drives: heartbeat, modes, loops.
#include "families/dmc60csimulatorbench.h"

#include <cmath>

namespace mb::test {
namespace {

using namespace std::chrono_literals;
using namespace dmc60c;
using namespace dmc60csim;

constexpr auto noDrive = "02060005#0F00000000000000"; // C1
constexpr auto half = "02060005#0000000000400000";    // voltage mode, duty 16384

TEST(Dmc60cSimulatorControl, HaltsExactly104MillisecondsAfterTheLastControlFrame)
{
    Dmc60cBench bench;
    bench.wake();
    bench.drive(half, 400ms);
    Instant sent{};
    const auto tap = bench.port().received().add([&](const CanFrame &frame) { sent = frame.time; });
    bench.send(half);
    bench.advance(1s);
    ASSERT_NE(bench.event("halted"), nullptr);
    EXPECT_EQ(bench.event("halted")->time, sent + 104ms);
    EXPECT_EQ(bench.event("output-off")->time, sent + 104ms);
    EXPECT_FALSE(bench.device().isOutputOn());
    EXPECT_EQ(bench.duty(), 0);
    EXPECT_EQ(bench.mode(), 15);
}

TEST(Dmc60cSimulatorControl, OnlyANonZeroSetPointEndsTheHalt)
{
    Dmc60cBench bench;
    bench.wake();
    bench.drive("02060005#0000000000000000", 100ms);
    EXPECT_EQ(bench.mode(), 15);
    EXPECT_EQ(bench.eventNames(), "");
    bench.drive(half, 100ms);
    EXPECT_EQ(bench.mode(), 0);
    EXPECT_EQ(bench.duty(), 16384);
    EXPECT_TRUE(bench.device().isOutputOn());
    bench.drive("02060005#0000000000000000", 100ms);
    EXPECT_EQ(bench.mode(), 0); // still running, at zero
    EXPECT_EQ(bench.duty(), 0);
    bench.send(noDrive);
    bench.advance(20ms);
    EXPECT_EQ(bench.mode(), 15);
    EXPECT_EQ(bench.eventNames(), "output-on output-off halted");
}

TEST(Dmc60cSimulatorControl, DutyTurnsTheMotorTheWayItsSignSays)
{
    Dmc60cBench bench;
    bench.wake();
    bench.drive(half, 1s);
    EXPECT_GT(bench.velocity(), 10000); // about 270 rad/s
    EXPECT_NEAR(bench.device().speed() / 10.0, bench.velocity(), 1000.0);
    EXPECT_NEAR(bench.device().position(), bench.position(), 20000.0);
    bench.drive("02060005#000000FF00C00000", 2s); // C3
    EXPECT_LT(bench.velocity(), -10000);
    EXPECT_EQ(bench.duty(), -16384);
    drive(bench, control(0, 16384, 0, 1), 2s); // fRevMotor
    EXPECT_LT(bench.velocity(), -10000);
    drive(bench, control(0, 16384, 0x80, 1), 1s); // and the sensor as well
    EXPECT_GT(bench.velocity(), 10000);
    EXPECT_LT(bench.device().speed(), 0.0);
}

TEST(Dmc60cSimulatorControl, RampsByItsUnitsPerPass)
{
    Dmc60cBench bench;
    bench.wake();
    set(bench, 93, 1);
    const CanFrame frame = control(0, 32767, 0, 0, 16); // 1.024 s
    drive(bench, frame, 512ms);
    EXPECT_NEAR(bench.duty(), 16384, 64);
    drive(bench, frame, 520ms);
    EXPECT_EQ(bench.duty(), 32767);
    drive(bench, control(0, 0, 0, 0, 1024), 12ms);
    EXPECT_NEAR(bench.duty(), 32767 - 1024 * 24, 4 * 1024);
}

TEST(Dmc60cSimulatorControl, BrakeStopsSoonerThanCoast)
{
    const auto speedAfter = [](int flags) {
        Dmc60cBench bench;
        bench.wake();
        bench.drive(half, 1s);
        drive(bench, control(0, 0, flags), 300ms);
        return bench.device().speed();
    };
    EXPECT_LT(speedAfter(0x30), 0.3 * speedAfter(0x10));
    EXPECT_NEAR(speedAfter(0x00), speedAfter(0x30), 1.0); // the button is at brake
}

TEST(Dmc60cSimulatorControl, CompensatesTheSupply)
{
    Dmc60cBench bench;
    bench.wake();
    bench.drive("02060005#0400000600000000", 500ms); // 6 V
    EXPECT_NEAR(bench.duty(), 16384, 400);
    ASSERT_TRUE(bench.device().disturb("bus-voltage", 8.0));
    bench.drive("02060005#0400000600000000", 500ms);
    EXPECT_NEAR(bench.duty(), 24575, 600);
    drive(bench, control(4, 12 << 16), 100ms);
    EXPECT_EQ(bench.duty(), 32767);
}

/// Runs a velocity step to 30 % of free speed and yields the overshoot as a fraction.
double velocityOvershoot(const std::string &unit, std::int32_t target)
{
    Dmc60cBench bench(unit);
    bench.wake();
    set(bench, 92, 5);
    double peak = 0.0;
    for (int i = 0; i < 150; ++i) {
        drive(bench, control(1, target), 20ms);
        peak = std::max(peak, bench.device().speed() / 10.0);
    }
    EXPECT_NEAR(bench.device().speed() / 10.0, target, 0.01 * target) << unit;
    EXPECT_NEAR(bench.velocity(), target, 0.01 * target);
    return peak / target - 1.0;
}

TEST(Dmc60cSimulatorControl, TunedUnitStepsItsVelocityWithoutOvershoot)
{
    for (const char *motor : {"cim,load=9", "775pro,load=7", "rs775", "25d", "n20"}) {
        const bool large = std::string(motor).starts_with("775");
        const bool coarse = std::string(motor) == "25d" || std::string(motor) == "n20";
        const std::int32_t target = coarse ? 100 : large ? 38000 / 2 : 10900;
        const double overshoot = velocityOvershoot(std::string("dmc60c:5,session=0x1234,motor=") + motor, target);
        EXPECT_LT(overshoot, 0.05) << motor;
        EXPECT_GT(overshoot, -0.01) << motor;
    }
}

TEST(Dmc60cSimulatorControl, LivelyUnitOvershootsAboutAFifth)
{
    const double overshoot = velocityOvershoot("dmc60c:5,session=0x1234,motor=775pro,load=7,gains=overshoot", 19000);
    EXPECT_GT(overshoot, 0.15);
    EXPECT_LT(overshoot, 0.25);
}

TEST(Dmc60cSimulatorControl, BlockWindowOvershootsWithGainsForTheRollingOne)
{
    const double tuned = velocityOvershoot("dmc60c:5,session=0x1234,velocity=block", 10900);
    EXPECT_LT(tuned, 0.06);
    Dmc60cBench donor;
    donor.wake();
    const std::int64_t p = get(donor, 10);
    const std::int64_t i = get(donor, 11);
    Dmc60cBench bench("dmc60c:5,session=0x1234,velocity=block");
    bench.wake();
    set(bench, 10, p);
    set(bench, 11, i);
    double peak = 0.0;
    for (int n = 0; n < 100; ++n) {
        drive(bench, control(1, 10900), 20ms);
        peak = std::max(peak, bench.device().speed() / 109000.0);
    }
    EXPECT_GT(peak, 1.2); // its stored gains overshoot 24–40 %
}

TEST(Dmc60cSimulatorControl, VelocityOfARollingWindowLags50Milliseconds)
{
    Dmc60cBench bench;
    bench.wake();
    set(bench, 92, 1);
    bench.drive(half, 60ms);
    const double now = bench.device().speed();
    EXPECT_LT(bench.velocity(), 0.6 * now / 10.0);
    Dmc60cBench block("dmc60c:5,session=0x1234,velocity=block");
    block.wake();
    set(block, 92, 1);
    block.drive(half, 1s);
    int changes = 0;
    std::int32_t before = 0;
    for (const CanFrame &frame : block.heard()) {
        if ((frame.id & id::messageMask) != id::statusEncoder)
            continue;
        const std::int32_t value = readU16be(frame.bytes(), 3);
        changes += value != before;
        before = value;
    }
    EXPECT_GE(changes, 9);
    EXPECT_LE(changes, 11);
}

TEST(Dmc60cSimulatorControl, ABlockWindowReportsAStandingMotorAsStanding)
{
    for (int phase = 0; phase < 10; ++phase) {
        Dmc60cBench bench("dmc60c:5,session=0x1234,velocity=block");
        bench.wake();
        set(bench, 92, 10);
        bench.drive(half, 500ms + phase * 11ms);
        ASSERT_NE(bench.velocity(), 0);
        bench.advance(10s);
        ASSERT_EQ(bench.device().speed(), 0.0);
        EXPECT_EQ(bench.velocity(), 0) << "phase " << phase;
    }
}

TEST(Dmc60cSimulatorControl, PositionSlotReachesItsTarget)
{
    Dmc60cBench bench;
    bench.wake();
    set(bench, 92, 10);
    drive(bench, control(2, 40960, 0x40), 2s);
    EXPECT_NEAR(bench.position(), 40960, 6);
    EXPECT_NEAR(bench.device().position(), 40960.0, 7.0);
    EXPECT_EQ(bench.mode(), 2);
    EXPECT_TRUE(bench.device().isOutputOn());
}

TEST(Dmc60cSimulatorControl, CurrentLoopHoldsItsCurrent)
{
    Dmc60cBench bench("dmc60c:5,session=0x1234,motor=cim");
    bench.wake();
    ASSERT_TRUE(bench.device().disturb("stall", 1.0));
    set(bench, 10, 73 * 65536); // docs/names.md#integer-gains
    set(bench, 11, 55 * 65536);
    set(bench, 13, 0);
    set(bench, 91, 10);
    drive(bench, control(3, 20 << 16), 200ms);
    const auto &analog = bench.last(id::statusAnalog)->data;
    EXPECT_NEAR(signExtend(readU16le(analog, 2), 16) / 256.0, 20.0, 0.5);
}

TEST(Dmc60cSimulatorControl, FollowerCopiesItsMasterAndStopsWithoutIt)
{
    Dmc60cBench bench;
    VirtualCanLink port(*LinkAddress::parse("sim:can"), bench.bus());
    ASSERT_TRUE(port.open());
    const auto master = bench.make("dmc60c:6", 2, port);
    bench.wake();
    const CanFrame follow = control(5, 6);
    for (int i = 0; i < 25; ++i) {
        bench.send(control(0, 12345, 0, 0, 0, 6));
        drive(bench, follow, 20ms);
    }
    const auto dutyOf5 = [&] {
        std::int32_t duty = 0;
        for (const CanFrame &frame : bench.heard()) {
            if (frame.id == (id::statusGeneral | 5U))
                duty = signExtend(readU16le(frame.bytes(), 0), 16);
        }
        return duty;
    };
    EXPECT_EQ(dutyOf5(), 12345);
    master->setPowered(false);
    drive(bench, follow, 90ms);
    EXPECT_EQ(dutyOf5(), 12345);
    drive(bench, follow, 60ms);
    EXPECT_EQ(dutyOf5(), 0);
}

TEST(Dmc60cSimulatorControl, FollowerOnTheSameLinkHearsItsMasterToo)
{
    Dmc60cBench bench;
    const auto master = bench.make("dmc60c:6", 2, bench.port());
    bench.wake();
    for (int i = 0; i < 10; ++i) {
        bench.send(control(0, 12345, 0, 0, 0, 6));
        drive(bench, control(5, 6), 20ms);
    }
    EXPECT_TRUE(bench.device().isOutputOn());
    EXPECT_GT(bench.device().speed(), 0.0);
}

TEST(Dmc60cSimulatorControl, AnIdleUnitCostsNoPasses)
{
    Dmc60cBench bench;
    bench.wake();
    set(bench, 93, 50);
    set(bench, 92, 30000);
    set(bench, 91, 30000);
    bench.advance(std::chrono::hours(1)); // 7.2 million passes if it did
    EXPECT_EQ(bench.device().position(), 0.0);
    bench.drive(half, 100ms);
    EXPECT_GT(bench.device().speed(), 0.0);
}

} // namespace
} // namespace mb::test
