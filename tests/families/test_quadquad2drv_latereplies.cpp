// SPDX-License-Identifier: GPL-3.0-or-later
// Replies that come when nobody waits for them any more are no answer to the next request of their kind. On virtual time.
#include "families/quadquad2drv/packetport.h"
#include "support/simulatedsession.h"
#include "transport/backends/virtualspi.h"

#include <gtest/gtest.h>

#include <deque>

namespace mb::quadquad2drv {
namespace {

/// Answers each request at once, with the next of its replies, behind what waits in it already.
struct Slow final : SpiSlave {
    void transfer(std::span<const std::uint8_t> mosi, std::span<std::uint8_t> miso) override
    {
        for (std::uint8_t &byte : miso) {
            byte = out.empty() ? std::uint8_t{0} : out.front();
            if (!out.empty())
                out.pop_front();
        }
        isShown = isShown || mosi.front() == stx;
        if (mosi.front() != stx || replies.empty())
            return;
        out.insert(out.end(), replies.front().begin(), replies.front().end());
        replies.pop_front();
    }
    [[nodiscard]] bool isReady() const override { return isShown && !out.empty(); }
    void reset() override { }

    std::deque<std::uint8_t> out;
    std::deque<Bytes> replies;
    bool isShown = false; ///< its ready line follows what waits
};

Bytes positionReply(std::uint8_t position)
{
    return encode(static_cast<std::uint8_t>(PacketId::GetPosition), Bytes{0, position, 0, 0, 0});
}

struct QuadQuad2DrvLateReplies : testing::Test {
    QuadQuad2DrvLateReplies()
        : slaveLink(*LinkAddress::parse("sim:spi"))
        , link(*LinkAddress::parse("sim:spi"), clock, slaveLink, 500'000, 1)
        , port(link, clock)
    {
        slaveLink.attach(&board);
        EXPECT_TRUE(link.open());
    }
    void waiting(const Bytes &packet) { board.out.insert(board.out.end(), packet.begin(), packet.end()); }
    VirtualClock clock;
    Slow board;
    VirtualSpiSlaveLink slaveLink;
    VirtualSpiLink link;
    PacketPort port;
};

/// It is longer than the request, so that its end comes while the right one is looked for.
TEST_F(QuadQuad2DrvLateReplies, OneThatIsClockedOutByTheNextRequestIsNotItsReply)
{
    waiting(positionReply(1));
    board.replies = {positionReply(2)};
    const auto reply = test::run(clock, port.request(getPositions(2)));
    ASSERT_TRUE(reply) << reply.error().text();
    EXPECT_EQ(reply->payload[1], 2);
}

TEST_F(QuadQuad2DrvLateReplies, ARefusalOfTheOrderBeforeIsNoneOfTheNext)
{
    const auto id = static_cast<std::uint8_t>(PacketId::SetVelocityTarget);
    waiting(encode(id, Bytes{0xF5})); // invalid parameter
    board.replies = {encode(id, Bytes{0})};
    EXPECT_TRUE(test::run(clock, port.request(setVelocityTarget(1, 100.0, {}))));
}

TEST_F(QuadQuad2DrvLateReplies, AllThatWaitAreReadBeforeARequest)
{
    for (std::uint8_t i = 0; i < 8; ++i)
        waiting(positionReply(1));
    board.isShown = true;
    slaveLink.readyChanged();
    clock.advance(std::chrono::milliseconds(1));
    board.replies = {positionReply(2)};
    const auto reply = test::run(clock, port.request(getPositions(2)));
    ASSERT_TRUE(reply) << reply.error().text();
    EXPECT_EQ(reply->payload[1], 2);
    EXPECT_TRUE(board.out.empty());
}

} // namespace
} // namespace mb::quadquad2drv
