// SPDX-License-Identifier: GPL-3.0-or-later
// What a board is taken to have because it accepted it, and what not. On virtual time.
#include "families/quadquad2drv/axisdrives.h"
#include "families/quadquad2drv/codec.h"
#include "families/quadquad2drv/parameters.h"
#include "support/simulatedsession.h"
#include "transport/backends/virtualspi.h"

#include <algorithm>
#include <cmath>

namespace mb::quadquad2drv {
namespace {

using namespace std::chrono_literals;
using test::run;
using test::SimulatedSession;

struct QuadQuad2DrvAssumed : testing::Test {
    QuadQuad2DrvAssumed()
        : bench("sim:spi")
    {
        bench.scan();
        device = bench.device(0, "quadquad2drv");
        heard = bench.link->traffic().add([this](const Traffic &traffic) {
            if (traffic.direction == Direction::Sent)
                sent.emplace_back(traffic.bytes.begin(), traffic.bytes.end());
        });
        bench.clock.advance(200ms);
    }
    void SetUp() override { ASSERT_NE(device, nullptr); }
    void setLoss(double fraction) { static_cast<VirtualSpiLink &>(*bench.link).setLoss(fraction); }
    [[nodiscard]] const ParameterStore::Entry &entry(AxisParameter which) const
    {
        return device->parameters().entry(indexOf(0, which));
    }
    /// Whether the first of these packets went before the second one.
    [[nodiscard]] bool went(const Bytes &first, const Bytes &second) const
    {
        const auto one = std::find(sent.begin(), sent.end(), first);
        return one != sent.end() && std::find(one, sent.end(), second) != sent.end()
            && std::find(sent.begin(), one, second) == one;
    }
    Result<void> begin()
    {
        SetPoint setPoint;
        setPoint.mode = Mode::Duty;
        setPoint.target = 0.5;
        return bench.session.stream(*device).start(setPoint, 10s);
    }
    SimulatedSession bench;
    Device *device = nullptr;
    std::vector<Bytes> sent;
    Subscription heard;
};

TEST(QuadQuad2DrvSetPoint, IsWithinWhatItsModeCanTakeInBothDirections)
{
    const auto isGood = [](Mode mode, double target, double velocity = 0.0, double acceleration = 0.0) {
        SetPoint setPoint;
        setPoint.mode = mode;
        setPoint.target = target;
        setPoint.velocity = velocity;
        setPoint.acceleration = acceleration;
        return checkSetPoint(setPoint).has_value();
    };
    struct Row {
        Mode mode;
        double low;
        double high;
        double step;
        double velocity;
    };
    for (const Row &row : {Row{Mode::Duty, -1.0, 1.0, 0.001, 0.0}, {Mode::Velocity, -100'000.0, 100'000.0, 1.0, 0.0},
             {Mode::RampVelocity, -100'000.0, 100'000.0, 1.0, 0.0},
             {Mode::Position, -2147483648.0, 2147483647.0, 1.0, 0.0},
             {Mode::RampPosition, -2147483648.0, 2147483647.0, 1.0, 500.0}}) {
        EXPECT_TRUE(isGood(row.mode, row.low, row.velocity) && isGood(row.mode, row.high, row.velocity))
            << toString(row.mode);
        EXPECT_FALSE(isGood(row.mode, row.low - row.step, row.velocity)) << toString(row.mode);
        EXPECT_FALSE(isGood(row.mode, row.high + row.step, row.velocity)) << toString(row.mode);
        EXPECT_FALSE(isGood(row.mode, NAN, row.velocity)) << toString(row.mode);
    }
    EXPECT_TRUE(isGood(Mode::RampPosition, 0.0, 100'000.0, 1'000'000.0));
    EXPECT_FALSE(isGood(Mode::RampPosition, 0.0, 100'001.0, 1'000'000.0));
    EXPECT_FALSE(isGood(Mode::RampPosition, 0.0, 100'000.0, 1'000'001.0));
    EXPECT_FALSE(isGood(Mode::RampPosition, 0.0, -1.0, 1000.0) || isGood(Mode::RampVelocity, 0.0, 0.0, -1.0));
    EXPECT_FALSE(isGood(Mode::RampPosition, 0.0)) << "a ramp without a speed";
    EXPECT_FALSE(isGood(Mode::Current, 0.0));
}

TEST_F(QuadQuad2DrvAssumed, ATargetBeyondAKnownLimitOfItsAxisIsSaid)
{
    const auto caution = [this](Mode mode, double target, double velocity = 0.0) {
        SetPoint setPoint;
        setPoint.mode = mode;
        setPoint.target = target;
        setPoint.velocity = velocity;
        return device->caution(setPoint).english();
    };
    EXPECT_NE(caution(Mode::Duty, -0.3).find("power limit of axis 1 is 25 %"), std::string::npos) << "the first one";
    EXPECT_EQ(caution(Mode::Duty, 0.25), "");
    EXPECT_EQ(caution(Mode::Velocity, 3000.0), "") << "nobody knows what the board starts with";
    ASSERT_TRUE(run(bench.clock, device->write(indexOf(0, AxisParameter::LimitVelocity), 1500 * 4096)));
    ASSERT_TRUE(run(bench.clock, device->write(indexOf(0, AxisParameter::LimitPower), 8191)));
    EXPECT_EQ(caution(Mode::Duty, 1.0), "");
    for (const Mode mode : {Mode::Velocity, Mode::RampVelocity})
        EXPECT_NE(caution(mode, -3000.0).find("velocity limit of axis 1 is 1500 counts/s"), std::string::npos);
    EXPECT_NE(caution(Mode::RampPosition, 10.0, 1501.0).find("1500 counts/s"), std::string::npos);
    EXPECT_EQ(caution(Mode::RampPosition, 10000.0, 1500.0), "");
    EXPECT_EQ(caution(Mode::Velocity, 1500.0), "");
    EXPECT_EQ(caution(Mode::Position, 100000.0), "");
}

TEST_F(QuadQuad2DrvAssumed, ARampToAPositionNeedsAVelocityThatTheBoardIsTold)
{
    SetPoint ramp;
    ramp.mode = Mode::RampPosition;
    EXPECT_EQ(device->check(ramp).error().fault, Fault::OutOfRange);
    ramp.velocity = 0.0001;
    EXPECT_EQ(device->check(ramp).error().fault, Fault::OutOfRange) << "as a number of the board it is 0";
    ramp.velocity = 0.001;
    EXPECT_TRUE(device->check(ramp));
    ramp.mode = Mode::RampVelocity;
    ramp.velocity = 0.0;
    EXPECT_TRUE(device->check(ramp)) << "its target is one";
}

TEST_F(QuadQuad2DrvAssumed, PositionsCountFromAnotherPlaceOnceACounterIsWritten)
{
    const auto origin = device->gate().origin();
    ASSERT_TRUE(run(bench.clock, device->write(indexOf(2, AxisParameter::Counter), 5)));
    EXPECT_NE(device->gate().origin(), origin);
}

TEST_F(QuadQuad2DrvAssumed, AFirstPowerLimitThatAStopOvertookGoesOutWithTheNextStart)
{
    ASSERT_TRUE(begin());
    bench.session.stream(*device).stop();
    bench.clock.advance(500ms);
    ASSERT_EQ(std::find(sent.begin(), sent.end(), setPowerLimit(1, 2048)), sent.end()) << "the stop went first";
    EXPECT_FALSE(entry(AxisParameter::LimitPower).raw);
    ASSERT_TRUE(begin());
    bench.clock.advance(100ms);
    EXPECT_TRUE(went(setPowerLimit(1, 2048), setControlMode(1, ControlMode::Power)));
    EXPECT_EQ(entry(AxisParameter::LimitPower).raw, 2048);
    EXPECT_EQ(entry(AxisParameter::LimitPower).state, ParameterState::Assumed);
}

TEST_F(QuadQuad2DrvAssumed, AFirstPowerLimitThatTheBoardDidNotAcceptGoesOutWithTheNextStart)
{
    setLoss(1.0);
    ASSERT_TRUE(begin());
    bench.clock.advance(1s);
    setLoss(0.0);
    bench.session.stream(*device).stop();
    bench.clock.advance(1s);
    EXPECT_FALSE(entry(AxisParameter::LimitPower).raw);
    sent.clear();
    (void)begin(); // tells why the motion before it ended
    bench.clock.advance(500ms);
    if (!bench.session.stream(*device).isRunning()) {
        ASSERT_TRUE(begin());
        bench.clock.advance(100ms);
    }
    EXPECT_TRUE(went(setPowerLimit(1, 2048), setControlMode(1, ControlMode::Power)));
}

TEST_F(QuadQuad2DrvAssumed, AFirstPowerLimitThatWasAcceptedIsNotSentAgain)
{
    ASSERT_TRUE(begin());
    bench.clock.advance(100ms);
    bench.session.stream(*device).stop();
    bench.clock.advance(500ms);
    sent.clear();
    ASSERT_TRUE(begin());
    bench.clock.advance(100ms);
    EXPECT_EQ(std::find(sent.begin(), sent.end(), setPowerLimit(1, 2048)), sent.end());
}

TEST_F(QuadQuad2DrvAssumed, TheOthersOfAGroupThatTheBoardDidNotAcceptStayUnknown)
{
    ASSERT_TRUE(run(bench.clock, device->write(indexOf(0, AxisParameter::LimitPower), 3000)));
    setLoss(1.0);
    EXPECT_FALSE(run(bench.clock, device->write(indexOf(0, AxisParameter::VelocityP), 250)));
    setLoss(0.0);
    EXPECT_FALSE(entry(AxisParameter::VelocityI).raw);
    EXPECT_FALSE(entry(AxisParameter::VelocityD).raw);
    ASSERT_TRUE(run(bench.clock, device->write(indexOf(0, AxisParameter::VelocityP), 250)));
    EXPECT_EQ(entry(AxisParameter::VelocityP).raw, 250);
    EXPECT_EQ(entry(AxisParameter::VelocityI).raw, 200);
    EXPECT_EQ(entry(AxisParameter::VelocityD).raw, 500);
}

} // namespace
} // namespace mb::quadquad2drv
