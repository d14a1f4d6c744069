// SPDX-License-Identifier: GPL-3.0-or-later
// How the simulated DMC60C drives: heartbeat, modes, limits, current limiter, faults of the motor side.
#include "families/dmc60c/simulatorloop.h"
#include "families/dmc60csimulatorbench.h"

#include <cmath>

namespace mb::test {
namespace {

using namespace std::chrono_literals;
using namespace dmc60c;

constexpr auto noDrive = "02060005#0F00000000000000"; // C1
constexpr auto half = "02060005#0000000000400000";    // voltage mode, duty 16384

/// A control frame of device 5, target in bytes 3, 4, 5 as H, L, M.
CanFrame control(int mode, std::int32_t target, int flags0 = 0, int flags1 = 0, int ramp = 0, int device = 5)
{
    const auto raw = static_cast<std::uint32_t>(target);
    const auto octet = [](std::uint32_t value) { return static_cast<std::uint8_t>(value & 0xFFU); };
    return extendedFrame(id::control | static_cast<std::uint32_t>(device),
        {octet(static_cast<std::uint32_t>(mode | flags0)), octet(static_cast<std::uint32_t>(flags1)), 0,
            octet(raw >> 16U), octet(raw), octet(raw >> 8U), octet(static_cast<std::uint32_t>(ramp)),
            octet(static_cast<std::uint32_t>(ramp >> 8))});
}

void drive(Dmc60cBench &bench, const CanFrame &frame, Duration time)
{
    bench.drive(toText(frame), time);
}

void set(Dmc60cBench &bench, std::uint8_t id, std::int64_t raw)
{
    bench.send(parameterSet(id, raw));
    const CanFrame *answer = bench.next(id::paramResponse);
    ASSERT_NE(answer, nullptr);
    ASSERT_EQ(answer->data[5], 0) << int{id};
}

std::int64_t get(Dmc60cBench &bench, std::uint8_t id)
{
    bench.send(parameterRequest(id));
    const CanFrame *answer = bench.next(id::paramResponse);
    return answer == nullptr ? -1 : signExtend(readU32le(answer->bytes(), 1), 32);
}

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
    EXPECT_GT(peak, 1.2); // tuning.md: 24–40 %
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
    set(bench, 10, 73 * 65536); // tuning.md finding 10
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

TEST(Dmc60cSimulatorControl, LimitSwitchesBlockTheirDirection)
{
    Dmc60cBench bench;
    bench.wake();
    bench.drive(half, 100ms);
    ASSERT_TRUE(bench.device().disturb("forward-limit", 1.0));
    bench.drive(half, 60ms);
    EXPECT_EQ(bench.duty(), 0);
    EXPECT_EQ(bench.last(id::statusGeneral)->data[2], 0x12); // low and hit; the other one high
    bench.drive("02060005#000000FF00C00000", 60ms);
    EXPECT_EQ(bench.duty(), -16384);
    drive(bench, control(0, 16384, 0, 0x0A), 60ms); // override: forward off
    EXPECT_EQ(bench.duty(), 16384);
    set(bench, 2, 1);
    bench.drive(half, 60ms);
    EXPECT_EQ(bench.duty(), 16384);
    ASSERT_TRUE(bench.device().disturb("forward-limit", 0.0));
    set(bench, 2, 0);
    set(bench, 1, 1); // normally closed: open means hit
    bench.drive(half, 60ms);
    EXPECT_EQ(bench.duty(), 0);
}

TEST(Dmc60cSimulatorControl, SoftLimitsBlockByPosition)
{
    Dmc60cBench bench;
    bench.wake();
    set(bench, 5, 20000);
    set(bench, 6, 1);
    bench.drive(half, 1s);
    EXPECT_EQ(bench.duty(), 0);
    EXPECT_GE(bench.position(), 20000);
    EXPECT_LT(bench.device().speed(), 1.0);
    EXPECT_EQ(bench.last(id::statusGeneral)->data[3], 0x18);
    bench.drive("02060005#000000FF00C00000", 60ms);
    EXPECT_EQ(bench.duty(), -16384);
}

TEST(Dmc60cSimulatorControl, PositionIsWrittenOnlyWhileTheOutputIsOff)
{
    Dmc60cBench bench;
    bench.wake();
    set(bench, 41, -1000);
    EXPECT_EQ(get(bench, 41), -1000);
    bench.send(half);
    bench.advance(5ms);
    bench.send(parameterSet(41, 0));
    const CanFrame *answer = bench.next(id::paramResponse);
    ASSERT_NE(answer, nullptr);
    EXPECT_EQ(answer->data[5], 2);
}

TEST(Dmc60cSimulatorControl, ClearsItsPositionOnLimitAndIndex)
{
    Dmc60cBench bench;
    bench.wake();
    set(bench, 43, 1);
    set(bench, 2, 1); // clears even with the switch disabled
    bench.drive(half, 300ms);
    ASSERT_TRUE(bench.device().disturb("forward-limit", 1.0));
    bench.drive(half, 100ms);
    EXPECT_EQ(bench.position(), 0);
    EXPECT_GT(bench.device().speed(), 0.0);
    ASSERT_TRUE(bench.device().disturb("forward-limit", 0.0));
    set(bench, 42, 1);
    set(bench, 45, 1);
    bench.drive(half, 500ms);
    set(bench, 92, 1);
    for (int i = 0; i < 50; ++i) {
        bench.drive(half, 20ms);
        const double turns = bench.device().position() / 4096.0;
        EXPECT_GE(bench.position(), 0);
        EXPECT_LT(bench.position(), 4096 + 200);
        EXPECT_NEAR(std::remainder(turns - bench.position() / 4096.0, 1.0), 0.0, 0.1);
    }
}

TEST(Dmc60cSimulatorControl, CurrentLimiterWaitsItsTimeThenHoldsTheContinuousLimit)
{
    Dmc60cBench bench;
    bench.wake();
    ASSERT_TRUE(bench.device().disturb("stall", 1.0));
    set(bench, 61, 20 << 16);
    set(bench, 62, 40 << 16);
    set(bench, 63, 300);
    set(bench, 64, 1);
    set(bench, 91, 10);
    const CanFrame frame = control(0, 16384); // about 60 A
    drive(bench, frame, 280ms);
    EXPECT_EQ(bench.duty(), 16384);
    EXPECT_EQ(bench.last(id::statusGeneral)->data[3] & 0x80, 0);
    drive(bench, frame, 200ms);
    EXPECT_NE(bench.last(id::statusGeneral)->data[3] & 0x80, 0);
    const auto amperes = [&] { return signExtend(readU16le(bench.last(id::statusAnalog)->bytes(), 2), 16) / 256.0; };
    EXPECT_NEAR(amperes(), 20.0, 1.0);
    EXPECT_LT(bench.duty(), 8000);
    drive(bench, control(0, 2000), 200ms);
    EXPECT_EQ(bench.duty(), 2000);
    EXPECT_EQ(bench.last(id::statusGeneral)->data[3] & 0x80, 0);
}

TEST(Dmc60cSimulatorControl, UnderVoltageStopsAfterFiveSecondsAndForThreeMore)
{
    Dmc60cBench bench("dmc60c:5,session=0x1234,fault=brownout@1"); // 5 V from 1 s to 7 s
    bench.wake();
    bench.drive(half, 11s);
    const SimulatorEvent *fault = bench.event("fault");
    ASSERT_NE(fault, nullptr);
    EXPECT_EQ(fault->value, 4.0);
    EXPECT_NEAR(std::chrono::duration<double>(fault->time.time_since_epoch()).count(), 6.0, 0.01);
    EXPECT_EQ(bench.eventNames(), "output-on fault output-off config-flash output-on");
    EXPECT_EQ(get(bench, 51), 0);
    EXPECT_EQ(get(bench, 52), 4);
    EXPECT_EQ(get(bench, 55), 1);
    bench.send(parameterSet(52, 0));
    EXPECT_TRUE(bench.hears("02061845#340400000000"));
    bench.send("02061885#34123401000000"); // P17: read, then clear
    EXPECT_TRUE(bench.hears("02061845#340400000000"));
    bench.send("02061885#34123401000000");
    EXPECT_TRUE(bench.hears("02061845#340000000000"));
}

TEST(Dmc60cSimulatorControl, FaultsOpenTheBridgeUntilThreeSecondsAfterTheyAreGone)
{
    Dmc60cBench bench;
    bench.wake();
    bench.drive(half, 500ms);
    ASSERT_TRUE(bench.device().disturb("gate-fault", 1.0));
    EXPECT_FALSE(bench.device().isOutputOn());
    bench.drive(half, 5s);
    EXPECT_EQ(bench.duty(), 0);
    EXPECT_EQ(bench.last(id::statusGeneral)->data[4] & 4, 4);
    ASSERT_TRUE(bench.device().disturb("gate-fault", 0.0));
    bench.drive(half, 2900ms);
    EXPECT_EQ(bench.duty(), 0);
    bench.drive(half, 200ms);
    EXPECT_EQ(bench.duty(), 16384);
    EXPECT_EQ(get(bench, 56), 1);
    ASSERT_TRUE(bench.device().disturb("temperature", 120.0));
    bench.drive(half, 100ms);
    EXPECT_EQ(get(bench, 51), 2);
    EXPECT_FALSE(bench.device().disturb("weather", 1.0));
}

TEST(Dmc60cSimulatorControl, EncoderAndShaftFaultsShow)
{
    Dmc60cBench dead("dmc60c:5,session=0x1234,fault=encoder-dead@0.5");
    dead.wake();
    dead.drive(half, 1500ms);
    EXPECT_EQ(dead.velocity(), 0);
    EXPECT_GT(dead.device().speed(), 1000.0);
    Dmc60cBench reversed("dmc60c:5,session=0x1234,fault=encoder-reversed");
    reversed.wake();
    reversed.drive(half, 1s);
    EXPECT_LT(reversed.velocity(), -1000);
    EXPECT_GT(reversed.device().speed(), 1000.0);
    Dmc60cBench stalled("dmc60c:5,session=0x1234,fault=stall@0.5");
    stalled.wake();
    stalled.drive(half, 1s);
    EXPECT_EQ(stalled.velocity(), 0);
    EXPECT_EQ(stalled.device().speed(), 0.0);
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

TEST(Dmc60cPid, IntegerArithmeticFollowsTheGainsPerLoop)
{
    using namespace simulation;
    const auto fixed = [](double value) { return static_cast<std::int32_t>(std::lround(value * 65536.0)); };
    const Gains gains{fixed(2.0), fixed(0.5), fixed(10.0), 0, fixed(0.25)};
    Pid pid;
    EXPECT_EQ(pid.step(gains, 100, 0, 0, 0), 200 + 50 + 0 + 25); // no derivative on the first pass
    EXPECT_EQ(pid.step(gains, 100, 40, 0, 0), 120 + 80 - 400 + 25);
    Gains bounded = gains;
    bounded.iZone = 150;
    pid.reset();
    for (int i = 0; i < 10; ++i)
        (void)pid.step(bounded, 100, 0, 0, 0);
    EXPECT_EQ(pid.step(bounded, 100, 0, 0, 0), 200 + 75 + 25);
    EXPECT_EQ(pid.step(bounded, 100, 95, 10, 0), 25); // within the allowable error: only the feed-forward is left
    EXPECT_EQ(pid.step(bounded, 100, 0, 10, 0), 200 + 50 + 950 + 25);
    const Gains amperes{fixed(100.0), 0, 0, 0, 0x03332CCC};
    pid.reset();
    EXPECT_EQ(pid.step(amperes, 20 << 16, 20 << 16, 0, 16), 16383); // 0.5·32767, the datasheet's example
    const Gains wild{2147483647, 2147483647, 2147483647, 0, 2147483647};
    pid.reset();
    for (int i = 0; i < 5; ++i)
        EXPECT_GT(pid.step(wild, 8388607, -2147483647, 0, 0), 32767);
}

TEST(Dmc60cPid, SlotShapesItsOutput)
{
    using namespace simulation;
    Slot slot;
    slot.forwardNominal = 1000;
    slot.reverseNominal = -800;
    slot.forwardMax = 20000;
    slot.reverseMax = -10000;
    EXPECT_EQ(shaped(slot, 5, 0, true), 1000);
    EXPECT_EQ(shaped(slot, 5, 0, false), 5);
    EXPECT_EQ(shaped(slot, -5, 0, true), -800);
    EXPECT_EQ(shaped(slot, 0, 0, true), 0);
    EXPECT_EQ(shaped(slot, 99999, 0, true), 20000);
    EXPECT_EQ(shaped(slot, -99999, 0, true), -10000);
    slot.ramp = 16;
    EXPECT_EQ(shaped(slot, 20000, 100, true), 116);
    EXPECT_EQ(shaped(slot, -20000, 100, true), 84);
}

} // namespace
} // namespace mb::test
