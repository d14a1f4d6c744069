// SPDX-License-Identifier: GPL-3.0-or-later
// What a stop ends, and what it does when the board does not answer. On virtual time.
#include "families/quadquad2drv/channels.h"
#include "families/quadquad2drv/codec.h"
#include "families/quadquad2drv/protocol.h"
#include "support/simulatedsession.h"
#include "transport/backends/virtualspi.h"

#include <algorithm>

namespace mb::quadquad2drv {
namespace {

using namespace std::chrono_literals;
using test::run;
using test::SimulatedSession;

struct QuadQuad2DrvStop : testing::Test {
    QuadQuad2DrvStop()
    {
        bench.scan();
        device = bench.device(0, "quadquad2drv");
        board = bench.simulator("quadquad2drv:0");
        stream = &bench.session.stream(*device);
        bench.clock.advance(500ms);
        heard = bench.link->traffic().add([this](const Traffic &traffic) {
            if (traffic.direction == Direction::Sent)
                sent.emplace_back(traffic.bytes.begin(), traffic.bytes.end());
        });
        events = board->events().add([this](const SimulatorEvent &event) { log.push_back(event.what); });
    }
    static SetPoint duty(double target)
    {
        SetPoint made;
        made.mode = Mode::Duty;
        made.target = target;
        return made;
    }
    [[nodiscard]] static bool isMode(const Bytes &packet, ControlMode mode)
    {
        return packet.size() == 6 && packet[2] == static_cast<std::uint8_t>(PacketId::SetControlMode)
            && packet[4] == static_cast<std::uint8_t>(mode);
    }
    [[nodiscard]] bool happened(std::string_view what) const { return std::count(log.begin(), log.end(), what) > 0; }
    /// The board loses its supply at the moment in which it is to take the mode, so that nobody answers.
    void driveUntilTheModeIsUnderWay()
    {
        ASSERT_TRUE(stream->start(duty(0.3), 10s));
        ASSERT_TRUE(bench.clock.runUntil([this] { return !sent.empty() && isMode(sent.back(), ControlMode::Power); }));
        board->setPowered(false);
    }
    /// In the next second.
    void expectNoMotionAgain()
    {
        sent.clear();
        bench.clock.advance(1s);
        EXPECT_FALSE(board->isOutputOn());
        for (const Bytes &packet : sent)
            EXPECT_FALSE(isMode(packet, ControlMode::Power));
    }
    /// A motor that turns is told to stop, and the answer to the first question for the proof is lost.
    void stopProvenLater()
    {
        ASSERT_TRUE(stream->start(duty(0.3), 10s));
        bench.clock.advance(200ms);
        sent.clear();
        stream->stop();
        const auto isOff = [](const Bytes &packet) { return isMode(packet, ControlMode::Off); };
        ASSERT_TRUE(bench.clock.runUntil([&] { return std::ranges::count_if(sent, isOff) == 2; }, 1s));
        spi().setLoss(1.0);
        bench.clock.advance(5ms);
        spi().setLoss(0.0);
        bench.clock.advance(50ms);
        ASSERT_FALSE(device->isSeenStopped());
    }
    VirtualSpiLink &spi() { return dynamic_cast<VirtualSpiLink &>(*bench.link); }

    SimulatedSession bench{"sim:spi"};
    Device *device = nullptr;
    Simulator *board = nullptr;
    SetPointStream *stream = nullptr;
    std::vector<Bytes> sent;
    std::vector<std::string> log;
    Subscription heard;
    Subscription events;
};

TEST_F(QuadQuad2DrvStop, AnOrderThatIsUnderWayIsNotSentAgainAfterIt)
{
    for (const Duration later : {1ms, 20ms, 60ms, 99ms, 101ms, 160ms}) {
        sent.clear();
        driveUntilTheModeIsUnderWay();
        bench.clock.advance(later);
        stream->stop();
        sent.clear();
        board->setPowered(true);
        bench.clock.advance(1s);
        EXPECT_EQ(
            std::count_if(sent.begin(), sent.end(), [](const Bytes &p) { return isMode(p, ControlMode::Power); }), 0)
            << later / 1ms << " ms";
        EXPECT_FALSE(board->isOutputOn()) << later / 1ms << " ms";
        ASSERT_TRUE(run(bench.clock, device->refresh()));
    }
}

TEST_F(QuadQuad2DrvStop, OrdersThatWaitBehindTheOneUnderWayAreNeverSentAfterIt)
{
    spi().setLoss(1.0); // the first order is asked for again and again, mode and duty wait behind it
    ASSERT_TRUE(stream->start(duty(0.3), 10s));
    ASSERT_TRUE(bench.clock.runUntil([this] { return !sent.empty(); }));
    bench.clock.advance(5ms);
    ASSERT_FALSE(board->isOutputOn());
    stream->stop();
    spi().setLoss(0.0);
    expectNoMotionAgain();
}

TEST_F(QuadQuad2DrvStop, TheNextMotionAfterItIsObeyedThoughAnOrderWasStillUnderWay)
{
    spi().setLoss(1.0); // it understands, and nobody hears that
    ASSERT_TRUE(stream->start(duty(0.3), 10s));
    bench.clock.advance(5ms);
    stream->stop();
    spi().setLoss(0.0);
    ASSERT_TRUE(stream->start(duty(0.3), 10s));
    ASSERT_TRUE(bench.clock.runUntil([this] { return board->isOutputOn(); }, 2s));
    bench.clock.advance(500ms);
    EXPECT_TRUE(board->isOutputOn());
    stream->stop();
    bench.clock.advance(100ms);
    EXPECT_FALSE(board->isOutputOn());
}

/// What asks for the proof of a stop switches all axes off.
TEST_F(QuadQuad2DrvStop, AMotionThatIsOrderedBehindItBeginsOnceItIsProven)
{
    stopProvenLater();
    ASSERT_TRUE(stream->start(duty(0.3), 10s));
    bench.clock.advance(1s);
    EXPECT_TRUE(board->isOutputOn());
    EXPECT_TRUE(stream->isRunning()) << stream->reason().english();
    const auto begun = std::ranges::find_if(sent, [](const Bytes &p) { return isMode(p, ControlMode::Power); });
    ASSERT_NE(begun, sent.end());
    EXPECT_TRUE(std::none_of(begun, sent.end(), [](const Bytes &p) { return isMode(p, ControlMode::Off); }));
}

TEST_F(QuadQuad2DrvStop, AnAxisThatIsSwitchedOffBehindItIsToldOnceItIsProven)
{
    stopProvenLater();
    SetPoint off;
    off.mode = Mode::Off;
    ASSERT_TRUE(device->command(off));
    bench.clock.advance(1s);
    EXPECT_TRUE(std::ranges::count(sent, setControlMode(maskOf(0), ControlMode::Off)) > 0);
    EXPECT_FALSE(device->liveness().axes[0].moving);
}

TEST_F(QuadQuad2DrvStop, AMoveThatIsOrderedBehindItBeginsWhereTheMotorIsThen)
{
    const auto place = [this] {
        return static_cast<std::int32_t>(device->telemetry()->latest(channelOf(0, AxisChannel::Position))->value);
    };
    stopProvenLater();
    const std::int32_t ordered = place(); // and it runs out
    int rests = 0;
    const auto listening = bench.link->traffic().add([&](const Traffic &traffic) {
        const Bytes packet(traffic.bytes.begin(), traffic.bytes.end());
        if (traffic.direction != Direction::Sent || packet.size() < 3
            || packet[2] != static_cast<std::uint8_t>(PacketId::SetPositionTarget))
            return;
        ++rests;
        EXPECT_EQ(packet, setPositionTarget(maskOf(0), place()));
        EXPECT_GT(place(), ordered);
    });
    SetPoint move;
    move.mode = Mode::RampPosition;
    move.target = ordered + 20000.0;
    move.velocity = 5000.0;
    move.acceleration = 50000.0;
    ASSERT_TRUE(stream->start(move, 10s));
    bench.clock.advance(1s);
    EXPECT_EQ(rests, 2) << "before it takes the mode, and after it";
}

TEST_F(QuadQuad2DrvStop, AnOrderThatTheBoardDoesNotTakeEndsTheMotionAndItStaysEnded)
{
    ASSERT_TRUE(stream->start(duty(0.3), 10s));
    bench.clock.advance(200ms);
    ASSERT_TRUE(board->isOutputOn());
    spi().setLoss(1.0);
    ASSERT_TRUE(bench.clock.runUntil([this] { return !stream->isRunning(); }, 2s));
    spi().setLoss(0.0);
    expectNoMotionAgain();
}

TEST_F(QuadQuad2DrvStop, ANewMotionMayBeginAfterItThoughAnOrderHadFailed)
{
    ASSERT_TRUE(stream->start(duty(0.3), 10s));
    bench.clock.advance(200ms);
    spi().setLoss(1.0);
    ASSERT_TRUE(bench.clock.runUntil([this] { return !stream->isRunning(); }, 2s));
    spi().setLoss(0.0);
    device->stop();
    bench.clock.advance(2s);
    ASSERT_TRUE(device->isSeenStopped());
    ASSERT_TRUE(run(bench.clock, device->refresh()));
    ASSERT_TRUE(stream->start(duty(0.3), 10s));
    bench.clock.advance(500ms);
    EXPECT_TRUE(stream->isRunning()) << stream->reason().english();
    EXPECT_TRUE(board->isOutputOn());
}

TEST_F(QuadQuad2DrvStop, AnAnswerInBetweenPutsTheLastResortOff)
{
    ASSERT_TRUE(stream->start(duty(0.3), 10s));
    bench.clock.advance(200ms);
    sent.clear();
    const auto questions = [this] {
        return std::count_if(sent.begin(), sent.end(), [](const Bytes &p) { return isMode(p, ControlMode::Off); });
    };
    stream->stop();
    for (const int missed : {3, 5, 7}) { // every second answer is lost
        ASSERT_TRUE(bench.clock.runUntil([&] { return questions() == missed; }, 1s)) << missed;
        spi().setLoss(1.0);
        bench.clock.advance(1ms);
        spi().setLoss(0.0);
    }
    bench.clock.advance(2s);
    EXPECT_TRUE(device->isSeenStopped());
    EXPECT_FALSE(happened("reset"));
}

TEST_F(QuadQuad2DrvStop, TheResetLineIsItsLastResort)
{
    ASSERT_TRUE(stream->start(duty(0.3), 10s));
    bench.clock.advance(200ms);
    spi().setLoss(1.0); // nobody can tell whether the board understood
    stream->stop();
    bench.clock.advance(150ms);
    EXPECT_FALSE(happened("reset")) << "it is asked first";
    bench.clock.advance(400ms);
    EXPECT_TRUE(happened("reset"));
    EXPECT_FALSE(device->isSeenStopped());
    spi().setLoss(0.0);
    bench.clock.advance(500ms);
    EXPECT_TRUE(device->isSeenStopped());
    EXPECT_TRUE(device->liveness().restarted) << "its settings are gone";
}

TEST_F(QuadQuad2DrvStop, IsSentAtOnceAndAskedUntilItIsAnsweredTwice)
{
    ASSERT_TRUE(stream->start(duty(0.3), 10s));
    bench.clock.advance(200ms);
    sent.clear();
    stream->stop();
    bench.clock.advance(2s);
    EXPECT_EQ(std::count_if(sent.begin(), sent.end(), [](const Bytes &p) { return isMode(p, ControlMode::Off); }), 3);
    EXPECT_TRUE(device->isSeenStopped());
}

TEST_F(QuadQuad2DrvStop, IsSeenOnlyWhereItWasAnsweredAndTheMotorIsHeardSince)
{
    bench.clock.advance(500ms);
    ASSERT_TRUE(device->liveness().heard);
    EXPECT_FALSE(device->isSeenStopped()) << "nobody has stopped it";
    ASSERT_TRUE(stream->start(duty(0.3), 10s));
    bench.clock.advance(200ms);
    stream->stop();
    EXPECT_FALSE(device->isSeenStopped()) << "it is on its way";
    bench.clock.advance(2s);
    EXPECT_TRUE(device->isSeenStopped());
    bench.link->close();
    bench.clock.advance(1s);
    EXPECT_FALSE(device->isSeenStopped()) << "nobody sees it any more";
}

TEST_F(QuadQuad2DrvStop, MotionDataOfTheMomentInWhichItWasOrderedDoNotShowIt)
{
    Instant told{};
    const Subscription listening = device->telemetry()->samples().add([&](const Sample &sample) {
        if (sample.channel == channelOf(0, AxisChannel::Position))
            told = bench.clock.now();
    });
    ASSERT_TRUE(stream->start(duty(0.3), 10s));
    bench.clock.advance(200ms);
    ASSERT_TRUE(bench.clock.runUntil([&] { return told == bench.clock.now(); }, 1s));
    const Instant ordered = told;
    stream->stop();
    ASSERT_TRUE(bench.clock.runUntil([this] { return device->isSeenStopped(); }, 2s));
    EXPECT_GT(told, ordered);
}

TEST_F(QuadQuad2DrvStop, TwoAnswersThatAreNotInARowAreNoProof)
{
    ASSERT_TRUE(stream->start(duty(0.3), 10s));
    bench.clock.advance(200ms);
    sent.clear();
    const auto asked = [this](int times, Duration limit = 1s) {
        return bench.clock.runUntil(
            [this, times] {
                return std::count_if(sent.begin(), sent.end(), [](const Bytes &p) {
                    return isMode(p, ControlMode::Off);
                }) == times;
            },
            limit);
    };
    stream->stop();
    ASSERT_TRUE(asked(3)); // at once, a question that is answered, and one
    spi().setLoss(1.0);    // whose answer is lost
    bench.clock.advance(1ms);
    spi().setLoss(0.0);
    ASSERT_TRUE(asked(4, 200ms));
    ASSERT_TRUE(asked(5, 20ms)) << "the answer after it is the first again";
    bench.clock.advance(2s);
    EXPECT_TRUE(device->isSeenStopped());
    EXPECT_FALSE(asked(6));
}

TEST_F(QuadQuad2DrvStop, TheResetLineIsPulledOnceForEachStopThatIsNotConfirmed)
{
    for (int round = 0; round < 3; ++round) {
        log.clear();
        spi().setLoss(1.0);
        device->stop();
        bench.clock.advance(5s);
        EXPECT_EQ(std::count(log.begin(), log.end(), "reset"), 1) << round;
        spi().setLoss(0.0);
        device->stop();
        bench.clock.advance(1s);
        ASSERT_TRUE(device->isSeenStopped()) << round;
    }
}

TEST_F(QuadQuad2DrvStop, ABoardWhoseFirmwareIsWrittenIsNotResetByIt)
{
    device->gate().setBusy(say("firmware update"));
    spi().setLoss(1.0);
    device->stop();
    bench.clock.advance(3s);
    EXPECT_FALSE(happened("reset"));
}

TEST_F(QuadQuad2DrvStop, ARestartResetsTheBoardAndFindsItAgain)
{
    ASSERT_TRUE(run(bench.clock, device->restart()));
    EXPECT_TRUE(happened("reset"));
    EXPECT_FALSE(device->liveness().restarted);
}

} // namespace
} // namespace mb::quadquad2drv
