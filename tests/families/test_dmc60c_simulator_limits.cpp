// SPDX-License-Identifier: GPL-3.0-or-later
// What keeps the simulated DMC60C from driving: switches, soft limits, current limiter, faults of the motor side.
#include "families/dmc60csimulatorbench.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace mb::test {
namespace {

using namespace std::chrono_literals;
using namespace dmc60c;
using namespace dmc60csim;

constexpr auto halfDuty = "02060005#0000000000400000"; // voltage mode, duty 16384

/// One of the two directions, with the numbers of its parameters and what the status frame says of it.
struct Way {
    const char *limit;
    std::int32_t sign;
    std::uint8_t normallyClosed;
    std::uint8_t disabled;
    std::uint8_t softThreshold;
    std::uint8_t softEnable;
    std::uint8_t clearsPosition;
    int switchHit; ///< the other pin is high
    int softHit;   ///< and enabled
    int softEnabled;
    int overridden; ///< byte 1 of a control frame that switches this one off

    [[nodiscard]] CanFrame half(int flags = 0) const { return control(0, sign * 16384, 0, flags); }
    [[nodiscard]] CanFrame halfBack() const { return control(0, sign * -16384); }
};
constexpr std::array ways{Way{"forward-limit", 1, 1, 2, 5, 6, 43, 0x12, 0x18, 0x10, 0x0A},
    Way{"reverse-limit", -1, 3, 4, 7, 8, 44, 0x21, 0x60, 0x40, 0x0C}};

TEST(Dmc60cSimulatorLimits, LimitSwitchesBlockTheirDirection)
{
    for (const Way &way : ways) {
        SCOPED_TRACE(way.limit);
        Dmc60cBench bench;
        bench.wake();
        drive(bench, way.half(), 100ms);
        EXPECT_EQ(bench.duty(), way.sign * 16384);
        ASSERT_TRUE(bench.device().disturb(way.limit, 1.0));
        drive(bench, way.half(), 60ms);
        EXPECT_EQ(bench.duty(), 0);
        EXPECT_EQ(bench.last(id::statusGeneral)->data[2], way.switchHit);
        drive(bench, way.halfBack(), 60ms);
        EXPECT_EQ(bench.duty(), way.sign * -16384);
        drive(bench, way.half(way.overridden), 60ms);
        EXPECT_EQ(bench.duty(), way.sign * 16384);
        set(bench, way.disabled, 1);
        drive(bench, way.half(), 60ms);
        EXPECT_EQ(bench.duty(), way.sign * 16384);
        ASSERT_TRUE(bench.device().disturb(way.limit, 0.0));
        set(bench, way.disabled, 0);
        set(bench, way.normallyClosed, 1); // open means hit
        drive(bench, way.half(), 60ms);
        EXPECT_EQ(bench.duty(), 0);
    }
}

TEST(Dmc60cSimulatorLimits, SoftLimitsBlockByPosition)
{
    for (const Way &way : ways) {
        SCOPED_TRACE(way.limit);
        Dmc60cBench bench;
        bench.wake();
        set(bench, way.softThreshold, way.sign * 20000);
        set(bench, way.softEnable, 1);
        drive(bench, way.half(), 1s);
        EXPECT_EQ(bench.duty(), 0);
        EXPECT_GE(way.sign * bench.position(), 20000);
        EXPECT_LT(std::abs(bench.device().speed()), 1.0);
        EXPECT_EQ(bench.last(id::statusGeneral)->data[3], way.softHit);
        drive(bench, way.halfBack(), 60ms);
        EXPECT_EQ(bench.duty(), way.sign * -16384);
    }
}

TEST(Dmc60cSimulatorLimits, ASoftLimitIsHitAtItsThresholdAndNotACountBefore)
{
    for (const Way &way : ways) {
        Dmc60cBench bench;
        bench.wake();
        set(bench, way.softThreshold, way.sign * 20000);
        set(bench, way.softEnable, 1);
        for (const auto &[position, expected] : {std::pair{19999, way.softEnabled}, {20000, way.softHit}}) {
            set(bench, 41, way.sign * position);
            bench.advance(100ms);
            EXPECT_EQ(bench.last(id::statusGeneral)->data[3], expected) << way.limit << ' ' << position;
        }
    }
}

TEST(Dmc60cSimulatorLimits, PositionIsWrittenOnlyWhileTheOutputIsOff)
{
    Dmc60cBench bench;
    bench.wake();
    set(bench, 41, -1000);
    EXPECT_EQ(get(bench, 41), -1000);
    bench.send(halfDuty);
    bench.advance(5ms);
    bench.send(parameterSet(41, 0));
    const CanFrame *answer = bench.next(id::paramResponse);
    ASSERT_NE(answer, nullptr);
    EXPECT_EQ(answer->data[5], 2);
}

TEST(Dmc60cSimulatorLimits, ClearsItsPositionWhileALimitSwitchIsHitEvenWhereThatIsDisabled)
{
    for (const Way &way : ways) {
        SCOPED_TRACE(way.limit);
        Dmc60cBench bench;
        bench.wake();
        set(bench, way.clearsPosition, 1);
        set(bench, way.disabled, 1);
        drive(bench, way.half(), 300ms);
        EXPECT_GT(way.sign * bench.position(), 0);
        ASSERT_TRUE(bench.device().disturb(way.limit, 1.0));
        drive(bench, way.half(), 100ms);
        EXPECT_EQ(bench.position(), 0);
        EXPECT_GT(way.sign * bench.device().speed(), 0.0);
    }
}

TEST(Dmc60cSimulatorLimits, ClearsItsPositionOnTheIndex)
{
    Dmc60cBench bench;
    bench.wake();
    set(bench, 42, 1);
    set(bench, 45, 1);
    bench.drive(halfDuty, 500ms);
    set(bench, 92, 1);
    for (int i = 0; i < 50; ++i) {
        bench.drive(halfDuty, 20ms);
        const double turns = bench.device().position() / 4096.0;
        EXPECT_GE(bench.position(), 0);
        EXPECT_LT(bench.position(), 4096 + 200);
        EXPECT_NEAR(std::remainder(turns - bench.position() / 4096.0, 1.0), 0.0, 0.1);
    }
}

/// The index is high on one count of a turn.
TEST(Dmc60cSimulatorLimits, ClearsItsPositionOnTheEdgeOfTheIndexThatItIsTold)
{
    for (const Way &way : ways) {
        for (const bool rising : {false, true}) {
            Dmc60cBench bench;
            bench.wake();
            set(bench, 42, 1);
            set(bench, 45, rising ? 1 : 0);
            drive(bench, way.half(), 1s);
            bench.advance(5s); // it runs down
            const auto counts = static_cast<std::int64_t>(std::floor(bench.device().position()));
            ASSERT_GT(std::abs(counts), 4096);
            EXPECT_EQ((counts - get(bench, 41)) & 4095, rising == (way.sign > 0) ? 0 : 1) << way.sign << ' ' << rising;
        }
    }
}

TEST(Dmc60cSimulatorLimits, CurrentLimiterWaitsItsTimeThenHoldsTheContinuousLimit)
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

TEST(Dmc60cSimulatorLimits, UnderVoltageStopsAfterFiveSecondsAndForThreeMore)
{
    Dmc60cBench bench("dmc60c:5,session=0x1234,fault=brownout@1"); // 5 V from 1 s to 7 s
    bench.wake();
    bench.drive(halfDuty, 11s);
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

TEST(Dmc60cSimulatorLimits, FaultsOpenTheBridgeUntilThreeSecondsAfterTheyAreGone)
{
    Dmc60cBench bench;
    bench.wake();
    bench.drive(halfDuty, 500ms);
    ASSERT_TRUE(bench.device().disturb("gate-fault", 1.0));
    EXPECT_FALSE(bench.device().isOutputOn());
    bench.drive(halfDuty, 5s);
    EXPECT_EQ(bench.duty(), 0);
    EXPECT_EQ(bench.last(id::statusGeneral)->data[4] & 4, 4);
    ASSERT_TRUE(bench.device().disturb("gate-fault", 0.0));
    bench.drive(halfDuty, 2900ms);
    EXPECT_EQ(bench.duty(), 0);
    bench.drive(halfDuty, 200ms);
    EXPECT_EQ(bench.duty(), 16384);
    EXPECT_EQ(get(bench, 56), 1);
    ASSERT_TRUE(bench.device().disturb("temperature", 120.0));
    bench.drive(halfDuty, 100ms);
    EXPECT_EQ(get(bench, 51), 2);
    EXPECT_FALSE(bench.device().disturb("weather", 1.0));
}

TEST(Dmc60cSimulatorLimits, EncoderAndShaftFaultsShow)
{
    Dmc60cBench dead("dmc60c:5,session=0x1234,fault=encoder-dead@0.5");
    dead.wake();
    dead.drive(halfDuty, 1500ms);
    EXPECT_EQ(dead.velocity(), 0);
    EXPECT_GT(dead.device().speed(), 1000.0);
    Dmc60cBench reversed("dmc60c:5,session=0x1234,fault=encoder-reversed");
    reversed.wake();
    reversed.drive(halfDuty, 1s);
    EXPECT_LT(reversed.velocity(), -1000);
    EXPECT_GT(reversed.device().speed(), 1000.0);
    Dmc60cBench stalled("dmc60c:5,session=0x1234,fault=stall@0.5");
    stalled.wake();
    stalled.drive(halfDuty, 1s);
    EXPECT_EQ(stalled.velocity(), 0);
    EXPECT_EQ(stalled.device().speed(), 0.0);
}

} // namespace
} // namespace mb::test
