// SPDX-License-Identifier: GPL-3.0-or-later
// What is lost or garbled between program and board.
#include "families/quadquad2drv/channels.h"
#include "families/quadquad2drv/protocol.h"
#include "model/parametertransfer.h"
#include "support/simulatedsession.h"
#include "transport/backends/virtualspi.h"

namespace mb::quadquad2drv {
namespace {

using namespace std::chrono_literals;
using test::run;
using test::SimulatedSession;

TEST(QuadQuad2DrvLoss, EveryParameterComesThroughWhenATenthOfTheTransfersIsGarbled)
{
    SimulatedSession bench("sim:spi?loss=0.1");
    bench.scan();
    Device *device = bench.device(0, "quadquad2drv");
    ASSERT_NE(device, nullptr);
    NoProgress progress;
    const auto outcomes = run(bench.clock, readParameters(*device, readable(*device), progress));
    ASSERT_TRUE(outcomes);
    for (const TransferOutcome &outcome : *outcomes)
        EXPECT_TRUE(outcome.raw) << device->parameters().parameter(outcome.index).key;
}

TEST(QuadQuad2DrvLoss, ARefreshAsksAgainForWhatCameGarbled)
{
    SimulatedSession bench("sim:spi?loss=0.1");
    bench.scan();
    Device *device = bench.device(0, "quadquad2drv");
    ASSERT_NE(device, nullptr);
    for (int i = 0; i < 30; ++i) {
        const auto refreshed = run(bench.clock, device->refresh());
        EXPECT_TRUE(refreshed) << i << ' ' << refreshed.error().text();
    }
}

TEST(QuadQuad2DrvLoss, AStreamGoesOnWhenAPacketOfItIsLost)
{
    SimulatedSession bench("sim:spi?fault=drop@300");
    bench.scan();
    Device *device = bench.device(0, "quadquad2drv");
    ASSERT_NE(device, nullptr);
    const ChannelIndex position = channelOf(0, AxisChannel::Position);
    ASSERT_TRUE(run(bench.clock, device->setRate(position, 500.0)));
    bench.clock.advance(5s);
    EXPECT_TRUE(device->liveness().heard);
    EXPECT_NEAR(device->telemetry()->rate(position, device->clock().now()), 498.0, 5.0);
}

TEST(QuadQuad2DrvLoss, ARateThatCouldNotBePutBackIsPutBackWhenTheBoardAnswersAgain)
{
    SimulatedSession bench("sim:spi");
    bench.scan();
    Device *device = bench.device(0, "quadquad2drv");
    ASSERT_NE(device, nullptr);
    auto &link = static_cast<VirtualSpiLink &>(*bench.link);
    const ChannelIndex position = channelOf(0, AxisChannel::Position);
    ASSERT_TRUE(run(bench.clock, device->setRate(position, 500.0)));
    bench.clock.advance(1s);
    link.setLoss(1.0);
    EXPECT_FALSE(run(bench.clock, device->setRate(position, 0.0)));
    link.setLoss(0.0);
    bench.clock.advance(5s);
    EXPECT_TRUE(device->liveness().heard);
    EXPECT_NEAR(device->telemetry()->rate(position, device->clock().now()), 100.0, 10.0) << "it is polled";
}

TEST(QuadQuad2DrvLoss, ABoardWhoseStreamHasEndedIsPolledThoughTheRestOfWhatItReplacedDidNotComeBack)
{
    SimulatedSession bench("sim:spi");
    bench.scan();
    Device *device = bench.device(0, "quadquad2drv");
    ASSERT_NE(device, nullptr);
    auto &link = static_cast<VirtualSpiLink &>(*bench.link);
    const ChannelIndex position = channelOf(0, AxisChannel::Position);
    ASSERT_TRUE(run(bench.clock, device->setRate(position, 500.0)));
    bench.clock.advance(1s);
    Subscription hearing = link.traffic().add([&link](const Traffic &traffic) {
        if (traffic.direction == Direction::Sent && traffic.bytes.size() > 4
            && (traffic.bytes[2] == static_cast<std::uint8_t>(PacketId::SetDataMask)
                || traffic.bytes[2] == static_cast<std::uint8_t>(PacketId::SetStreamConfig)))
            link.setLoss(1.0);
    });
    EXPECT_FALSE(run(bench.clock, device->setRate(position, 0.0)));
    hearing.reset();
    link.setLoss(0.0);
    bench.clock.advance(5s);
    EXPECT_TRUE(device->liveness().heard);
    EXPECT_NEAR(device->telemetry()->rate(position, device->clock().now()), 100.0, 10.0);
}

} // namespace
} // namespace mb::quadquad2drv
