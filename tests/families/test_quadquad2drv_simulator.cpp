// SPDX-License-Identifier: GPL-3.0-or-later
// The simulated board against literal bytes (quadquad2drv/README.md#vectors) from the other side.
#include "async/virtualclock.h"
#include "families/quadquad2drv/codec.h"
#include "families/quadquad2drv/simulatorboard.h"
#include "families/quadquad2drvbytes.h"
#include "transport/backends/virtualspi.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace mb::quadquad2drv::simulation {
namespace {

using namespace std::chrono_literals;
using test::bytesOf;
using test::textOf;

struct Bench {
    explicit Bench(const std::string &unit = "quadquad2drv:0")
        : link(*LinkAddress::parse("sim:spi"))
    {
        (void)link.open();
        board = std::make_unique<Board>(
            link, clock, *BoardOptions::parse(*SimulatedUnit::parse(unit)), [](std::string_view, double) {});
    }
    /// Sends a request, lets the board think, clocks out what is ready.
    std::string ask(std::string_view request)
    {
        std::vector<std::uint8_t> mosi = bytesOf(request);
        std::vector<std::uint8_t> miso(mosi.size());
        board->transfer(mosi, miso);
        clock.advance(100us);
        return fetch();
    }
    std::string fetch()
    {
        std::vector<std::uint8_t> all;
        while (board->isReady()) {
            const std::uint8_t filler = 0;
            std::uint8_t byte = 0;
            board->transfer({&filler, 1}, {&byte, 1});
            all.push_back(byte);
        }
        return textOf(all);
    }
    VirtualClock clock;
    VirtualSpiSlaveLink link;
    std::unique_ptr<Board> board;
};

TEST(QuadQuad2DrvSimulator, AnswersWithTheBytesOfTheReference)
{
    Bench bench;
    EXPECT_EQ(bench.ask("02 04 01 F9"), "02 08 01 00 01 03 01 F0");
    EXPECT_EQ(bench.ask("02 06 10 00 00 E8"), "02 05 10 00 E9");
    EXPECT_EQ(bench.ask("02 04 0D ED"), "02 07 0D 00 1F 14 B7");
    EXPECT_EQ(bench.ask("02 06 04 13 13 CE"), "02 05 04 00 F5");
    EXPECT_EQ(bench.ask("02 04 05 F5"), "02 07 05 00 13 13 CC");
    EXPECT_EQ(bench.ask("02 04 07 F3"), "02 09 07 00 0B 0B 0B 0B C2");
}

TEST(QuadQuad2DrvSimulator, AcceptsEverySettingOfTheReference)
{
    for (const std::string_view request : {"02 06 04 00 00 F4", "02 08 06 01 0B 0E 00 D6",
             "02 0D 0A 21 FE FF 32 A0 86 01 00 08 68", "02 0E 0E 01 19 00 00 00 00 00 00 FE 00 CA", "02 06 10 0F 00 D9",
             "02 07 12 01 30 F8 BC", "02 09 16 02 30 F8 FF FF B7", "02 07 18 01 D0 07 07", "02 09 1A 01 00 08 00 00 D2",
             "02 09 1C 01 00 00 7D 00 5B", "02 0D 1E 01 64 00 F4 01 F4 01 58 02 2A",
             "02 0B 20 01 64 00 C8 00 F4 01 B1"}) {
        Bench bench;
        const auto id = bytesOf(request)[2];
        const std::vector<std::uint8_t> head{0x02, 0x05, id, 0x00};
        EXPECT_EQ(bench.ask(request).substr(0, 11), textOf(head)) << request;
    }
}

TEST(QuadQuad2DrvSimulator, PositionsComeInTheWidthsAskedFor)
{
    Bench bench;
    bench.ask("02 0D 0A 21 FE FF 32 A0 86 01 00 08 68"); // S11: ch1 −2, ch2 100000, ch4 0
    EXPECT_EQ(bench.ask("02 08 0B 01 02 03 00 E5"), "02 0C 0B 00 FE A0 86 00 00 00 00 C3");
}

TEST(QuadQuad2DrvSimulator, AnUnknownCommandAndAWrongLengthAreRefused)
{
    Bench bench;
    EXPECT_EQ(bench.ask("02 04 63 97"), "02 05 63 F6 A0");
    EXPECT_EQ(bench.ask("02 05 10 0F DA"), "02 05 10 F4 F5");
    EXPECT_EQ(bench.ask("02 07 18 01 00 20 BE"), "02 05 18 F5 EC") << "8192 is above full power";
}

TEST(QuadQuad2DrvSimulator, ARefusedVelocityTargetIsNotObeyed)
{
    Bench bench;
    bench.ask("02 06 10 01 03 E4"); // velocity mode
    EXPECT_EQ(bench.ask("02 09 16 01 00 10 27 00 A7").substr(0, 11), "02 05 16 F5") << "2 560 000 is too fast";
    EXPECT_EQ(bench.board->axis(0).settings.velocityTarget, 0.0);
    bench.clock.advance(100ms);
    EXPECT_EQ(bench.board->axis(0).output(), 0.0);
}

TEST(QuadQuad2DrvSimulator, AnUnreadStreamPacketBlocksNewerOnesWhichAreCounted)
{
    Bench bench;
    bench.ask("02 05 08 02 EF");    // elapsed
    bench.ask("02 06 04 F4 00 00"); // 10 ms
    bench.clock.advance(55ms);
    const auto packet = bytesOf(bench.fetch());
    ASSERT_EQ(packet.size(), 37U);
    EXPECT_EQ(packet[2], 3);
    bench.clock.advance(11ms);
    const auto next = bytesOf(bench.fetch());
    ASSERT_EQ(next.size(), 37U);
    EXPECT_EQ(next[3], 4) << "periods that found the first one unread";
}

TEST(QuadQuad2DrvSimulator, PowerTurnsTheMotorAndTheLimitHoldsIt)
{
    Bench bench;
    bench.ask("02 06 10 01 01 E6");    // power mode
    bench.ask("02 07 12 01 FF 1F C6"); // full
    bench.clock.advance(1s);
    const double fast = bench.board->axis(0).motor().countSpeed();
    EXPECT_GT(fast, 5000.0);
    bench.ask("02 07 18 01 D0 07 07"); // 2000 of 8191
    bench.clock.advance(1s);
    EXPECT_LT(bench.board->axis(0).motor().countSpeed(), 0.35 * fast);
    EXPECT_EQ(bench.ask("02 06 10 0F 00 D9"), "02 05 10 00 E9");
    bench.clock.advance(2ms);
    EXPECT_EQ(bench.board->axis(0).output(), 0.0);
}

TEST(QuadQuad2DrvSimulator, DefaultGainsSettleInBothLoops)
{
    for (int axis = 0; axis < axes; ++axis) {
        Bench bench;
        Axis &a = bench.board->axis(axis);
        a.settings.accelerationLimit = 20'000U << 12U;
        a.settings.positionTarget = 2000;
        a.setMode(ControlMode::Position);
        bench.clock.advance(3s);
        // the default windup of 600 is less than the friction of the geared motors
        EXPECT_NEAR(a.counter(), 2000, 20) << "axis " << axis + 1;
        a.settings.velocityTarget = 2000;
        a.setMode(ControlMode::Velocity);
        bench.clock.advance(3s);
        EXPECT_NEAR(a.velocity(), 2000, 60) << "axis " << axis + 1;
    }
}

TEST(QuadQuad2DrvSimulator, VelocityComesInStepsOfFour)
{
    Bench bench;
    bench.ask("02 06 10 01 01 E6");
    bench.ask("02 07 12 01 D0 07 0D");
    for (int i = 0; i < 50; ++i) {
        bench.clock.advance(7ms);
        EXPECT_EQ(bench.board->axis(0).velocity() % 4, 0);
    }
}

TEST(QuadQuad2DrvSimulator, AHomeSwitchSetsTheCounterAsTheVendorsDemoSaysItDoes)
{
    Bench bench;
    bench.ask("02 0D 0A 21 FE FF 32 A0 86 01 00 08 68");
    bench.ask("02 0E 0E 01 19 00 00 00 00 00 00 FE 00 CA"); // cfg 0x19: touching ground zeroes the counter
    bench.clock.advance(10ms);
    EXPECT_EQ(bench.board->axis(0).counter(), -2);
    bench.board->axis(0).setInputLevel(false);
    bench.clock.advance(10ms);
    EXPECT_EQ(bench.board->axis(0).counter(), 0);
    EXPECT_NE(bench.board->axis(0).takeStatus() & status::inputActive, 0);
}

/// Packets 26 and 28 act in both PID modes, and ramps obey them.
struct Ordered {
    const char *what;
    ControlMode mode;
    Bytes target;
};

void give(Bench &bench, const Ordered &order, unsigned velocityLimit, unsigned accelerationLimit)
{
    for (const Bytes &packet : {setVelocityLimit(1, velocityLimit << 12U),
             setAccelerationLimit(1, accelerationLimit << 12U), setControlMode(1, order.mode), order.target})
        EXPECT_EQ(bytesOf(bench.ask(textOf(packet))).at(3), 0) << order.what;
}

TEST(QuadQuad2DrvSimulator, NoPidModeAndNoRampIsFasterThanTheVelocityLimitNorThanItsRamp)
{
    for (const auto &[order, limit] :
        {std::pair{Ordered{"velocity", ControlMode::Velocity, setVelocityTarget(1, -2000.0, {})}, 500U},
            {{"position", ControlMode::Position, setPositionTarget(1, -30000)}, 500U},
            {{"ramp beyond the limit", ControlMode::Position, rampPosition(1, -30000, 1000.0, 100'000.0)}, 500U},
            {{"ramp below the limit", ControlMode::Position, rampPosition(1, -30000, 500.0, 100'000.0)}, 1000U}}) {
        Bench bench;
        give(bench, order, limit, 0);
        bench.clock.advance(2500ms);
        for (int i = 0; i < 20; ++i) {
            EXPECT_NEAR(bench.board->axis(0).velocity(), -500, 40) << order.what;
            bench.clock.advance(50ms);
        }
    }
}

TEST(QuadQuad2DrvSimulator, NoPidModeAndNoRampGainsSpeedFasterThanTheAccelerationLimitNorThanItsRamp)
{
    for (const auto &[order, limit] :
        {std::pair{Ordered{"velocity", ControlMode::Velocity, setVelocityTarget(1, 2000.0, {})}, 1000U},
            {{"position", ControlMode::Position, setPositionTarget(1, 30000)}, 1000U},
            {{"steeper ramp of velocity", ControlMode::Velocity, rampVelocity(1, 2000, 5000.0)}, 1000U},
            {{"flatter ramp of velocity", ControlMode::Velocity, rampVelocity(1, 2000, 1000.0)}, 5000U},
            {{"flatter ramp without a limit", ControlMode::Velocity, rampVelocity(1, 2000, 1000.0)}, 0U}}) {
        Bench bench;
        give(bench, order, 2000, limit);
        bench.clock.advance(1s); // it sticks first
        const int begin = bench.board->axis(0).velocity();
        bench.clock.advance(500ms);
        EXPECT_NEAR(bench.board->axis(0).velocity() - begin, 500, 60) << order.what;
    }
}

TEST(QuadQuad2DrvSimulator, PositionModeSlowsDownAheadOfItsTargetAsFastAsTheAccelerationLimitAllows)
{
    Bench bench;
    give(bench, {"position", ControlMode::Position, setPositionTarget(1, 3000)}, 1000, 1000);
    Axis &axis = bench.board->axis(0);
    bench.clock.advance(2s);
    ASSERT_NEAR(axis.velocity(), 1000, 60);
    ASSERT_TRUE(bench.clock.runUntil([&axis] { return axis.velocity() < 500; }, 3s));
    EXPECT_NEAR(3000 - axis.counter(), 125, 50) << "v²/2a before the target";
    std::int32_t farthest = 0;
    for (int i = 0; i < 100; ++i) {
        bench.clock.advance(10ms);
        farthest = std::max(farthest, axis.counter());
    }
    EXPECT_LT(farthest, 3030);
    EXPECT_NEAR(axis.counter(), 3000, 20);
}

} // namespace
} // namespace mb::quadquad2drv::simulation
