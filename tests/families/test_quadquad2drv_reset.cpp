// SPDX-License-Identifier: GPL-3.0-or-later
// A board that was reset: what was written to it is unknown, kept, and written again. On virtual time.
#include "families/quadquad2drv/channels.h"
#include "families/quadquad2drv/codec.h"
#include "families/quadquad2drv/parameters.h"
#include "model/operation.h"
#include "model/parameterfile.h"
#include "model/parametertransfer.h"
#include "support/simulatedsession.h"
#include "transport/backends/virtualspi.h"

#include <algorithm>

namespace mb::quadquad2drv {
namespace {

using namespace std::chrono_literals;
using test::run;
using test::SimulatedSession;

struct QuadQuad2DrvReset : testing::Test {
    QuadQuad2DrvReset()
        : bench("sim:spi")
    {
        bench.scan();
        device = bench.device(0, "quadquad2drv");
        board = bench.simulator("quadquad2drv:0");
        heard = bench.link->traffic().add([this](const Traffic &traffic) {
            if (traffic.direction == Direction::Sent)
                sent.emplace_back(traffic.bytes.begin(), traffic.bytes.end());
        });
    }
    void SetUp() override { ASSERT_NE(device, nullptr); }
    void powerCycle() const
    {
        board->setPowered(false);
        board->setPowered(true);
    }
    void writeSome()
    {
        const std::vector<ParameterChange> changes{{indexOf(0, AxisParameter::PositionP), 250},
            {indexOf(0, AxisParameter::PositionD), 700}, {indexOf(2, AxisParameter::LimitPower), 4096},
            {indexOf(BoardParameter::HistoryLength), 8}};
        const auto outcomes = run(bench.clock, writeParameters(*device, changes, progress));
        ASSERT_TRUE(outcomes);
        ASSERT_EQ(outcomes->size(), changes.size());
    }
    [[nodiscard]] std::size_t lost() const
    {
        return lostSettings(device->family(), device->knowledge().profile()).size();
    }
    [[nodiscard]] bool hasSent(const Bytes &packet) const
    {
        return std::find(sent.begin(), sent.end(), packet) != sent.end();
    }
    /// Another run of the program: the same board, what the file kept.
    std::unique_ptr<Device> anotherRun(const DeviceProfile &kept)
    {
        auto again = device->family().open(*bench.link, bench.clock, device->identity());
        again->knowledge().setProfile(kept);
        return again;
    }
    SimulatedSession bench;
    Device *device = nullptr;
    Simulator *board = nullptr;
    NoProgress progress;
    std::vector<Bytes> sent;
    Subscription heard;
};

TEST_F(QuadQuad2DrvReset, IsNoticedWhenSettingsWereWrittenAndNothingWasDriven)
{
    writeSome();
    EXPECT_EQ(lost(), 0U);
    powerCycle();
    bench.clock.advance(1s);
    EXPECT_TRUE(device->liveness().restarted);
    EXPECT_EQ(lost(), 4U);
    EXPECT_FALSE(device->parameters().entry(indexOf(0, AxisParameter::PositionP)).raw) << "unknown until written";
}

TEST_F(QuadQuad2DrvReset, WritingAgainSendsWhatWasWrittenAndNothingIsLostAnyMore)
{
    writeSome();
    powerCycle();
    bench.clock.advance(1s);
    ASSERT_TRUE(run(bench.clock, device->refresh()));
    sent.clear();
    const auto written = run(bench.clock, rewriteSettings(*device, progress));
    ASSERT_TRUE(written) << written.error().text();
    EXPECT_EQ(*written, 4);
    EXPECT_TRUE(hasSent(setPositionGains(1, {250, 500, 700, 600})));
    EXPECT_TRUE(hasSent(setPowerLimit(4, 4096)));
    EXPECT_EQ(lost(), 0U);
    EXPECT_EQ(device->parameters().entry(indexOf(0, AxisParameter::PositionD)).state, ParameterState::Assumed);
    EXPECT_EQ(device->parameters().entry(indexOf(BoardParameter::HistoryLength)).raw, 8);
}

TEST_F(QuadQuad2DrvReset, ItIsWrittenAgainEvenBeforeAnybodyLookedAtTheBoard)
{
    writeSome();
    powerCycle();
    bench.clock.advance(1s);
    ASSERT_TRUE(device->liveness().restarted);
    const auto written = run(bench.clock, rewriteSettings(*device, progress));
    ASSERT_TRUE(written) << written.error().text();
    EXPECT_EQ(lost(), 0U);
}

TEST_F(QuadQuad2DrvReset, ASecondRunBelievesWhatWasWrittenWhileTheBoardKeptItsPower)
{
    writeSome();
    const auto again = anotherRun(device->knowledge().profile());
    bench.clock.advance(1s);
    EXPECT_TRUE(lostSettings(again->family(), again->knowledge().profile()).empty());
    EXPECT_FALSE(again->liveness().restarted);
    const auto &entry = again->parameters().entry(indexOf(0, AxisParameter::PositionP));
    EXPECT_EQ(entry.raw, 250);
    EXPECT_EQ(entry.state, ParameterState::Assumed) << "last written, never read";
}

TEST_F(QuadQuad2DrvReset, ASecondRunSeesThatTheBoardWasResetInBetween)
{
    writeSome();
    powerCycle();
    const auto again = anotherRun(device->knowledge().profile());
    ASSERT_TRUE(again->parameters().entry(indexOf(0, AxisParameter::PositionP)).raw);
    ASSERT_TRUE(run(bench.clock, again->refresh()));
    EXPECT_EQ(lostSettings(again->family(), again->knowledge().profile()).size(), 4U);
    EXPECT_FALSE(again->parameters().entry(indexOf(0, AxisParameter::PositionP)).raw);
    const auto third = anotherRun(again->knowledge().profile());
    EXPECT_FALSE(third->parameters().entry(indexOf(0, AxisParameter::PositionP)).raw) << "lost stays lost";
}

TEST_F(QuadQuad2DrvReset, TheFirstMotionAfterItIsLimitedAgain)
{
    ASSERT_TRUE(run(bench.clock, device->write(indexOf(0, AxisParameter::LimitPower), 8191)));
    powerCycle();
    bench.clock.advance(1s);
    ASSERT_TRUE(run(bench.clock, device->refresh()));
    SetPoint setPoint;
    setPoint.mode = Mode::Duty;
    setPoint.target = 1.0;
    sent.clear();
    ASSERT_TRUE(bench.session.stream(*device).start(setPoint, 10s));
    bench.clock.advance(100ms);
    EXPECT_TRUE(hasSent(setPowerLimit(1, 2048)));
}

TEST_F(QuadQuad2DrvReset, ARateThatIsStillWishedForComesBackAfterIt)
{
    const ChannelIndex position = channelOf(0, AxisChannel::Position);
    const auto rate = [&] { return device->telemetry()->rate(position, device->clock().now()); };
    ASSERT_TRUE(run(bench.clock, device->setRate(position, 500.0)));
    for (const bool byHand : {true, false}) {
        bench.clock.advance(1s);
        ASSERT_NEAR(rate(), 498.0, 10.0);
        if (byHand)
            powerCycle();
        else
            EXPECT_TRUE(run(bench.clock, device->restart()));
        bench.clock.advance(3s);
        EXPECT_NEAR(rate(), 498.0, 10.0) << byHand;
    }
    ASSERT_TRUE(run(bench.clock, device->setRate(position, 0.0)));
    powerCycle();
    bench.clock.advance(3s);
    EXPECT_NEAR(rate(), 100.0, 5.0) << "nobody wishes for another one any more";
}

TEST_F(QuadQuad2DrvReset, ARateThatCouldNotBeToldAgainIsToldLater)
{
    auto &link = static_cast<VirtualSpiLink &>(*bench.link);
    const ChannelIndex position = channelOf(0, AxisChannel::Position);
    ASSERT_TRUE(run(bench.clock, device->setRate(position, 500.0)));
    powerCycle();
    link.setLoss(0.6);
    bench.clock.advance(5s);
    ASSERT_TRUE(device->liveness().restarted);
    link.setLoss(0.0);
    bench.clock.advance(3s);
    EXPECT_NEAR(device->telemetry()->rate(position, device->clock().now()), 498.0, 10.0);
}

TEST_F(QuadQuad2DrvReset, WhatWasWrittenIsLostThoughTheRateHasComeBack)
{
    writeSome();
    ASSERT_TRUE(run(bench.clock, device->setRate(channelOf(0, AxisChannel::Position), 500.0)));
    powerCycle();
    bench.clock.advance(3s);
    EXPECT_TRUE(device->liveness().restarted);
    EXPECT_EQ(lost(), 4U);
    ASSERT_TRUE(run(bench.clock, rewriteSettings(*device, progress)));
    EXPECT_EQ(lost(), 0U);
}

TEST_F(QuadQuad2DrvReset, WritingAgainIsRefusedWhileAMotorTurns)
{
    writeSome();
    powerCycle();
    bench.clock.advance(1s);
    ASSERT_TRUE(run(bench.clock, device->refresh()));
    SetPoint setPoint;
    setPoint.mode = Mode::Duty;
    setPoint.target = 0.2;
    ASSERT_TRUE(bench.session.stream(*device).start(setPoint, 10s));
    bench.clock.advance(500ms);
    const auto written = run(bench.clock, rewriteSettings(*device, progress));
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().fault, Fault::Unsafe);
    EXPECT_EQ(lost(), 4U);
}

TEST_F(QuadQuad2DrvReset, WritingAgainCanBeCancelledHalfWayAndFinishedLater)
{
    writeSome();
    powerCycle();
    bench.clock.advance(1s);
    ASSERT_TRUE(run(bench.clock, device->refresh()));
    Operation operation(bench.clock, say("again"));
    std::optional<Result<int>> result;
    operation.run<int>(rewriteSettings(*device, operation), [&result](Result<int> end) { result = std::move(end); });
    ASSERT_TRUE(bench.clock.runUntil([&operation] { return operation.status().done == 2; }, 10s));
    EXPECT_EQ(operation.status().total, 4);
    ASSERT_TRUE(operation.cancel());
    ASSERT_TRUE(bench.clock.runUntil([&result] { return result.has_value(); }, 10s));
    EXPECT_EQ(result->error().fault, Fault::Cancelled);
    EXPECT_EQ(lost(), 2U);
    bench.clock.advance(1s);
    ASSERT_TRUE(run(bench.clock, rewriteSettings(*device, progress)));
    EXPECT_EQ(lost(), 0U);
}

TEST_F(QuadQuad2DrvReset, ASecondResetWhileItIsWrittenAgainIsOneClearError)
{
    writeSome();
    powerCycle();
    bench.clock.advance(1s);
    ASSERT_TRUE(run(bench.clock, device->refresh()));
    Operation operation(bench.clock, say("again"));
    std::optional<Result<int>> result;
    operation.run<int>(rewriteSettings(*device, operation), [&result](Result<int> end) { result = std::move(end); });
    ASSERT_TRUE(bench.clock.runUntil([&operation] { return operation.status().done == 2; }, 10s));
    board->setPowered(false);
    bench.clock.advance(50ms);
    board->setPowered(true);
    ASSERT_TRUE(bench.clock.runUntil([&result] { return result.has_value(); }, 10s));
    bench.clock.advance(1s);
    if (*result) { // the reset fell behind the last write: then nothing of it is believed either
        EXPECT_TRUE(device->liveness().restarted);
    } else {
        EXPECT_NE(result->error().text().find(" of 4 settings were written again"), std::string::npos)
            << result->error().text();
    }
    EXPECT_GE(lost(), 2U);
}

TEST_F(QuadQuad2DrvReset, AFileIsRestoredThoughNothingOnTheBoardIsPersistent)
{
    const QByteArray text = R"({"family":"quadquad2drv","device":"x","parameters":{
        "ch1.position.p":{"value":250},"history.length":{"value":8},"ch1.counter":{"value":5}}})";
    const auto file = parseParameterFile(text, device->family());
    ASSERT_TRUE(file);
    const auto changes = differences(*device, *file);
    ASSERT_EQ(changes.size(), 2U) << "the gain and the history, never the live position";
    EXPECT_EQ(changes[0].index, indexOf(0, AxisParameter::PositionP));
    EXPECT_EQ(changes[1].index, indexOf(BoardParameter::HistoryLength));
}

TEST_F(QuadQuad2DrvReset, ValuesOfAnEditedFileThatAreOutOfRangeAreNotTaken)
{
    DeviceProfile kept;
    kept.written = {{"ch1.position.p", 70000}, {"ch1.position.i", 300}, {"no.such.key", 1}, {"history.length", 1}};
    kept.lost = {"ch1.position.p", "no.such.key", "history.length"};
    const auto again = anotherRun(kept);
    EXPECT_FALSE(again->parameters().entry(indexOf(0, AxisParameter::PositionP)).raw);
    EXPECT_EQ(again->parameters().entry(indexOf(0, AxisParameter::PositionI)).raw, 300);
    EXPECT_TRUE(lostSettings(again->family(), again->knowledge().profile()).empty());
}

} // namespace
} // namespace mb::quadquad2drv
