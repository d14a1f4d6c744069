// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/virtualclock.h"
#include "model/snapshot.h"
#include "transport/backends/virtualspi.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace mb {
namespace {

using namespace std::chrono_literals;
using Bytes = SpiLink::Bytes;

/// Answers each byte with its complement; the level of its ready line is set by hand.
struct Echo final : SpiSlave {
    void transfer(std::span<const std::uint8_t> mosi, std::span<std::uint8_t> miso) override
    {
        heard.emplace_back(mosi.begin(), mosi.end());
        std::transform(mosi.begin(), mosi.end(), miso.begin(), [](auto b) { return static_cast<std::uint8_t>(~b); });
    }
    [[nodiscard]] bool isReady() const override { return level; }
    void reset() override { ++resets; }

    std::vector<Bytes> heard;
    bool level = false;
    int resets = 0;
};

Task<Bytes> transfer(SpiLink &link, Bytes mosi)
{
    Result<Bytes> miso = co_await link.transfer(std::move(mosi));
    co_return miso;
}

struct VirtualSpi : testing::Test {
    VirtualSpi()
        : slaveLink(*LinkAddress::parse("sim:spi"))
        , link(*LinkAddress::parse("sim:spi"), clock, slaveLink, 500'000, 1)
    {
        slaveLink.attach(&board);
        EXPECT_TRUE(link.open());
    }
    VirtualClock clock;
    Echo board;
    VirtualSpiSlaveLink slaveLink;
    VirtualSpiLink link;
};

TEST_F(VirtualSpi, AByteTakes16MicrosecondsAt500Kilohertz)
{
    Task<Bytes> task = transfer(link, {0x01, 0x02, 0x03});
    const Instant begin = clock.now();
    task.start();
    ASSERT_TRUE(clock.runUntil([&] { return task.isFinished(); }, 1s));
    EXPECT_EQ(clock.now() - begin, 48us);
    EXPECT_EQ(*task.result(), (Bytes{0xFE, 0xFD, 0xFC}));
}

TEST_F(VirtualSpi, ABoardHasOneMasterAndTheNextOnceThatIsGone)
{
    VirtualSpiLink second(*LinkAddress::parse("sim:spi"), clock, slaveLink, 500'000, 1);
    const auto refused = second.open();
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().fault, Fault::LinkLost);
    EXPECT_EQ(refused.error().text(), "the simulated board is in use by another link");
    link.close();
    {
        VirtualSpiLink third(*LinkAddress::parse("sim:spi"), clock, slaveLink, 500'000, 1);
        EXPECT_TRUE(third.open());
        EXPECT_FALSE(second.open());
        third.unplug();
        EXPECT_FALSE(second.open()) << "lost is not closed";
    }
    EXPECT_TRUE(second.open());
    board.level = true;
    slaveLink.readyChanged();
    clock.advance(0us);
    EXPECT_EQ(second.ready(), true);
}

TEST_F(VirtualSpi, ItsLoadIsTheShareOfTheClockThatTransfersTake)
{
    for (int i = 0; i < 300; ++i) { // 40 bytes of 16 us every 10 ms
        Task<Bytes> task = transfer(link, Bytes(40));
        task.start();
        clock.advance(10ms);
    }
    const LinkView view = viewOf(link, clock);
    EXPECT_EQ(view.bitrate, 500'000);
    EXPECT_NEAR(view.load.value_or(0.0), 0.064, 0.002);
}

TEST_F(VirtualSpi, ItsLoadIsNotKnownBeforeItWasMeasuredForASecond)
{
    const auto load = [&] { return viewOf(link, clock).load; };
    EXPECT_FALSE(load());
    clock.advance(300ms);
    Task<Bytes> task = transfer(link, Bytes(40));
    task.start();
    clock.advance(600ms);
    EXPECT_FALSE(load());
    clock.advance(200ms);
    EXPECT_GT(load().value_or(0.0), 0.0);
    clock.advance(5s);
    EXPECT_EQ(load(), 0.0) << "it is silent";
    link.close();
    ASSERT_TRUE(link.open());
    EXPECT_FALSE(load());
    clock.advance(1s);
    EXPECT_EQ(load(), 0.0);
}

TEST_F(VirtualSpi, TransfersTakePlaceOneAfterTheOther)
{
    Task<Bytes> first = transfer(link, {1});
    Task<Bytes> second = transfer(link, {2});
    first.start();
    second.start();
    clock.advance(1ms);
    EXPECT_EQ(board.heard, (std::vector<Bytes>{{1}, {2}}));
    EXPECT_TRUE(second.isFinished());
}

TEST_F(VirtualSpi, AnUrgentTransferTakesThePlaceOfThoseThatWaitSoThatNoneOfThemUndoesIt)
{
    Task<Bytes> first = transfer(link, {1});
    Task<Bytes> second = transfer(link, {2});
    first.start();
    second.start();
    ASSERT_TRUE(link.sendUrgent({9}));
    EXPECT_FALSE(second.isFinished()) << "told from the clock, not from inside the stop";
    clock.advance(1ms);
    EXPECT_EQ(board.heard, (std::vector<Bytes>{{1}, {9}}));
    ASSERT_TRUE(first.isFinished() && second.isFinished());
    EXPECT_TRUE(first.result());
    EXPECT_EQ(second.result().error().fault, Fault::Cancelled);
}

TEST_F(VirtualSpi, ATransferThatWasCancelledBeforeItBeganDoesNotTakePlace)
{
    Task<Bytes> first = transfer(link, {1});
    Task<Bytes> second = transfer(link, {2});
    first.start();
    second.start();
    second.cancel();
    clock.advance(1ms);
    EXPECT_EQ(board.heard, (std::vector<Bytes>{{1}}));
}

TEST_F(VirtualSpi, UnpluggingEndsWhatWaits)
{
    Task<Bytes> first = transfer(link, {1});
    Task<Bytes> second = transfer(link, {2});
    first.start();
    second.start();
    link.unplug();
    clock.advance(1ms);
    ASSERT_TRUE(first.isFinished());
    ASSERT_TRUE(second.isFinished());
    EXPECT_EQ(first.result().error().fault, Fault::LinkLost);
    EXPECT_EQ(second.result().error().fault, Fault::LinkLost);
    EXPECT_FALSE(link.sendUrgent({9}));
    EXPECT_TRUE(board.heard.empty()) << "what was on its way is cut off";
}

TEST_F(VirtualSpi, WaitingForTheReadyLineEndsWhenItRisesOrTheTimeIsOver)
{
    Task<void> waiting = link.waitReady(10ms);
    waiting.start();
    clock.advance(3ms);
    EXPECT_FALSE(waiting.isFinished());
    board.level = true;
    slaveLink.readyChanged();
    clock.advance(1us);
    ASSERT_TRUE(waiting.isFinished());
    EXPECT_TRUE(waiting.result());

    board.level = false;
    slaveLink.readyChanged();
    clock.advance(1us);
    Task<void> again = link.waitReady(10ms);
    again.start();
    clock.advance(11ms);
    ASSERT_TRUE(again.isFinished());
    EXPECT_EQ(again.result().error().fault, Fault::Timeout);
}

/// Its ready line is low when it is opened, and cannot be read afterwards.
class BrokenLine final : public SpiLink {
public:
    explicit BrokenLine(Clock &clock)
        : SpiLink(*LinkAddress::parse("sim:spi"), clock)
    {
    }
    ~BrokenLine() override { close(); }

private:
    Result<void> doOpen() override
    {
        setReady(false);
        return {};
    }
    void doClose() override { }
    void doTransfer(const Bytes &) override { }
    void doSampleReady() override { setReady(std::nullopt); }
    [[nodiscard]] bool doSignalsReady() const override { return false; }
    Result<void> doPulseReset() override { return {}; }
};

TEST(SpiReadyLine, OneThatCannotBeReadAnyMoreHasNotRisen)
{
    VirtualClock clock;
    BrokenLine link(clock);
    ASSERT_TRUE(link.open());
    Task<void> waiting = link.waitReady(10ms);
    waiting.start();
    clock.advance(11ms);
    ASSERT_TRUE(waiting.isFinished());
    ASSERT_FALSE(link.ready());
    ASSERT_FALSE(waiting.result());
    EXPECT_EQ(waiting.result().error().fault, Fault::Timeout);
}

TEST_F(VirtualSpi, ResetReachesTheBoard)
{
    ASSERT_TRUE(link.pulseReset());
    EXPECT_EQ(board.resets, 1);
}

TEST_F(VirtualSpi, OnceItIsClosedWhoWaitsIsToldAndNothingIsDone)
{
    Task<void> waiting = link.waitReady(10ms);
    waiting.start();
    clock.advance(3ms);
    link.close();
    clock.advance(1us);
    ASSERT_TRUE(waiting.isFinished());
    EXPECT_EQ(waiting.result().error().text(), "sim:spi is not open");
    EXPECT_EQ(link.pulseReset().error().text(), "sim:spi is not open");
    EXPECT_EQ(link.sendUrgent({1}).error().text(), "sim:spi is not open");
    EXPECT_EQ(board.resets, 0);
    Task<Bytes> late = transfer(link, {1});
    late.start();
    ASSERT_TRUE(late.isFinished());
    EXPECT_EQ(late.result().error().fault, Fault::LinkLost);
    EXPECT_TRUE(board.heard.empty());
    EXPECT_EQ(clock.armed(), 0U);
}

} // namespace
} // namespace mb
