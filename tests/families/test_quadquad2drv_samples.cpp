// SPDX-License-Identifier: GPL-3.0-or-later
// Samples that are missing are counted, and a stream that somebody else began is read and left as it was. On virtual time.
#include "families/quadquad2drv/channels.h"
#include "families/quadquad2drv/packetport.h"
#include "families/quadquad2drv/parameters.h"
#include "support/simulatedsession.h"
#include "transport/backends/virtualspi.h"

namespace mb::quadquad2drv {
namespace {

using namespace std::chrono_literals;
using test::run;
using test::SimulatedSession;

const ChannelIndex position = channelOf(0, AxisChannel::Position);

struct Bench {
    explicit Bench(const std::string &options = {})
        : bench("sim:spi" + options)
        , other(static_cast<SpiLink &>(*bench.link), bench.clock)
    {
        bench.scan();
        device = bench.device(0, "quadquad2drv");
        EXPECT_NE(device, nullptr);
        bench.clock.advance(100ms);
    }
    /// What another program tells the board.
    void told(const Bytes &request) { EXPECT_TRUE(run(bench.clock, other.request(request))); }
    Packet asked(PacketId what)
    {
        auto reply = run(bench.clock, other.request(getRequest(what)));
        EXPECT_TRUE(reply);
        return reply ? *reply : Packet{};
    }
    void rate(double hertz) { EXPECT_TRUE(run(bench.clock, device->setRate(position, hertz))); }
    void setLoss(double fraction) { static_cast<VirtualSpiLink &>(*bench.link).setLoss(fraction); }
    [[nodiscard]] std::uint64_t lost(ChannelIndex channel = position) const
    {
        device->telemetry()->commit();
        return device->telemetry()->lost(channel);
    }
    [[nodiscard]] std::uint64_t all() const { return device->telemetry()->size(position) + lost(); }
    [[nodiscard]] double seconds() const
    {
        return std::chrono::duration<double>(bench.clock.now() - Instant{}).count();
    }

    SimulatedSession bench;
    PacketPort other;
    Device *device = nullptr;
};

TEST(QuadQuad2DrvSamples, AStreamPacketThatCameGarbledIsCounted)
{
    for (const bool elapsed : {true, false}) {
        Bench bench("?fault=corrupt@700");
        bench.rate(500.0);
        if (!elapsed) {
            EXPECT_TRUE(run(bench.bench.clock, bench.device->write(indexOf(BoardParameter::StreamConfig), 0)));
        }
        const auto before = bench.all();
        const double begin = bench.seconds();
        bench.bench.clock.advance(5s);
        EXPECT_EQ(bench.lost(), 1U) << "elapsed " << elapsed;
        EXPECT_EQ(bench.lost(channelOf(3, AxisChannel::Velocity)), 1U);
        EXPECT_NEAR(static_cast<double>(bench.all() - before), (bench.seconds() - begin) / 0.00200704, 2.0);
    }
}

TEST(QuadQuad2DrvSamples, ChannelsThatAreNotStreamedLoseNothing)
{
    Bench bench("?fault=corrupt@700");
    bench.rate(500.0);
    ASSERT_TRUE(run(bench.bench.clock, bench.device->write(indexOf(1, AxisParameter::DataMask), 0x03)));
    bench.bench.clock.advance(5s);
    EXPECT_EQ(bench.lost(channelOf(1, AxisChannel::Position)), 1U);
    EXPECT_EQ(bench.lost(channelOf(1, AxisChannel::Velocity)), 0U);
    EXPECT_EQ(bench.lost(channelOf(0, AxisChannel::Velocity)), 1U);
}

TEST(QuadQuad2DrvSamples, AQuestionForMotionDataThatIsNotAnsweredIsCountedWithThoseThatItHeldUp)
{
    Bench bench("?fault=corrupt@200");
    bench.bench.clock.advance(5s);
    EXPECT_GE(bench.lost(), 9U) << "it was waited for 100 ms";
    EXPECT_LE(bench.lost(), 12U);
    EXPECT_EQ(bench.lost(channelOf(2, AxisChannel::Velocity)), bench.lost());
    EXPECT_EQ(bench.lost(channelOf(2, AxisChannel::Status)), 0U) << "the board does not tell it yet";
}

TEST(QuadQuad2DrvSamples, APollThatIsAnsweredLosesNothing)
{
    Bench bench;
    bench.bench.clock.advance(5s);
    EXPECT_EQ(bench.lost(), 0U);
}

TEST(QuadQuad2DrvSamples, ARateIsPutBackWithPeriodConfigurationAndMasks)
{
    Bench bench;
    bench.told(setStreamConfig(streamconfig::timing));
    bench.told(setStreamPeriod(244));
    ASSERT_TRUE(run(bench.bench.clock, bench.device->refresh()));
    bench.rate(500.0);
    bench.bench.clock.advance(1s);
    bench.rate(0.0);
    EXPECT_EQ(parseStreamPeriod(bench.asked(PacketId::GetStreamPeriod)), 244);
    EXPECT_EQ(parseStreamConfig(bench.asked(PacketId::GetStreamConfig)), streamconfig::timing);
    EXPECT_EQ(parseDataMasks(bench.asked(PacketId::GetDataMask)), DataMasks({0x0B, 0x0B, 0x0B, 0x0B}));
    bench.bench.clock.advance(5s);
    EXPECT_TRUE(bench.device->liveness().heard);
    EXPECT_FALSE(bench.device->liveness().restarted) << "the masks are ours";
    EXPECT_NEAR(bench.device->telemetry()->rate(position, bench.device->clock().now()), 100.0, 3.0);
}

TEST(QuadQuad2DrvSamples, ARateGoesBackToThePeriodAndConfigurationThatWereWrittenMeanwhile)
{
    Bench bench;
    bench.rate(500.0);
    const auto write = [&bench](BoardParameter which, std::int64_t raw) {
        return run(bench.bench.clock, bench.device->write(indexOf(which), raw)).has_value();
    };
    ASSERT_TRUE(write(BoardParameter::StreamPeriod, 244));
    ASSERT_TRUE(write(BoardParameter::StreamConfig, streamconfig::timing));
    bench.rate(0.0);
    EXPECT_EQ(parseStreamPeriod(bench.asked(PacketId::GetStreamPeriod)), 244);
    EXPECT_EQ(parseStreamConfig(bench.asked(PacketId::GetStreamConfig)), streamconfig::timing);
}

TEST(QuadQuad2DrvSamples, MasksThatTellOfAResetStayWhereSomethingWasWrittenMeanwhile)
{
    Bench bench;
    bench.rate(500.0);
    ASSERT_TRUE(run(bench.bench.clock, bench.device->write(indexOf(0, AxisParameter::VelocityP), 250)));
    bench.rate(0.0);
    EXPECT_EQ(parseStreamPeriod(bench.asked(PacketId::GetStreamPeriod)), 0);
    EXPECT_EQ(parseDataMasks(bench.asked(PacketId::GetDataMask)), DataMasks({0x2B, 0x2B, 0x2B, 0x2B}));
    bench.bench.simulator("quadquad2drv:0")->setPowered(false);
    bench.bench.simulator("quadquad2drv:0")->setPowered(true);
    bench.bench.clock.advance(1s);
    EXPECT_TRUE(bench.device->liveness().restarted);
}

TEST(QuadQuad2DrvSamples, AStreamThatNoWishBeganIsNotEndedByOneThatEnds)
{
    Bench bench;
    bench.told(setStreamPeriod(244));
    ASSERT_TRUE(run(bench.bench.clock, bench.device->refresh()));
    bench.rate(0.0);
    EXPECT_EQ(parseStreamPeriod(bench.asked(PacketId::GetStreamPeriod)), 244);
}

TEST(QuadQuad2DrvSamples, ABoardWhoseStreamAnotherProgramEndsIsPolledHoweverFastThatWas)
{
    for (const std::uint16_t period : {std::uint16_t{1}, std::uint16_t{244}}) {
        Bench bench;
        bench.told(setStreamPeriod(period));
        ASSERT_TRUE(run(bench.bench.clock, bench.device->refresh()));
        bench.bench.clock.advance(200ms);
        EXPECT_TRUE(bench.device->liveness().heard) << period;
        bench.told(setStreamPeriod(0));
        bench.bench.clock.advance(2s);
        EXPECT_TRUE(bench.device->liveness().heard) << period;
        EXPECT_NEAR(bench.device->telemetry()->rate(position, bench.bench.clock.now()), 100.0, 5.0) << period;
    }
}

class BoardEnd final : public SpiSlaveLink {
public:
    BoardEnd()
        : SpiSlaveLink(*LinkAddress::parse("sim:spi"))
    {
    }
    using SpiSlaveLink::slave;

private:
    Result<void> doOpen() override { return {}; }
    void doClose() override { }
    void doReadyChanged() override { }
};

/// As unix: one, whose ready line must be asked for.
class AskedLink final : public SpiLink {
public:
    AskedLink(BoardEnd &board, Clock &clock)
        : SpiLink(*LinkAddress::parse("sim:spi"), clock)
        , m_board(board)
        , m_done(clock)
    {
    }
    ~AskedLink() override { close(); }

private:
    Result<void> doOpen() override
    {
        setReady(m_board.slave()->isReady());
        return {};
    }
    void doClose() override
    {
        m_done.stop();
        dropTransfers();
    }
    void doTransfer(const Bytes &mosi) override
    {
        m_done.startIn(16us * static_cast<int>(mosi.size()), [this, mosi] {
            Bytes miso(mosi.size());
            m_board.slave()->transfer(mosi, miso);
            setReady(m_board.slave()->isReady());
            finishTransfer(std::move(miso));
        });
    }
    void doSampleReady() override { setReady(m_board.slave()->isReady()); }
    [[nodiscard]] bool doSignalsReady() const override { return false; }
    Result<void> doPulseReset() override { return {}; }

    BoardEnd &m_board;
    Timer m_done;
};

TEST(QuadQuad2DrvSamples, AStreamThatAnotherProgramBeganIsReadWhereTheReadyLineMustBeAskedFor)
{
    const Family &family = *findFamily(families(), "quadquad2drv");
    VirtualClock clock;
    BoardEnd end;
    ASSERT_TRUE(end.open());
    auto board = family.simulate(end, clock, *SimulatedUnit::parse("quadquad2drv:0"));
    ASSERT_TRUE(board);
    AskedLink link(end, clock);
    ASSERT_TRUE(link.open());
    PacketPort other(link, clock);
    ASSERT_TRUE(run(clock, other.request(setStreamPeriod(244))));
    Identity identity;
    identity.family = family.key;
    const auto device = family.open(link, clock, identity);
    ASSERT_TRUE(run(clock, device->refresh()));
    for (int i = 0; i < 30; ++i) {
        clock.advance(100ms);
        EXPECT_TRUE(device->liveness().heard) << i;
    }
    EXPECT_NEAR(device->telemetry()->rate(position, clock.now()), 100.0, 5.0);
}

} // namespace
} // namespace mb::quadquad2drv
