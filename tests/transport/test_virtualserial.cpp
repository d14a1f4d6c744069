// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/virtualclock.h"
#include "transport/backends/virtualserial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <memory>
#include <numeric>

using namespace mb;
using namespace std::chrono_literals;

namespace {

using Bytes = std::vector<std::uint8_t>;
using Wiring = VirtualSerialLine::Wiring;

Duration bytesAt(int count, int rate)
{
    return Duration(std::chrono::seconds(10)) / rate * count;
}

struct End {
    explicit End(VirtualSerialLine &line, const char *address = "sim:serial")
        : link(std::make_unique<VirtualSerialLink>(LinkAddress::parse(address).value(), line))
    {
        EXPECT_TRUE(link->open());
        received = link->received().add([this, &line](std::span<const std::uint8_t> chunk) {
            heard.insert(heard.end(), chunk.begin(), chunk.end());
            times.push_back(line.clock().now());
        });
    }
    std::unique_ptr<VirtualSerialLink> link;
    Bytes heard;
    std::vector<Instant> times;
    Subscription received;
};

struct VirtualSerial : public ::testing::Test {
    VirtualClock clock;
    VirtualSerialLine line{clock, Wiring::HalfDuplex, 1};
    End a{line};
    End b{line};
    End c{line};

    void finish() { clock.advance(1s); }
};

} // namespace

TEST_F(VirtualSerial, APieceArrivesAtEveryOtherEndWhenItsLastStopBitHasPassed)
{
    clock.advance(5ms);
    const Instant start = clock.now();
    ASSERT_TRUE(a.link->send(Bytes{0x55, 0xAA, 0x04}));
    EXPECT_EQ(a.link->backlog(), 3U);
    EXPECT_TRUE(b.heard.empty()) << "delivered inside send()";
    finish();
    EXPECT_EQ(b.heard, (Bytes{0x55, 0xAA, 0x04}));
    EXPECT_EQ(c.heard, b.heard);
    EXPECT_TRUE(a.heard.empty());
    ASSERT_EQ(b.times.size(), 1U);
    EXPECT_EQ(b.times[0] - start, bytesAt(3, 115200));
    EXPECT_EQ(a.link->backlog(), 0U);
    EXPECT_EQ(a.link->counters().tx, 3U);
    EXPECT_EQ(b.link->counters().rx, 3U);
    EXPECT_EQ(b.link->counters().errors, 0U);
}

TEST_F(VirtualSerial, LongPiecesComeInFifoLoadsAndPiecesFollowEachOtherWithoutAGap)
{
    Bytes sent(40);
    std::iota(sent.begin(), sent.end(), std::uint8_t{1});
    ASSERT_TRUE(a.link->send(sent));
    ASSERT_TRUE(a.link->send(Bytes{0xEE}));
    finish();
    Bytes all = sent;
    all.push_back(0xEE);
    EXPECT_EQ(b.heard, all);
    ASSERT_EQ(b.times.size(), 4U);
    for (const auto &[index, bytes] : {std::pair{0U, 16}, {1U, 32}, {2U, 40}, {3U, 41}})
        EXPECT_EQ(b.times[index], Instant{} + bytesAt(bytes, 115200)) << index;
}

TEST_F(VirtualSerial, ACorruptPieceDiffersInOneBitWhicheverItIs)
{
    line.setCorruption(1.0);
    std::uint8_t seen = 0;
    for (int i = 0; i < 200; ++i) {
        ASSERT_TRUE(a.link->send(Bytes{0x5A}));
        finish();
        const auto changed = static_cast<std::uint8_t>(b.heard.back() ^ 0x5A);
        ASSERT_TRUE(std::has_single_bit(changed)) << i;
        seen |= changed;
    }
    EXPECT_EQ(seen, 0xFF);
}

TEST_F(VirtualSerial, BytesTakeTheTimeOfTheirRateAtEveryRate)
{
    for (const int rate : {600, 9600, 57600, 59524, 115200, 119048}) {
        for (End *end : {&a, &b, &c})
            ASSERT_TRUE(end->link->setBaudrate(rate));
        EXPECT_EQ(a.link->byteTime(), bytesAt(1, rate));
        const Instant start = clock.now();
        ASSERT_TRUE(a.link->send(Bytes{1, 2}));
        finish();
        EXPECT_EQ(b.times.back() - start, bytesAt(2, rate)) << rate;
    }
}

TEST_F(VirtualSerial, AnEndAtAnotherRateHearsGarbageAndFramingErrors)
{
    ASSERT_TRUE(b.link->setBaudrate(9600));
    int errors = 0;
    const Subscription subscription = b.link->lineErrors().add([&errors] { ++errors; });
    ASSERT_TRUE(b.link->send(Bytes{0x55, 0xAA, 0x04}));
    finish();
    EXPECT_GT(a.heard.size(), 3U);
    EXPECT_GT(a.link->counters().errors, 0U);
    ASSERT_TRUE(a.link->send(Bytes{0x55, 0xAA, 0x04, 0x01, 0x0E, 0x00}));
    finish();
    EXPECT_NE(b.heard, (Bytes{0x55, 0xAA, 0x04, 0x01, 0x0E, 0x00}));
    EXPECT_EQ(c.heard.size(), a.heard.size() + 6U);
    EXPECT_EQ(b.link->counters().errors, static_cast<std::uint64_t>(errors));
}

TEST_F(VirtualSerial, RatesThatAreCloseUnderstandEachOther)
{
    ASSERT_TRUE(a.link->setBaudrate(57600));
    ASSERT_TRUE(b.link->setBaudrate(59524));
    ASSERT_TRUE(a.link->send(Bytes{0x55, 0xAA, 0x00, 0xFF}));
    finish();
    EXPECT_EQ(b.heard, (Bytes{0x55, 0xAA, 0x00, 0xFF}));
    EXPECT_EQ(b.link->counters().errors, 0U);
}

TEST_F(VirtualSerial, BytesOfTwoSendersThatOverlapReachNobodyIntact)
{
    ASSERT_TRUE(a.link->send(Bytes{1, 2, 3, 4}));
    clock.advance(bytesAt(2, 115200) + 1us); // the third byte of a is under way
    ASSERT_TRUE(b.link->send(Bytes{5, 6, 7, 8}));
    finish();
    ASSERT_EQ(c.heard.size(), 8U);
    EXPECT_EQ(Bytes(c.heard.begin(), c.heard.begin() + 2), (Bytes{1, 2}));
    EXPECT_NE(c.heard[2], 3);
    EXPECT_NE(c.heard[3], 4);
    EXPECT_NE(c.heard[4], 5);
    EXPECT_NE(c.heard[5], 6);
    EXPECT_EQ(Bytes(c.heard.begin() + 6, c.heard.end()), (Bytes{7, 8}));
    EXPECT_EQ(c.link->counters().errors, 4U);
}

TEST_F(VirtualSerial, BytesThatOnlyTouchOneAnotherStayWhole)
{
    for (End *end : {&a, &b, &c})
        ASSERT_TRUE(end->link->setBaudrate(100'000));
    ASSERT_TRUE(a.link->send(Bytes{1, 2, 3, 4}));
    clock.advance(bytesAt(2, 100'000));
    ASSERT_TRUE(b.link->send(Bytes{5, 6, 7, 8}));
    finish();
    ASSERT_EQ(c.heard.size(), 8U);
    EXPECT_EQ(Bytes(c.heard.begin(), c.heard.begin() + 2), (Bytes{1, 2}));
    EXPECT_EQ(Bytes(c.heard.begin() + 6, c.heard.end()), (Bytes{7, 8}));
    EXPECT_EQ(c.link->counters().errors, 4U);
}

TEST(VirtualSerialFullDuplex, NothingCollides)
{
    VirtualClock clock;
    VirtualSerialLine line(clock, Wiring::FullDuplex, 1);
    End a(line);
    End b(line);
    ASSERT_TRUE(a.link->send(Bytes{1, 2, 3}));
    ASSERT_TRUE(b.link->send(Bytes{4, 5, 6}));
    clock.advance(1s);
    EXPECT_EQ(b.heard, (Bytes{1, 2, 3}));
    EXPECT_EQ(a.heard, (Bytes{4, 5, 6}));
}

TEST_F(VirtualSerial, AnUrgentPieceGoesBeforeWhatWaitsAndNoOlderOrderFollowsIt)
{
    ASSERT_TRUE(a.link->send(Bytes{1, 1}));
    ASSERT_TRUE(a.link->send(Bytes{2, 2}));
    ASSERT_TRUE(a.link->send(Bytes{9}, Priority::Urgent));
    ASSERT_TRUE(a.link->send(Bytes{8}, Priority::Urgent));
    finish();
    EXPECT_EQ(b.heard, (Bytes{1, 1, 9, 8}));
    EXPECT_EQ(a.link->counters().lost, 2U);
}

TEST_F(VirtualSerial, LossAndCorruptionAreSeededAndAsFrequentAsAsked)
{
    line.setLoss(0.25);
    for (int i = 0; i < 1000; ++i)
        ASSERT_TRUE(a.link->send(Bytes{0x5A}));
    finish();
    EXPECT_NEAR(static_cast<double>(b.heard.size()), 750.0, 50.0);
    EXPECT_EQ(c.heard, b.heard);
    line.setLoss(0.0);
    line.setCorruption(0.5);
    b.heard.clear();
    for (int i = 0; i < 1000; ++i)
        ASSERT_TRUE(a.link->send(Bytes{0x5A}));
    finish();
    ASSERT_EQ(b.heard.size(), 1000U);
    EXPECT_NEAR(static_cast<double>(std::count(b.heard.begin(), b.heard.end(), 0x5A)), 500.0, 60.0);
}

TEST_F(VirtualSerial, ACableThatComesOutInMidFrameLeavesItsFirstBytesOnTheLine)
{
    ASSERT_TRUE(a.link->send(Bytes{1, 2, 3, 4}));
    clock.advance(bytesAt(2, 115200) + 1us);
    line.pull(*a.link);
    finish();
    EXPECT_EQ(b.heard, (Bytes{1, 2}));
    EXPECT_EQ(a.link->state(), LinkState::Lost);
    EXPECT_NE(a.link->loss().message().english().find("plug it in again"), std::string::npos);
    EXPECT_EQ(a.link->send(Bytes{1}).error().fault, Fault::LinkLost);
    ASSERT_TRUE(a.link->open());
    ASSERT_TRUE(a.link->send(Bytes{7}));
    finish();
    EXPECT_EQ(b.heard, (Bytes{1, 2, 7}));
}

TEST_F(VirtualSerial, AnyoneUnderstandsEveryoneWhereTheSpeedDoesNotMatter)
{
    ASSERT_TRUE(b.link->setBaudrate(9600));
    line.setAnySpeed(19200);
    ASSERT_TRUE(a.link->send(Bytes{1, 2, 3}));
    finish();
    EXPECT_EQ(b.heard, (Bytes{1, 2, 3}));
    EXPECT_EQ(b.times[0], Instant{} + bytesAt(3, 19200));
}

TEST_F(VirtualSerial, AnAnswerFromTheReceiverAndAnEndThatIsDestroyedThereAreSafe)
{
    const Subscription answer = b.link->received().add([this](std::span<const std::uint8_t>) {
        EXPECT_TRUE(b.link->send(Bytes{9}));
        c.received.reset();
        c.link.reset();
    });
    ASSERT_TRUE(a.link->send(Bytes{1}));
    finish();
    EXPECT_EQ(a.heard, (Bytes{9}));
}

TEST_F(VirtualSerial, ARateThatTheAddressFixesIsTakenAndRatesThatAreNoneAreRefused)
{
    End fixed(line, "sim:serial?bitrate=57600");
    EXPECT_EQ(fixed.link->baudrate(), 57600);
    EXPECT_EQ(fixed.link->fixedBaudrate(), 57600);
    EXPECT_EQ(a.link->fixedBaudrate(), std::nullopt);
    for (const int rate : {0, -1, 49, 4'000'001})
        EXPECT_EQ(a.link->setBaudrate(rate).error().fault, Fault::OutOfRange) << rate;
    EXPECT_EQ(a.link->send(Bytes{}).error().fault, Fault::OutOfRange);
}

TEST_F(VirtualSerial, TheLoadIsTheShareOfTimeThatTheLineIsInUse)
{
    for (int i = 0; i < 200; ++i) { // 1152 of 11520 bytes a second
        ASSERT_TRUE(a.link->send(Bytes(12, 0x55)));
        clock.advance(10ms);
    }
    EXPECT_NEAR(b.link->load(clock.now()).value_or(0.0), 1200.0 / 11520.0, 0.01);
    EXPECT_NEAR(a.link->load(clock.now()).value_or(0.0), 1200.0 / 11520.0, 0.01);
}
