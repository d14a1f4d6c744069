// SPDX-License-Identifier: GPL-3.0-or-later
// The controller against the simulated board, in virtual time.
#include "families/quadquad2drv/channels.h"
#include "families/quadquad2drv/packetport.h"
#include "families/quadquad2drv/parameters.h"
#include "families/quadquad2drv/protocol.h"
#include "model/parametertransfer.h"
#include "model/snapshot.h"
#include "support/simulatedsession.h"
#include "transport/backends/virtualspi.h"

#include <cmath>
#include <iostream>

namespace mb::quadquad2drv {
namespace {

using namespace std::chrono_literals;
using test::run;
using test::SimulatedSession;

struct QuadQuad2Drv : testing::Test {
    QuadQuad2Drv()
        : QuadQuad2Drv("sim:spi")
    {
    }
    explicit QuadQuad2Drv(std::string_view address)
        : bench(address)
    {
        bench.scan();
        device = bench.device(0, "quadquad2drv");
        board = bench.simulator("quadquad2drv:0");
    }
    void SetUp() override { ASSERT_NE(device, nullptr); }
    [[nodiscard]] double last(int axis, AxisChannel channel) const
    {
        return device->telemetry()->latest(channelOf(axis, channel)).value_or(Point{}).value;
    }
    SimulatedSession bench;
    Device *device = nullptr;
    Simulator *board = nullptr;
};

SetPoint setPoint(Mode mode, double target, int axis = 1)
{
    SetPoint made;
    made.mode = mode;
    made.target = target;
    made.axis = axis;
    return made;
}

TEST_F(QuadQuad2Drv, ScanNamesVersionAndProtocol)
{
    EXPECT_EQ(device->identity().firmware, "1.3");
    EXPECT_EQ(device->identity().dialect, "protocol 1");
    EXPECT_EQ(device->selector(), "sim:spi/quadquad2drv:0");
}

TEST_F(QuadQuad2Drv, PositionAndVelocityComeAHundredTimesASecondWithoutAskingForAStream)
{
    bench.clock.advance(5s);
    EXPECT_TRUE(device->liveness().heard);
    EXPECT_NEAR(device->telemetry()->rate(channelOf(0, AxisChannel::Position), device->clock().now()), 100.0, 5.0);
    EXPECT_NEAR(device->telemetry()->rate(channelOf(3, AxisChannel::Velocity), device->clock().now()), 100.0, 5.0);
}

TEST_F(QuadQuad2Drv, StreamsFiveHundredTimesASecondAndLosesNothing)
{
    ASSERT_TRUE(run(bench.clock, device->setRate(channelOf(0, AxisChannel::Position), 500.0)));
    const auto before = device->telemetry()->size(channelOf(0, AxisChannel::Position));
    bench.clock.advance(10s);
    const auto got = device->telemetry()->size(channelOf(0, AxisChannel::Position)) - before;
    EXPECT_NEAR(static_cast<double>(got), 10.0 / 0.00200704, 5.0);
    EXPECT_EQ(device->telemetry()->lost(channelOf(0, AxisChannel::Position)), 0U);
}

TEST_F(QuadQuad2Drv, TheSameWishOnceMoreLeavesTheLinesWhole)
{
    const ChannelIndex position = channelOf(0, AxisChannel::Position);
    ASSERT_TRUE(run(bench.clock, device->setRate(position, 500.0)));
    bench.clock.advance(500ms);
    device->telemetry()->commit();
    const Instant from = bench.clock.now();
    bench.clock.advance(100ms);
    ASSERT_TRUE(run(bench.clock, device->setRate(position, 500.0)));
    ASSERT_TRUE(run(bench.clock, device->setRate(channelOf(2, AxisChannel::Velocity), 100.0))) << "less than there is";
    bench.clock.advance(100ms);
    device->telemetry()->commit();
    EXPECT_TRUE(device->telemetry()->gaps(position, from, bench.clock.now()).empty());
    ASSERT_TRUE(run(bench.clock, device->setRate(position, 250.0)));
    bench.clock.advance(100ms);
    device->telemetry()->commit();
    EXPECT_EQ(device->telemetry()->gaps(position, from, bench.clock.now()).size(), 1U);
}

TEST_F(QuadQuad2Drv, TheStreamGoesOnWhileParametersAreRead)
{
    ASSERT_TRUE(run(bench.clock, device->setRate(channelOf(0, AxisChannel::Position), 500.0)));
    bench.clock.advance(1s);
    const auto before = device->telemetry()->size(channelOf(0, AxisChannel::Position));
    const Instant begin = bench.clock.now();
    NoProgress progress;
    for (int i = 0; i < 20; ++i) {
        const auto outcomes = run(bench.clock, readParameters(*device, readable(*device), progress));
        ASSERT_TRUE(outcomes);
        for (const TransferOutcome &outcome : *outcomes)
            EXPECT_TRUE(outcome.raw);
    }
    bench.clock.advance(10ms);
    const double seconds = std::chrono::duration<double>(bench.clock.now() - begin).count();
    const auto got = static_cast<double>(device->telemetry()->size(channelOf(0, AxisChannel::Position)) - before
        + device->telemetry()->lost(channelOf(0, AxisChannel::Position)));
    EXPECT_NEAR(got, seconds / 0.00200704, 3.0);
    EXPECT_EQ(device->telemetry()->lost(channelOf(0, AxisChannel::Position)), 0U);
}

TEST_F(QuadQuad2Drv, TheFirstMotionIsLimitedToAQuarterOfThePower)
{
    SetPointStream &stream = bench.session.stream(*device);
    bench.clock.advance(200ms);
    ASSERT_TRUE(stream.start(setPoint(Mode::Duty, 1.0), 10s));
    bench.clock.advance(2s);
    const double limited = last(0, AxisChannel::Velocity);
    EXPECT_GT(limited, 500.0);
    EXPECT_LT(limited, 2500.0) << "full power is 8200 counts/s";
    const auto &limit = device->parameters().entry(indexOf(0, AxisParameter::LimitPower));
    EXPECT_EQ(limit.raw, 2048);
    EXPECT_EQ(limit.state, ParameterState::Assumed);
}

TEST_F(QuadQuad2Drv, TakingPositionModeDoesNotMoveTheMotor)
{
    SetPointStream &stream = bench.session.stream(*device);
    bench.clock.advance(200ms);
    ASSERT_TRUE(stream.start(setPoint(Mode::Duty, 0.5), 10s));
    bench.clock.advance(1s);
    stream.stop();
    bench.clock.advance(1s);
    const double here = last(0, AxisChannel::Position);
    ASSERT_GT(std::abs(here), 100.0);
    ASSERT_TRUE(stream.start(setPoint(Mode::Position, here), 10s));
    double furthest = 0.0;
    for (int i = 0; i < 100; ++i) {
        bench.clock.advance(10ms);
        furthest = std::max(furthest, std::abs(last(0, AxisChannel::Position) - here));
    }
    EXPECT_LE(furthest, 3.0);
}

TEST_F(QuadQuad2Drv, AnAxisOfWhichAnotherProgramLeftLessThanThePositionIsNotMovedByTakingPositionMode)
{
    PacketPort other(static_cast<SpiLink &>(*bench.link), bench.clock);
    ASSERT_TRUE(run(bench.clock, other.request(setPosition(0x02, 3, 150'000))));
    ASSERT_TRUE(run(bench.clock, other.request(setDataMask(0x02, 0x06))));
    bench.clock.advance(500ms);
    EXPECT_FALSE(bench.session.stream(*device).start(setPoint(Mode::Position, 0.0, 2), 1s));
    bench.clock.advance(500ms);
    ASSERT_TRUE(bench.session.stream(*device).start(setPoint(Mode::Position, 150'000.0, 2), 1s));
    bench.clock.advance(500ms);
    EXPECT_NEAR(last(1, AxisChannel::Position), 150'000.0, 3.0);
}

TEST_F(QuadQuad2Drv, AModeIsTakenAfterAnOrderToStayWhereItIs)
{
    for (const auto &[mode, rest, code] : {std::tuple{Mode::Duty, setPower(1, 0), ControlMode::Power},
             {Mode::Velocity, setVelocityTarget(1, 0.0, {}), ControlMode::Velocity},
             {Mode::Position, setPositionTarget(1, 0), ControlMode::Position}}) {
        SimulatedSession fresh("sim:spi");
        fresh.scan();
        Device *other = fresh.device(0, "quadquad2drv");
        fresh.clock.advance(500ms);
        std::vector<Bytes> sent;
        const Subscription hearing = fresh.link->traffic().add([&sent](const Traffic &traffic) {
            if (traffic.direction == Direction::Sent && traffic.bytes.size() > 4 && traffic.bytes[2] >= 16)
                sent.emplace_back(traffic.bytes.begin(), traffic.bytes.end());
        });
        ASSERT_TRUE(fresh.session.stream(*other).start(setPoint(mode, 0.1), 1s));
        fresh.clock.advance(300ms);
        const auto taken = std::find(sent.begin(), sent.end(), setControlMode(1, code));
        ASSERT_NE(taken, sent.end()) << toString(mode);
        ASSERT_GT(taken - sent.begin(), 0);
        EXPECT_EQ(*std::prev(taken), rest) << toString(mode);
    }
}

TEST_F(QuadQuad2Drv, EachAxisGoesToItsOwnPositionAtOnce)
{
    SetPointStream &stream = bench.session.stream(*device);
    bench.clock.advance(200ms);
    ASSERT_TRUE(stream.start(setPoint(Mode::Position, 500.0, 1), 20s));
    for (int axis = 2; axis <= axes; ++axis)
        ASSERT_TRUE(stream.update(setPoint(Mode::Position, 500.0 * axis, axis)));
    bench.clock.advance(6s);
    for (int axis = 1; axis <= axes; ++axis)
        // the default windup does not overcome the stiction of the small motor on axis 2
        EXPECT_NEAR(last(axis - 1, AxisChannel::Position), 500.0 * axis, axis == 2 ? 80.0 : 25.0) << "axis " << axis;
    stream.stop();
    bench.clock.advance(5ms);
    EXPECT_FALSE(board->isOutputOn()) << "all four are off at once";
    bench.clock.advance(300ms);
    EXPECT_TRUE(device->isSeenStopped());
}

TEST_F(QuadQuad2Drv, OneAxisCanBeTakenOutWhileAnotherRuns)
{
    SetPointStream &stream = bench.session.stream(*device);
    bench.clock.advance(200ms);
    ASSERT_TRUE(stream.start(setPoint(Mode::Duty, 0.5, 1), 20s));
    ASSERT_TRUE(stream.update(setPoint(Mode::Duty, 0.5, 2)));
    bench.clock.advance(1s);
    EXPECT_GT(last(1, AxisChannel::Velocity), 300.0);
    ASSERT_TRUE(stream.update(setPoint(Mode::Off, 0.0, 2)));
    bench.clock.advance(3s);
    EXPECT_NEAR(last(1, AxisChannel::Velocity), 0.0, 4.0);
    EXPECT_GT(last(0, AxisChannel::Velocity), 300.0);
}

TEST_F(QuadQuad2Drv, EachAxisTellsWhatItIsToldAndWhetherItMoves)
{
    SetPointStream &stream = bench.session.stream(*device);
    bench.clock.advance(200ms);
    ASSERT_TRUE(stream.start(setPoint(Mode::Duty, 0.5, 1), 20s));
    ASSERT_TRUE(stream.update(setPoint(Mode::Velocity, 300.0, 3)));
    bench.clock.advance(500ms);
    const std::vector<AxisLiveness> &all = device->liveness().axes;
    ASSERT_EQ(all.size(), 4U);
    EXPECT_EQ(all[0], (AxisLiveness{Mode::Duty, true}));
    EXPECT_EQ(all[1], (AxisLiveness{Mode::Off, false}));
    EXPECT_EQ(all[2], (AxisLiveness{Mode::Velocity, true}));
    const DeviceView view = viewOf(bench.session, *device);
    ASSERT_NE(view.motion.on(3), nullptr);
    EXPECT_EQ(view.motion.on(3)->target, 300.0);
    EXPECT_EQ(view.motion.on(2), nullptr);
    stream.stop();
    EXPECT_EQ(viewOf(bench.session, *device).motion.on(3), nullptr);
}

TEST_F(QuadQuad2Drv, SetPointsAreRecordedForEachAxisAndEndWithTheMotion)
{
    SetPointStream &stream = bench.session.stream(*device);
    bench.clock.advance(200ms);
    ASSERT_TRUE(stream.start(setPoint(Mode::Velocity, 200.0, 1), 20s));
    ASSERT_TRUE(stream.update(setPoint(Mode::Velocity, 400.0, 2)));
    bench.clock.advance(500ms);
    EXPECT_EQ(last(0, AxisChannel::SetPoint), 200.0);
    EXPECT_EQ(last(1, AxisChannel::SetPoint), 400.0);
    EXPECT_GE(device->telemetry()->size(channelOf(1, AxisChannel::SetPoint)), 9U) << "one a command period of 50 ms";
    EXPECT_EQ(device->telemetry()->size(channelOf(3, AxisChannel::SetPoint)), 0U);
    stream.stop();
    bench.clock.advance(500ms);
    ASSERT_TRUE(stream.start(setPoint(Mode::Velocity, 100.0, 2), 20s));
    bench.clock.advance(200ms);
    const auto gaps = device->telemetry()->gaps(channelOf(1, AxisChannel::SetPoint), Instant{}, bench.clock.now());
    EXPECT_EQ(gaps.size(), 1U) << "in between nothing was wished for";
    EXPECT_EQ(device->telemetry()->lost(channelOf(1, AxisChannel::SetPoint)), 0U);
}

TEST_F(QuadQuad2Drv, AStopLosesNoneOfTheStreamAroundIt)
{
    ASSERT_TRUE(run(bench.clock, device->setRate(channelOf(0, AxisChannel::Position), 500.0)));
    bench.clock.advance(1s);
    const auto before = device->telemetry()->size(channelOf(0, AxisChannel::Position));
    const Instant begin = bench.clock.now();
    for (int i = 0; i < 100; ++i) {
        device->stop();
        bench.clock.advance(7ms + std::chrono::microseconds(37 * i));
    }
    const double seconds = std::chrono::duration<double>(bench.clock.now() - begin).count();
    const auto got = static_cast<double>(device->telemetry()->size(channelOf(0, AxisChannel::Position)) - before
        + device->telemetry()->lost(channelOf(0, AxisChannel::Position)));
    EXPECT_NEAR(got, seconds / 0.00200704, 3.0);
}

TEST_F(QuadQuad2Drv, AGainTravelsWithTheOthersOfItsGroupWhichAreAssumedFromThenOn)
{
    NoProgress progress;
    const ParameterIndex p = indexOf(1, AxisParameter::PositionP);
    const auto outcomes = run(bench.clock, writeParameters(*device, {{p, 250}}, progress));
    ASSERT_TRUE(outcomes);
    EXPECT_FALSE(outcomes->front().verified.has_value()) << "it cannot be read back";
    EXPECT_EQ(device->parameters().entry(p).state, ParameterState::Assumed);
    EXPECT_EQ(device->parameters().entry(indexOf(1, AxisParameter::PositionWindup)).raw, 600);
    EXPECT_FALSE(device->parameters().entry(indexOf(0, AxisParameter::PositionP)).raw) << "another axis";
    EXPECT_FALSE(run(bench.clock, device->read(p)));
}

TEST_F(QuadQuad2Drv, AResetIsNoticedAndEndsTheMotion)
{
    SetPointStream &stream = bench.session.stream(*device);
    bench.clock.advance(200ms);
    ASSERT_TRUE(stream.start(setPoint(Mode::Duty, 0.5), 20s));
    bench.clock.advance(1s);
    board->setPowered(false);
    board->setPowered(true);
    bench.clock.advance(1500ms);
    EXPECT_FALSE(stream.isRunning());
    EXPECT_TRUE(device->liveness().restarted);
    EXPECT_FALSE(device->parameters().entry(indexOf(0, AxisParameter::LimitPower)).raw);
    ASSERT_TRUE(run(bench.clock, device->refresh()));
    EXPECT_FALSE(device->liveness().restarted);
}

TEST_F(QuadQuad2Drv, AWrongTargetIsRefusedAndNothingIsSent)
{
    EXPECT_EQ(device->check(setPoint(Mode::Duty, 1.5)).error().fault, Fault::OutOfRange);
    EXPECT_EQ(device->check(setPoint(Mode::Velocity, 100'001.0)).error().fault, Fault::OutOfRange);
    EXPECT_EQ(device->check(setPoint(Mode::Position, 3e9)).error().fault, Fault::OutOfRange);
    EXPECT_EQ(device->check(setPoint(Mode::Duty, 0.1, 5)).error().fault, Fault::OutOfRange);
    EXPECT_EQ(device->check(setPoint(Mode::Duty, std::nan(""))).error().fault, Fault::OutOfRange);
    EXPECT_EQ(device->check(setPoint(Mode::Current, 1.0)).error().fault, Fault::Unsupported);
}

TEST_F(QuadQuad2Drv, ARampIsSentOnceAndArrivesWithItsVelocity)
{
    SetPointStream &stream = bench.session.stream(*device);
    bench.clock.advance(200ms);
    SetPoint ramp = setPoint(Mode::RampPosition, 2000.0);
    ramp.velocity = 1000.0;
    ramp.acceleration = 4000.0;
    ASSERT_TRUE(stream.start(ramp, 20s));
    double fastestSeen = 0.0;
    for (int i = 0; i < 500; ++i) {
        bench.clock.advance(10ms);
        fastestSeen = std::max(fastestSeen, last(0, AxisChannel::Velocity));
    }
    EXPECT_NEAR(last(0, AxisChannel::Position), 2000.0, 20.0);
    EXPECT_NEAR(fastestSeen, 1000.0, 150.0);
}

TEST_F(QuadQuad2Drv, MotionIsPolledAtNineTenthsOfTheWireLimit)
{
    bench.clock.advance(100ms);
    auto &spi = static_cast<SpiLink &>(*bench.link);
    (void)spi;
    PacketPort port(spi, bench.clock);
    const Instant begin = bench.clock.now();
    constexpr int polls = 500;
    for (int i = 0; i < polls; ++i)
        ASSERT_TRUE(run(bench.clock, port.request(getRequest(PacketId::GetMotion))));
    const double hertz = polls / std::chrono::duration<double>(bench.clock.now() - begin).count();
    constexpr double wireLimit = 1e6 / 656.0; // quadquad2drv/README.md#ready-line: 4 + 37 bytes at 500 kHz
    std::cout << "motion polled " << hertz << " times a second, wire limit " << wireLimit << '\n';
    EXPECT_GE(hertz, 0.9 * wireLimit);
}

TEST_F(QuadQuad2Drv, IsHeardUntilItHasBeenSilentForThreeTenthsOfASecond)
{
    bench.clock.advance(1s);
    ASSERT_TRUE(device->liveness().heard);
    ASSERT_EQ(device->liveness().axes.size(), 4U);
    EXPECT_EQ(device->liveness().axes[3].mode, Mode::Off);
    board->setPowered(false);
    bench.clock.advance(280ms);
    EXPECT_TRUE(device->liveness().heard);
    bench.clock.advance(130ms);
    EXPECT_FALSE(device->liveness().heard);
    EXPECT_FALSE(device->liveness().axes[3].mode) << "nobody knows";
    board->setPowered(true);
    bench.clock.advance(500ms);
    EXPECT_TRUE(device->liveness().heard);
    bench.link->close();
    EXPECT_FALSE(device->liveness().heard) << "at once";
    ASSERT_TRUE(bench.link->open());
    bench.clock.advance(500ms);
    EXPECT_TRUE(device->liveness().heard);
}

TEST_F(QuadQuad2Drv, NoLineLeadsAcrossASilence)
{
    const ChannelIndex position = channelOf(0, AxisChannel::Position);
    const auto gaps = [&] {
        device->telemetry()->commit();
        return device->telemetry()->gaps(position, Instant{}, bench.clock.now()).size();
    };
    bench.clock.advance(1s);
    const auto before = gaps();
    board->setPowered(false);
    bench.clock.advance(2s);
    board->setPowered(true);
    bench.clock.advance(500ms);
    ASSERT_TRUE(device->liveness().heard);
    EXPECT_EQ(gaps(), before + 1);
    bench.link->close();
    bench.clock.advance(2s);
    ASSERT_TRUE(bench.link->open());
    bench.clock.advance(500ms);
    EXPECT_EQ(gaps(), before + 2);
}

TEST_F(QuadQuad2Drv, AResetIsNoticedWhereNothingWasToldBesideAStream)
{
    const ChannelIndex position = channelOf(0, AxisChannel::Position);
    ASSERT_TRUE(run(bench.clock, device->setRate(position, 100.0)));
    bench.clock.advance(1s);
    ASSERT_FALSE(device->liveness().restarted);
    board->setPowered(false);
    board->setPowered(true);
    bench.clock.advance(1s);
    EXPECT_TRUE(device->liveness().restarted);
    EXPECT_TRUE(device->liveness().heard) << "it is asked again";
    EXPECT_NEAR(device->telemetry()->rate(position, device->clock().now()), 100.0, 15.0);
}

TEST_F(QuadQuad2Drv, WhatAnotherProgramMakesTheBoardSendIsReadAsItIsSent)
{
    PacketPort other(static_cast<SpiLink &>(*bench.link), bench.clock);
    const ChannelIndex position = channelOf(0, AxisChannel::Position);
    const ChannelIndex velocity = channelOf(0, AxisChannel::Velocity);
    const auto got = [this](ChannelIndex channel) {
        const auto before = device->telemetry()->size(channel);
        bench.clock.advance(1s);
        return device->telemetry()->size(channel) - before;
    };
    bench.clock.advance(1s);
    ASSERT_TRUE(run(bench.clock, other.request(setDataMask(0x0F, 0x22))));
    bench.clock.advance(1s);
    EXPECT_TRUE(device->liveness().heard);
    EXPECT_FALSE(device->liveness().restarted) << "a board that was reset sends something else";
    EXPECT_NEAR(static_cast<double>(got(position)), 100.0, 5.0);
    EXPECT_EQ(got(velocity), 0U);
    ASSERT_TRUE(run(bench.clock, other.request(setDataMask(0x0F, 0x2B))));
    bench.clock.advance(1s);
    EXPECT_TRUE(device->liveness().heard);
    EXPECT_NEAR(static_cast<double>(got(velocity)), 100.0, 5.0);
}

TEST_F(QuadQuad2Drv, AStreamIsAskedForInUnitsOfItsClockAndNobodyPollsMeanwhile)
{
    std::vector<Bytes> sent;
    const Subscription hearing = bench.link->traffic().add([&sent](const Traffic &traffic) {
        if (traffic.direction == Direction::Sent)
            sent.emplace_back(traffic.bytes.begin(), traffic.bytes.end());
    });
    const auto count = [&sent](const Bytes &packet) { return std::count(sent.begin(), sent.end(), packet); };
    const ChannelIndex position = channelOf(0, AxisChannel::Position);
    bench.clock.advance(100ms);
    EXPECT_NEAR(static_cast<double>(count(getRequest(PacketId::GetMotion))), 10.0, 1.0);
    struct Row {
        double hertz;
        std::uint16_t units;
    };
    for (const Row &row : {Row{1e6, 49}, {100.0, 244}, {1.0, 24414}, {0.01, 65535}}) {
        sent.clear();
        ASSERT_TRUE(run(bench.clock, device->setRate(position, row.hertz))) << row.hertz;
        EXPECT_EQ(count(setStreamPeriod(row.units)), 1) << row.hertz;
        EXPECT_EQ(count(setStreamConfig(2)), 1) << row.hertz;
        sent.clear();
        bench.clock.advance(200ms);
        EXPECT_EQ(count(getRequest(PacketId::GetMotion)), 0) << row.hertz;
    }
    sent.clear();
    ASSERT_TRUE(run(bench.clock, device->setRate(position, 0.0)));
    EXPECT_EQ(count(setStreamPeriod(0)), 1);
    EXPECT_EQ(count(setStreamConfig(2)), 0);
    sent.clear();
    bench.clock.advance(100ms);
    EXPECT_NEAR(static_cast<double>(count(getRequest(PacketId::GetMotion))), 10.0, 1.0);
}

TEST_F(QuadQuad2Drv, ALostLinkEndsATransferWithTheFirstParameter)
{
    bench.link->close();
    NoProgress progress;
    const auto read = run(bench.clock, readParameters(*device, readable(*device), progress));
    ASSERT_TRUE(read);
    ASSERT_EQ(read->size(), 1U);
    EXPECT_EQ(read->front().raw.error().fault, Fault::LinkLost);
}

TEST_F(QuadQuad2Drv, ADutyIsBetweenAllBackwardsAndAllForwards)
{
    bench.clock.advance(500ms);
    for (const double duty : {-1.01, 1.01, 2.0, -2.0})
        EXPECT_EQ(device->command(setPoint(Mode::Duty, duty)).error().fault, Fault::OutOfRange) << duty;
    for (const double duty : {-1.0, 1.0})
        EXPECT_TRUE(device->command(setPoint(Mode::Duty, duty))) << duty;
}

TEST_F(QuadQuad2Drv, WhatItCannotDoIsSaidAndNothingIsSent)
{
    NoProgress progress;
    const auto faultOf = [](const auto &result) { return result ? std::optional<Fault>() : result.error().fault; };
    EXPECT_EQ(faultOf(run(bench.clock, device->store(progress))), Fault::Unsupported);
    EXPECT_EQ(faultOf(run(bench.clock, device->identify())), Fault::Unsupported);
    EXPECT_EQ(faultOf(run(bench.clock, device->rename("board"))), Fault::Unsupported);
    EXPECT_EQ(faultOf(run(bench.clock, device->renumber(2))), Fault::Unsupported);
}

TEST_F(QuadQuad2Drv, ItsStopScriptTakesAllAxesOutThreeTimes)
{
    const StopScript script = device->stopScript();
    ASSERT_EQ(script.steps.size(), 1U);
    EXPECT_EQ(script.steps[0].bytes, (Bytes{0x02, 0x06, 0x10, 0x0F, 0x00, 0xD9}));
    EXPECT_EQ(script.steps[0].wait, 10ms);
    EXPECT_EQ(script.steps[0].attempts, 3);
}

} // namespace
} // namespace mb::quadquad2drv
