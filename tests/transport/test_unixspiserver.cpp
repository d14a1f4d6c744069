// SPDX-License-Identifier: GPL-3.0-or-later
// Both ends of a simulated board's socket byte by byte, in virtual time: what the link asks, and what the board's side answers when.
#include "async/descriptor.h"
#include "async/virtualclock.h"
#include "support/eventloop.h"
#include "support/temporaryfile.h"
#include "transport/backends/unixsocket.h"
#include "transport/backends/unixspi.h"
#include "transport/backends/unixspiserver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <sys/socket.h>

namespace mb {
namespace {

using namespace std::chrono_literals;
using Bytes = SpiLink::Bytes;

Bytes waiting(int socket)
{
    Bytes bytes(65536);
    const auto got = ::recv(socket, bytes.data(), bytes.size(), MSG_DONTWAIT);
    bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
    return bytes;
}

bool isHungUp(int socket)
{
    std::uint8_t byte = 0;
    return ::recv(socket, &byte, 1, MSG_DONTWAIT) == 0;
}

void put(int socket, const Bytes &bytes)
{
    ASSERT_EQ(::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL), ssize_t(bytes.size()));
}

// The board's side

/// Answers each byte with its complement.
struct PacedBoard final : SpiSlave {
    void transfer(std::span<const std::uint8_t> mosi, std::span<std::uint8_t> miso) override
    {
        std::transform(mosi.begin(), mosi.end(), miso.begin(), [](auto b) { return static_cast<std::uint8_t>(~b); });
    }
    [[nodiscard]] bool isReady() const override { return true; }
    void reset() override { ++resets; }
    int resets = 0;
};

struct BoardSocket : testing::Test {
    void serve(const std::string &options)
    {
        auto made = UnixSpiServer::create(*LinkAddress::parse("unix:" + path + options), clock);
        ASSERT_TRUE(made);
        server = std::move(*made);
        server->attach(&board);
        ASSERT_TRUE(server->open());
    }
    [[nodiscard]] int connected() const { return connectUnixSocket(path).value_or(-1); }

    test::EventLoop loop;
    test::TemporaryFolder folder;
    std::string path = folder.path("board");
    VirtualClock clock;
    PacedBoard board;
    std::unique_ptr<UnixSpiServer> server;
};

TEST_F(BoardSocket, HasTheOptionPaceAndNoOther)
{
    const auto refusal = [this](const std::string &options) {
        const auto made = UnixSpiServer::create(*LinkAddress::parse("unix:" + path + options), clock);
        EXPECT_TRUE(made || made.error().fault == Fault::OutOfRange);
        return made ? std::string() : made.error().text();
    };
    EXPECT_EQ(refusal(""), "");
    EXPECT_EQ(refusal("?pace=0"), "");
    EXPECT_EQ(refusal("?pace=1"), "");
    EXPECT_EQ(refusal("?pace=2"), "pace=2 is no choice; legal are 0 and 1");
    EXPECT_EQ(refusal("?speed=1"), "a simulated board's socket has no option 'speed'; it has pace");
}

TEST_F(BoardSocket, AnswersAtOnceOrAfterSixteenMicrosecondsAByteOneTransferAfterTheOther)
{
    for (const bool paced : {false, true}) {
        serve(paced ? "?pace=1" : "?pace=0");
        const Descriptor client(connected());
        loop.runReady();
        std::vector<Traffic> seen;
        const auto tap = server->traffic().add([&seen](const Traffic &traffic) { seen.push_back(traffic); });
        put(client.get(), {2, 0, 1, 2, 0xFF, 0xFF, 0, 0, 3, 0, 4, 5});
        loop.runReady();
        if (paced) {
            clock.advance(32us - 1ns);
            EXPECT_EQ(waiting(client.get()), Bytes{});
            clock.advance(1ns);
        }
        EXPECT_EQ(waiting(client.get()), (Bytes{0xFE, 0xFD, 1, 1, 1})) << "the transfer, the reset, the level alone";
        EXPECT_EQ(board.resets, paced ? 2 : 1);
        EXPECT_EQ(seen.size(), 2U);
        put(client.get(), {6}); // and the last byte of the third
        loop.runReady();
        if (paced) {
            clock.advance(48us - 1ns);
            EXPECT_EQ(waiting(client.get()), Bytes{});
            clock.advance(1ns);
        }
        EXPECT_EQ(waiting(client.get()), (Bytes{0xFB, 0xFA, 0xF9, 1}));
        EXPECT_EQ(server->counters().rx, 5U);
        EXPECT_EQ(server->counters().tx, 5U);
        server->close();
        EXPECT_TRUE(isHungUp(client.get()));
        EXPECT_EQ(clock.armed(), 0U);
        EXPECT_EQ(connectUnixSocket(path).error().ailment, Ailment::NotThere) << "it takes its path away";
    }
}

TEST_F(BoardSocket, TheNextIsServedOnceTheFirstHasGone)
{
    serve("?pace=1");
    {
        const Descriptor first(connected());
        loop.runReady();
        put(first.get(), {2, 0, 1, 2, 1, 0});
        loop.runReady();
    } // in the middle of its question
    loop.runReady();
    const Descriptor second(connected());
    loop.runReady();
    clock.advance(0us);
    EXPECT_EQ(clock.armed(), 0U) << "nothing of the first is left";
    loop.runReady();
    put(second.get(), {1, 0, 7});
    loop.runReady();
    clock.advance(16us);
    EXPECT_EQ(waiting(second.get()), (Bytes{0xF8, 1}));
}

TEST_F(BoardSocket, OneThatIsGoneHasHungUpAndTakenItsPathAway)
{
    serve("");
    const Descriptor client(connected());
    loop.runReady();
    EXPECT_FALSE(isHungUp(client.get()));
    server.reset();
    EXPECT_TRUE(isHungUp(client.get()));
    EXPECT_EQ(connectUnixSocket(path).error().ailment, Ailment::NotThere);
}

TEST_F(BoardSocket, WhoAsksAndNeverReadsIsCutOff)
{
    serve("");
    const Descriptor client(connected());
    loop.runReady();
    Bytes question(2 + 50'000);
    question[0] = 50'000 % 256;
    question[1] = 50'000 / 256;
    int asked = 0;
    for (; asked < 100 && clock.armed() == 0; ++asked) {
        (void)::send(client.get(), question.data(), question.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
        loop.runReady();
    }
    EXPECT_LT(asked, 100);
    clock.advance(0us);
    while (!waiting(client.get()).empty()) { }
    EXPECT_TRUE(isHungUp(client.get()));
}

// The client's side

struct BoardClient : testing::Test {
    BoardClient()
    {
        EXPECT_TRUE(link.open());
        board = std::make_unique<Descriptor>(::accept(listening.get(), nullptr, nullptr));
    }
    void answer(const Bytes &bytes)
    {
        put(board->get(), bytes);
        loop.runReady();
    }
    static Task<Bytes> transferOn(SpiLink &link, Bytes mosi)
    {
        Result<Bytes> miso = co_await link.transfer(std::move(mosi));
        co_return miso;
    }

    test::EventLoop loop;
    test::TemporaryFolder folder;
    std::string path = folder.path("board");
    VirtualClock clock;
    Descriptor listening{listenOnUnixSocket(path).value_or(-1)};
    UnixSpiLink link{*LinkAddress::parse("unix:" + path), clock};
    std::unique_ptr<Descriptor> board;
};

TEST_F(BoardClient, WhoWatchesTheReadyLineAsksForItsLevelWhenNothingElseIsAsked)
{
    EXPECT_EQ(link.ready(), false);
    link.watchReady(5ms);
    clock.advance(5ms - 1ns);
    EXPECT_EQ(waiting(board->get()), Bytes{});
    clock.advance(1ns);
    EXPECT_EQ(waiting(board->get()), (Bytes{0, 0}));
    clock.advance(20ms);
    EXPECT_EQ(waiting(board->get()), Bytes{}) << "the answer is awaited";
    answer({1});
    EXPECT_EQ(link.ready(), true);
    clock.advance(5ms);
    EXPECT_EQ(waiting(board->get()), (Bytes{0, 0}));
    answer({0});
    EXPECT_EQ(link.ready(), false);
    EXPECT_EQ(link.state(), LinkState::Open);
}

TEST_F(BoardClient, WhatTheLastBoardNeverTookIsNotSentToTheNext)
{
    while (link.outlet().aside(Bytes(50'000))) { } // until no more fits
    ASSERT_TRUE(link.pulseReset());
    link.close();
    ASSERT_TRUE(link.open());
    const Descriptor next(::accept(listening.get(), nullptr, nullptr));
    EXPECT_EQ(waiting(next.get()), Bytes{});
    Task<Bytes> asked = transferOn(link, {7});
    asked.start();
    EXPECT_EQ(waiting(next.get()), (Bytes{1, 0, 7}));
    put(next.get(), {9, 1});
    loop.runReady();
    ASSERT_TRUE(asked.isFinished());
    EXPECT_EQ(*asked.result(), Bytes{9});
}

TEST_F(BoardClient, ABoardThatIsSilentIsLostAFewLooksAfterItsLastAnswer)
{
    Task<Bytes> first = transferOn(link, {1});
    first.start();
    Task<Bytes> reset = [](SpiLink &on) -> Task<Bytes> {
        (void)on.pulseReset();
        co_return Bytes{};
    }(link);
    reset.start();
    clock.advance(900ms);
    answer({0xFE, 1});
    ASSERT_TRUE(first.isFinished());
    EXPECT_EQ(*first.result(), Bytes{0xFE});
    clock.advance(850ms - 1ns);
    EXPECT_EQ(link.state(), LinkState::Open);
    clock.advance(1ns);
    EXPECT_EQ(link.state(), LinkState::Lost) << "the fourth look after the answer";
}

TEST_F(BoardClient, ALongTransferHasTheTimeThatASlowClockTakes)
{
    Task<Bytes> asked = transferOn(link, Bytes(8192));
    asked.start();
    clock.advance(1500ms - 1ns);
    EXPECT_EQ(link.state(), LinkState::Open);
    clock.advance(1ns);
    EXPECT_EQ(link.state(), LinkState::Lost);
    EXPECT_EQ(link.loss().ailment, Ailment::Gone);
}

TEST_F(BoardClient, OfWhatWasAnsweredNothingIsWatchedAnyMore)
{
    Task<Bytes> asked = transferOn(link, {1});
    asked.start();
    answer({0xFE, 0});
    ASSERT_TRUE(asked.isFinished());
    clock.advance(10s);
    EXPECT_EQ(link.state(), LinkState::Open);
    EXPECT_EQ(clock.armed(), 0U);
}

TEST_F(BoardClient, BytesThatNobodyAskedForEndIt)
{
    answer({7});
    clock.advance(0us);
    EXPECT_EQ(link.state(), LinkState::Lost);
    EXPECT_EQ(link.loss().text(), "the simulator at " + path + " sent bytes that nobody asked for");
}

TEST_F(BoardClient, ASimulatorThatEndsAfterItsAnswerHasClosedTheConnection)
{
    Task<Bytes> asked = transferOn(link, {1});
    asked.start();
    answer({0xFE, 0});
    board.reset();
    loop.runReady();
    clock.advance(0us);
    EXPECT_EQ(link.state(), LinkState::Lost);
    EXPECT_EQ(link.loss().text(), "the simulator at " + path + " closed the connection; start it again");
    EXPECT_EQ(link.loss().ailment, Ailment::Gone);
}

} // namespace
} // namespace mb
