// SPDX-License-Identifier: GPL-3.0-or-later
// A stop that another thread sends past the link (Outlet::aside): its answer is told from those of the link.
#include "async/descriptor.h"
#include "async/virtualclock.h"
#include "support/eventloop.h"
#include "support/temporaryfile.h"
#include "transport/backends/unixsocket.h"
#include "transport/backends/unixspi.h"
#include "transport/backends/unixspiserver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <thread>

#include <sys/socket.h>

namespace mb {
namespace {

using Bytes = SpiLink::Bytes;

/// Answers each byte with its complement.
struct EchoBoard final : SpiSlave {
    void transfer(std::span<const std::uint8_t> mosi, std::span<std::uint8_t> miso) override
    {
        heard.emplace_back(mosi.begin(), mosi.end());
        std::transform(mosi.begin(), mosi.end(), miso.begin(), [](auto b) { return static_cast<std::uint8_t>(~b); });
    }
    [[nodiscard]] bool isReady() const override { return ready; }
    void reset() override { ++resets; }

    std::vector<Bytes> heard;
    bool ready = true;
    int resets = 0;
};

Task<Bytes> transferOn(SpiLink &link, Bytes mosi)
{
    Result<Bytes> miso = co_await link.transfer(std::move(mosi));
    co_return miso;
}

struct UnixSpi : testing::Test {
    UnixSpi()
    {
        server.attach(&board);
        EXPECT_TRUE(server.open());
        EXPECT_TRUE(link.open());
    }
    test::EventLoop loop;
    test::TemporaryFolder folder;
    EchoBoard board;
    LinkAddress address = *LinkAddress::parse("unix:" + folder.path("board"));
    UnixSpiServer server{address, loop.clock()};
    UnixSpiLink link{address, loop.clock()};
};

} // namespace

TEST_F(UnixSpi, AStopFromAnotherThreadLeavesTheAnswersOfTheLinkWhereTheyBelong)
{
    Task<Bytes> before = transferOn(link, {0x01, 0x02, 0x03});
    before.start();
    const std::function<bool(std::span<const std::uint8_t>)> aside = link.outlet().aside;
    ASSERT_TRUE(aside);
    bool sent = false;
    std::thread([&] { sent = aside(Bytes{2, 0, 0xAA, 0xBB}); }).join();
    EXPECT_TRUE(sent);
    Task<Bytes> after = transferOn(link, {0x04, 0x05});
    after.start();
    ASSERT_TRUE(loop.runUntil([&] { return after.isFinished(); }));
    EXPECT_EQ(board.heard, (std::vector<Bytes>{{0x01, 0x02, 0x03}, {0xAA, 0xBB}, {0x04, 0x05}}));
    EXPECT_EQ(*before.result(), (Bytes{0xFE, 0xFD, 0xFC}));
    EXPECT_EQ(*after.result(), (Bytes{0xFB, 0xFA}));
    EXPECT_EQ(link.state(), LinkState::Open);
}

TEST_F(UnixSpi, TheLevelOfTheReadyLineComesBackWithEveryTransfer)
{
    for (const bool ready : {false, true, false}) {
        board.ready = ready;
        Task<Bytes> asked = transferOn(link, {0x01});
        asked.start();
        ASSERT_TRUE(loop.runUntil([&] { return asked.isFinished(); }));
        EXPECT_EQ(link.ready(), ready);
    }
    server.attach(nullptr); // nobody pulls it up
    Task<Bytes> asked = transferOn(link, {0x01});
    asked.start();
    ASSERT_TRUE(loop.runUntil([&] { return asked.isFinished(); }));
    EXPECT_EQ(link.ready(), false);
    EXPECT_EQ(*asked.result(), Bytes{0});
}

TEST_F(UnixSpi, AResetReachesTheBoardAtOnceAndLeavesTheTransfersAfterItWhole)
{
    for (int count = 1; count <= 2; ++count) {
        ASSERT_TRUE(link.pulseReset());
        ASSERT_TRUE(loop.runUntil([&] { return board.resets == count; })) << "though nothing is sent after it";
    }
    ASSERT_TRUE(link.pulseReset());
    Task<Bytes> after = transferOn(link, {0x01, 0x02});
    after.start();
    ASSERT_TRUE(loop.runUntil([&] { return after.isFinished(); }));
    EXPECT_EQ(board.resets, 3);
    EXPECT_EQ(board.heard, (std::vector<Bytes>{{0x01, 0x02}}));
    EXPECT_EQ(*after.result(), (Bytes{0xFE, 0xFD}));
}

/// A link that is open to a socket, of which nobody reads.
struct UnreadLink {
    explicit UnreadLink(const std::string &path)
        : address(*LinkAddress::parse("unix:" + path))
        , listening(listenOnUnixSocket(address.path).value_or(-1))
    {
        EXPECT_TRUE(link.open());
    }
    void fill()
    {
        while (link.outlet().aside(Bytes(50'000))) { } // until no more fits the socket
        EXPECT_TRUE(link.pulseReset());
    }

    LinkAddress address;
    Descriptor listening;
    VirtualClock clock;
    UnixSpiLink link{address, clock};
};

TEST_F(UnixSpi, ALinkWhoseAnswersItsGuardianHasReadIsLostAndWorksOnceItIsOpenAgain)
{
    UnreadLink unread(folder.path("quiet"));
    auto &[quiet, listening, clock, held] = unread;
    const Descriptor first(::accept(listening.get(), nullptr, nullptr));
    Task<Bytes> asked = transferOn(held, {0x01, 0x02});
    asked.start();
    clock.advance(std::chrono::milliseconds(900));
    EXPECT_EQ(held.state(), LinkState::Open);
    clock.advance(std::chrono::milliseconds(200));
    ASSERT_EQ(held.state(), LinkState::Lost);
    EXPECT_TRUE(asked.isFinished());
    EXPECT_EQ(held.loss().text(), "the simulator at " + quiet.path + " does not answer; start it again");
    ASSERT_TRUE(held.open());
    const Descriptor second(::accept(listening.get(), nullptr, nullptr));
    for (std::uint8_t answer = 1; answer <= 3; ++answer) { // slowly, and that is no silence
        Task<Bytes> again = transferOn(held, {0x03});
        again.start();
        clock.advance(std::chrono::milliseconds(900));
        const Bytes bytes{answer, 1};
        ASSERT_EQ(::send(second.get(), bytes.data(), bytes.size(), 0), 2);
        ASSERT_TRUE(loop.runUntil([&] { return again.isFinished(); }));
        ASSERT_TRUE(again.result());
        EXPECT_EQ(*again.result(), Bytes{answer});
    }
}

TEST_F(UnixSpi, HalfAnAnswerOfBeforeItWasClosedIsNoPartOfTheNextOne)
{
    const LinkAddress quiet = *LinkAddress::parse("unix:" + folder.path("quiet"));
    const Descriptor listening(listenOnUnixSocket(quiet.path).value_or(-1));
    UnixSpiLink held{quiet, loop.clock()};
    ASSERT_TRUE(held.open());
    const Descriptor first(::accept(listening.get(), nullptr, nullptr));
    Task<Bytes> cut = transferOn(held, {0x01, 0x02, 0x03});
    cut.start();
    const Bytes half{0xFE, 0xFD};
    ASSERT_EQ(::send(first.get(), half.data(), half.size(), 0), 2);
    loop.runUntil([] { return false; }, std::chrono::milliseconds(50));
    held.close();
    ASSERT_TRUE(held.open());
    const Descriptor second(::accept(listening.get(), nullptr, nullptr));
    Task<Bytes> asked = transferOn(held, {0x04, 0x05});
    asked.start();
    const Bytes whole{0xFB, 0xFA, 1};
    ASSERT_EQ(::send(second.get(), whole.data(), whole.size(), 0), 3);
    ASSERT_TRUE(loop.runUntil([&] { return asked.isFinished(); }));
    EXPECT_EQ(*asked.result(), (Bytes{0xFB, 0xFA}));
}

TEST_F(UnixSpi, AResetIsSentAsideTooAndNoHalfMessage)
{
    const auto aside = link.outlet().aside;
    EXPECT_FALSE(aside(Bytes{0xFF}));
    EXPECT_TRUE(aside(Bytes{0xFF, 0xFF}));
    Task<Bytes> after = transferOn(link, {0x01});
    after.start();
    ASSERT_TRUE(loop.runUntil([&] { return after.isFinished(); }));
    EXPECT_EQ(board.resets, 1);
    EXPECT_EQ(*after.result(), Bytes{0xFE});
}

TEST_F(UnixSpi, WhoWatchedTheReadyLineAsksNothingOfALinkThatIsClosed)
{
    UnreadLink unread(folder.path("quiet"));
    auto &[quiet, listening, clock, watched] = unread;
    watched.watchReady(std::chrono::milliseconds(5));
    watched.close();
    clock.advance(std::chrono::milliseconds(10));
    ASSERT_TRUE(watched.open());
    EXPECT_TRUE(watched.outlet().aside(Bytes{1, 0, 0xAA})) << "nothing is in the way of a stop";
}

TEST_F(UnixSpi, ClosingWhatASimulatorLeftUnreadLeavesNothingThatWouldEndTheNextOpening)
{
    UnreadLink held(folder.path("quiet"));
    {
        const Descriptor simulator(::accept(held.listening.get(), nullptr, nullptr));
        held.fill();
    }
    held.link.close();
    EXPECT_EQ(held.clock.armed(), 0U);
}

TEST_F(UnixSpi, ASimulatorThatIsSlowToReadIsNotGone)
{
    UnreadLink held(folder.path("quiet"));
    const Descriptor simulator(::accept(held.listening.get(), nullptr, nullptr));
    held.fill();
    held.clock.advance(std::chrono::milliseconds(1));
    EXPECT_EQ(held.link.state(), LinkState::Open);
}

TEST(UnixSocket, WhatHasComeIsTakenAndOnlyItsEndIsAnEnd)
{
    for (const bool unread : {false, true}) { // what the one who goes has not read breaks the socket
        std::array<int, 2> ends{-1, -1};
        ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()), 0);
        const Descriptor own(ends[0]);
        Bytes in;
        {
            const Descriptor other(ends[1]);
            EXPECT_TRUE(receiveFrom(own.get(), in)) << "nothing has come, or another has read it";
            EXPECT_EQ(in, Bytes{});
            for (const std::uint8_t byte : Bytes{1, 2}) {
                ASSERT_EQ(::send(other.get(), &byte, 1, 0), 1);
                errno = EAGAIN; // of some call before
                EXPECT_TRUE(receiveFrom(own.get(), in));
            }
            EXPECT_EQ(in, (Bytes{1, 2}));
            if (unread) {
                ASSERT_EQ(::send(own.get(), "x", 1, 0), 1);
            }
        }
        EXPECT_FALSE(receiveFrom(own.get(), in)) << unread;
        EXPECT_EQ(in, (Bytes{1, 2}));
    }
}

TEST_F(UnixSpi, NothingIsSentAsideOfALinkThatIsClosed)
{
    const auto aside = link.outlet().aside;
    link.close();
    EXPECT_FALSE(aside(Bytes{2, 0, 0xAA, 0xBB}));
}

TEST_F(UnixSpi, TheClientOfABoardThatIsClosedHasLostItAtOnce)
{
    Task<Bytes> first = transferOn(link, {0x01});
    first.start();
    ASSERT_TRUE(loop.runUntil([&] { return first.isFinished(); }));
    server.close();
    EXPECT_TRUE(loop.runUntil([&] { return link.state() == LinkState::Lost; }));
}

TEST_F(UnixSpi, ASecondClientIsToldAtOnceThatTheBoardIsBusyAndTheFirstKeepsIt)
{
    Task<Bytes> first = transferOn(link, {0x01});
    first.start();
    ASSERT_TRUE(loop.runUntil([&] { return first.isFinished(); }));
    UnixSpiLink second{address, loop.clock()};
    ASSERT_TRUE(second.open());
    Task<Bytes> refused = transferOn(second, {0x02});
    refused.start();
    ASSERT_TRUE(loop.runUntil([&] { return second.state() == LinkState::Lost && refused.isFinished(); }));
    EXPECT_EQ(second.loss().ailment, Ailment::Busy);
    Task<Bytes> again = transferOn(link, {0x03});
    again.start();
    ASSERT_TRUE(loop.runUntil([&] { return again.isFinished(); }));
    EXPECT_EQ(*again.result(), Bytes{0xFC});
    EXPECT_EQ(board.heard, (std::vector<Bytes>{{0x01}, {0x03}}));
}

TEST_F(UnixSpi, WhoComesAfterTheFirstHasGoneIsServedHoweverSoonAndTheLastWordOfTheFirstArrives)
{
    Task<Bytes> first = transferOn(link, {0x01});
    first.start();
    ASSERT_TRUE(loop.runUntil([&] { return first.isFinished(); }));
    for (std::uint8_t round = 0; round < 20; ++round) {
        Task<Bytes> last = transferOn(link, {0x02});
        last.start();
        link.close();
        ASSERT_TRUE(link.open()); // the server has seen none of it yet
        Task<Bytes> next = transferOn(link, {0x03});
        next.start();
        ASSERT_TRUE(loop.runUntil([&] { return next.isFinished(); }));
        ASSERT_EQ(*next.result(), Bytes{0xFC});
        ASSERT_EQ(board.heard.back(), Bytes{0x03});
        ASSERT_EQ(board.heard[board.heard.size() - 2], Bytes{0x02});
    }
}

} // namespace mb
