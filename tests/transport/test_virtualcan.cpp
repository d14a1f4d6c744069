// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/virtualclock.h"
#include "transport/backends/virtualcan.h"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <random>
#include <string>
#include <vector>

using namespace mb;
using namespace std::chrono_literals;

namespace {

constexpr std::uint64_t seed = 1;

struct Node {
    explicit Node(VirtualCanBus &bus)
        : link(std::make_unique<VirtualCanLink>(LinkAddress{"sim", "can", {}}, bus))
        , received(link->received().add([this](const CanFrame &frame) { frames.push_back(frame); }))
    {
        EXPECT_TRUE(link->open());
    }
    [[nodiscard]] std::vector<std::string> texts() const
    {
        std::vector<std::string> all;
        for (const CanFrame &frame : frames)
            all.push_back(toText(frame));
        return all;
    }
    std::unique_ptr<VirtualCanLink> link;
    std::vector<CanFrame> frames;
    Subscription received;
};

struct VirtualCan : public ::testing::Test {
    VirtualClock clock;
    VirtualCanBus bus{clock, 1'000'000, seed};
    Node a{bus};
    Node b{bus};
    Node c{bus};
};

using Texts = std::vector<std::string>;

CanFrame remoteFrame(std::uint32_t id)
{
    CanFrame frame = standardFrame(id, {});
    frame.remote = true;
    return frame;
}

} // namespace

TEST_F(VirtualCan, AFrameArrivesAtEveryOtherNodeWhenItsBitsHavePassed)
{
    clock.advance(5ms);
    const CanFrame frame = extendedFrame(0x02061405, {1, 2, 3, 4, 5, 6, 7, 8});
    ASSERT_TRUE(a.link->send(frame));
    EXPECT_TRUE(b.frames.empty()) << "never inside send()";
    clock.advance(1ms);
    EXPECT_TRUE(a.frames.empty()) << "own frames do not come back";
    ASSERT_EQ(b.frames.size(), 1U);
    ASSERT_EQ(c.frames.size(), 1U);
    EXPECT_EQ(b.frames[0].time, Instant(5ms + bitsOnWire(frame) * 1us));
    EXPECT_EQ(b.frames[0].time, c.frames[0].time);
    EXPECT_EQ(a.link->counters().tx, 1U);
    EXPECT_EQ(b.link->counters().rx, 1U);
}

TEST_F(VirtualCan, WhoeverHeardAFrameIsToldThatNoMoreAreAtHand)
{
    int batches = 0;
    int ownBatches = 0;
    const Subscription heard = b.link->batchEnded().add([&batches] { ++batches; });
    const Subscription own = a.link->batchEnded().add([&ownBatches] { ++ownBatches; });
    for (std::uint32_t id = 1; id <= 3; ++id)
        ASSERT_TRUE(a.link->send(standardFrame(id, {})));
    clock.advance(5ms);
    EXPECT_EQ(b.frames.size(), 3U);
    EXPECT_EQ(batches, 3) << "what was decoded of them is committed then";
    EXPECT_EQ(ownBatches, 0);
}

TEST_F(VirtualCan, An8ByteExtendedFrameTakes131To160Bits)
{
    std::mt19937_64 random(7);
    Instant previous{};
    for (int i = 0; i < 1000; ++i) {
        CanFrame frame;
        frame.extended = true;
        frame.id = static_cast<std::uint32_t>(random() % 0x20000000U);
        frame.size = 8;
        for (auto &byte : frame.data)
            byte = static_cast<std::uint8_t>(random());
        ASSERT_TRUE(a.link->send(frame));
    }
    clock.advance(1s);
    ASSERT_EQ(b.frames.size(), 1000U);
    for (const CanFrame &frame : b.frames) {
        const auto bits = (frame.time - previous) / 1us;
        EXPECT_GE(bits, 131);
        EXPECT_LE(bits, 160);
        previous = frame.time;
    }
}

TEST(VirtualCanBitrate, SlowerBusesTakeLonger)
{
    VirtualClock clock;
    VirtualCanBus bus(clock, 125'000, seed);
    Node a(bus);
    Node b(bus);
    const CanFrame frame = standardFrame(0x123, {});
    ASSERT_TRUE(a.link->send(frame));
    clock.advance(1ms);
    ASSERT_EQ(b.frames.size(), 1U);
    EXPECT_EQ(b.frames[0].time, Instant(bitsOnWire(frame) * 8us));
    EXPECT_EQ(a.link->bitrate(), 125'000);
}

TEST_F(VirtualCan, TheLowestIdentifierWins)
{
    Node observer(bus);
    ASSERT_TRUE(a.link->send(standardFrame(0x300, {})));
    ASSERT_TRUE(b.link->send(standardFrame(0x100, {})));
    ASSERT_TRUE(c.link->send(standardFrame(0x200, {})));
    clock.advance(1ms);
    EXPECT_EQ(observer.texts(), (Texts{"100#", "200#", "300#"}));
}

TEST_F(VirtualCan, OfOneBaseIdentifierDataWinsThenRemoteThenExtended)
{
    Node observer(bus);
    ASSERT_TRUE(a.link->send(extendedFrame(0x123U << 18U, {})));
    ASSERT_TRUE(b.link->send(remoteFrame(0x123)));
    ASSERT_TRUE(c.link->send(standardFrame(0x123, {})));
    clock.advance(1ms);
    EXPECT_EQ(observer.texts(), (Texts{"123#", "123#R", "048C0000#"}));
    EXPECT_EQ(observer.link->counters().errors, 0U);
}

TEST_F(VirtualCan, ANodeSendsInTheOrderItWasAskedTo)
{
    ASSERT_TRUE(a.link->send(standardFrame(0x300, {})));
    ASSERT_TRUE(a.link->send(standardFrame(0x100, {})));
    ASSERT_TRUE(b.link->send(standardFrame(0x200, {})));
    clock.advance(1ms);
    EXPECT_EQ(c.texts(), (Texts{"200#", "300#", "100#"}));
}

TEST_F(VirtualCan, UrgentFramesGoBeforeWhatWaitsInTheirOwnOrderNotBeforeWhatIsOnTheWire)
{
    for (std::uint32_t id : {0x10U, 0x11U, 0x12U})
        ASSERT_TRUE(a.link->send(standardFrame(id, {})));
    clock.advance(10us);
    ASSERT_TRUE(a.link->send(standardFrame(0x700, {}), Priority::Urgent));
    ASSERT_TRUE(a.link->send(standardFrame(0x701, {}), Priority::Urgent));
    EXPECT_EQ(a.link->backlog(), 5U);
    clock.advance(1ms);
    EXPECT_EQ(b.texts(), (Texts{"010#", "700#", "701#", "011#", "012#"}));
    EXPECT_EQ(a.link->backlog(), 0U);
}

TEST_F(VirtualCan, EqualIdentifiersWithDifferentContentCollideAndAreResolved)
{
    ASSERT_TRUE(a.link->send(standardFrame(0x123, std::vector<std::uint8_t>{1})));
    ASSERT_TRUE(b.link->send(standardFrame(0x123, std::vector<std::uint8_t>{2})));
    clock.advance(10ms);
    EXPECT_EQ(c.frames.size(), 2U);
    EXPECT_EQ(a.texts(), (Texts{"123#02"}));
    EXPECT_EQ(b.texts(), (Texts{"123#01"}));
    EXPECT_GE(a.link->counters().errors, 1U);
    EXPECT_EQ(a.link->counters().errors, b.link->counters().errors);
    EXPECT_EQ(a.link->counters().errors, c.link->counters().errors);
    EXPECT_EQ(a.link->health().protocolErrors, a.link->counters().errors) << "two units with one number: seen as such";
    EXPECT_EQ(describe(a.link->health().last), "bit error in the data");
    EXPECT_EQ(a.link->backlog() + b.link->backlog(), 0U);
}

TEST_F(VirtualCan, StubbornSendersOfOneIdentifierTryThirtyTwoTimesAndGiveUp)
{
    bus.setStubborn(true);
    ASSERT_TRUE(a.link->send(standardFrame(0x123, std::vector<std::uint8_t>{1})));
    ASSERT_TRUE(b.link->send(standardFrame(0x123, std::vector<std::uint8_t>{2})));
    clock.advance(1s);
    EXPECT_TRUE(c.frames.empty());
    EXPECT_EQ(c.link->counters().errors, 32U);
    EXPECT_EQ(a.link->backlog() + b.link->backlog(), 0U);
}

TEST_F(VirtualCan, EqualFramesAtOnceAreOneFrame)
{
    ASSERT_TRUE(a.link->send(standardFrame(0x123, {})));
    ASSERT_TRUE(b.link->send(standardFrame(0x123, {})));
    clock.advance(10ms);
    EXPECT_EQ(c.frames.size(), 1U);
    EXPECT_TRUE(a.frames.empty());
    EXPECT_TRUE(b.frames.empty());
    EXPECT_EQ(c.link->counters().errors, 0U);
}

TEST(VirtualCanLoss, LosesTheGivenFractionTheSameWayForTheSameSeed)
{
    const auto lossy = [](std::uint64_t s) {
        VirtualClock clock;
        VirtualCanBus bus(clock, 1'000'000, s);
        bus.setLoss(0.1);
        Node sender(bus);
        Node receiver(bus);
        for (std::uint32_t i = 0; i < 10'000; ++i)
            EXPECT_TRUE(sender.link->send(extendedFrame(i, {})));
        clock.advance(10s);
        EXPECT_EQ(sender.link->backlog(), 0U);
        return receiver.texts();
    };
    const auto one = lossy(1);
    EXPECT_NEAR(static_cast<double>(one.size()), 9000.0, 150.0);
    EXPECT_EQ(one, lossy(1));
    EXPECT_NE(one, lossy(2));
}

TEST_F(VirtualCan, ASaturatedBusCarriesWhatItsBitRateAllows)
{
    const CanFrame frame = extendedFrame(0x15555555, {0x55, 0x55, 0x55, 0x55, 0x55, 0x55, 0x55, 0x55});
    const int bits = bitsOnWire(frame);
    for (int i = 0; i < 10'000; ++i)
        ASSERT_TRUE(a.link->send(frame));
    clock.advance(1s);
    EXPECT_EQ(static_cast<int>(b.frames.size()), 1'000'000 / bits);
    EXPECT_GE(b.frames.size(), 6250U);
    EXPECT_LE(b.frames.size(), 7634U);
    EXPECT_GT(b.link->load(clock.now()), 0.95);
    clock.advance(5s);
    EXPECT_EQ(b.frames.size(), 10'000U);
    EXPECT_EQ(b.link->load(clock.now()), 0.0);
}

TEST_F(VirtualCan, ThreeSendersShareTheBusWithoutGaps)
{
    int total = 0;
    for (int i = 0; i < 100; ++i) {
        std::uint32_t id = 0x100;
        for (Node *node : {&a, &b, &c}) {
            const CanFrame frame = extendedFrame(id++, {static_cast<std::uint8_t>(i)});
            total += bitsOnWire(frame);
            ASSERT_TRUE(node->link->send(frame));
        }
    }
    clock.advance(1s);
    Instant last{};
    for (const Node *node : {&a, &b, &c}) {
        EXPECT_EQ(node->frames.size(), 200U);
        last = std::max(last, node->frames.back().time);
    }
    EXPECT_EQ(last, Instant(total * 1us));
}

TEST_F(VirtualCan, AnUrgentFrameReplacesWaitingOnesOfItsIdentifierSoThatNoOldSetPointFollowsAStop)
{
    ASSERT_TRUE(a.link->send(standardFrame(1, std::array<std::uint8_t, 1>{0x11}))); // on the wire
    clock.advance(10us);
    ASSERT_TRUE(a.link->send(standardFrame(2, std::array<std::uint8_t, 1>{0x22})));
    ASSERT_TRUE(a.link->send(standardFrame(3, std::array<std::uint8_t, 1>{0x33})));
    ASSERT_TRUE(a.link->send(standardFrame(2, std::array<std::uint8_t, 1>{0x00}), Priority::Urgent));
    clock.advance(1ms);
    EXPECT_EQ(b.texts(), (Texts{"001#11", "002#00", "003#33"}));
}

TEST_F(VirtualCan, BusOffLosesOneLinkAndItCanBeOpenedAgain)
{
    ASSERT_TRUE(a.link->send(standardFrame(1, {})));
    ASSERT_TRUE(a.link->send(standardFrame(2, {})));
    clock.advance(10us);
    bus.forceBusOff(*a.link);
    EXPECT_EQ(a.link->state(), LinkState::Lost);
    EXPECT_EQ(a.link->loss().message().english().substr(0, 7), "bus-off");
    EXPECT_FALSE(a.link->send(standardFrame(3, {})));
    ASSERT_TRUE(b.link->send(standardFrame(4, {})));
    clock.advance(1ms);
    EXPECT_EQ(c.texts(), (Texts{"004#"}));
    ASSERT_TRUE(a.link->open());
    ASSERT_TRUE(a.link->send(standardFrame(5, {})));
    clock.advance(1ms);
    EXPECT_EQ(c.texts(), (Texts{"004#", "005#"}));
}

TEST_F(VirtualCan, ALinkThatIsOpenedAgainHearsEachFrameOnce)
{
    for (int i = 0; i < 3; ++i) {
        b.link->close();
        ASSERT_TRUE(b.link->open());
    }
    ASSERT_TRUE(a.link->send(standardFrame(0x123, {})));
    clock.advance(1ms);
    EXPECT_EQ(b.texts(), (Texts{"123#"}));
    ASSERT_TRUE(b.link->send(standardFrame(0x124, {})));
    clock.advance(1ms);
    EXPECT_EQ(a.texts(), (Texts{"124#"}));
}

TEST_F(VirtualCan, ReceiversMayCloseOrDestroyLinksWhileTheyAreCalled)
{
    const auto closes = a.link->received().add([this](const CanFrame &) {
        b.received.reset();
        b.link.reset();
        c.link->close();
    });
    Node sender(bus);
    ASSERT_TRUE(sender.link->send(standardFrame(1, {})));
    ASSERT_TRUE(sender.link->send(standardFrame(2, {})));
    clock.advance(1ms);
    EXPECT_EQ(a.frames.size(), 2U);
    EXPECT_TRUE(b.frames.empty());
    EXPECT_TRUE(c.frames.empty());
}

TEST_F(VirtualCan, AnIdleBusLeavesNothingArmed)
{
    ASSERT_TRUE(a.link->send(standardFrame(1, {})));
    clock.advance(1ms);
    EXPECT_EQ(clock.armed(), 0U);
}
