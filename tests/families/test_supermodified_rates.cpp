// SPDX-License-Identifier: GPL-3.0-or-later
// The rate of a line changes in the background: a driver that takes its time holds up neither other lines nor a stop's lane.
#include "async/virtualclock.h"
#include "families/supermodified/line.h"
#include "support/eventloop.h"
#include "support/heldbackground.h"
#include "support/pseudoterminal.h"
#include "transport/backends/serialdriver.h"
#include "transport/backends/serialport.h"

#include <gtest/gtest.h>

#include <optional>

#include <poll.h>

namespace mb::supermodified {
namespace {

using namespace std::chrono_literals;
using Rank = Line::Rank;

class Rates : public testing::Test {
protected:
    void SetUp() override
    {
        ASSERT_TRUE(link->open());
        link->settings().background = &background;
        line = Line::of(*link, clock);
        clock.advance(100ms); // the line was silent for long enough
    }
    [[nodiscard]] static std::unique_ptr<SerialLink> make(const std::string &path, Clock &clock)
    {
        auto made = makeSerialPortLink(*LinkAddress::parse("serial:" + path), clock);
        EXPECT_TRUE(made);
        return std::unique_ptr<SerialLink>(static_cast<SerialLink *>(made->release()));
    }
    [[nodiscard]] Line::Ticket ask(std::uint8_t node, int rate, Rank rank, std::optional<Result<Frame>> &answer)
    {
        Line::Request request;
        request.frame.to = node;
        request.frame.command = static_cast<std::uint8_t>(rank == Rank::Stop ? Command::Stop : Command::GetP);
        request.baudrate = rate;
        request.rank = rank;
        return line->submit(request, [&answer](Result<Frame> result) { answer = std::move(result); });
    }

    mb::test::EventLoop loop;
    VirtualClock clock;
    mb::test::HeldBackground background;
    mb::test::PseudoTerminal terminal;
    std::unique_ptr<SerialLink> link = make(terminal.path(), clock);
    std::shared_ptr<Line> line;
    std::optional<Result<Frame>> first;
    std::optional<Result<Frame>> second;
};

TEST_F(Rates, NothingIsSentBeforeTheDriverHasTheNewRate)
{
    const auto ticket = ask(4, 57600, Rank::Task, first);
    clock.advance(1s);
    EXPECT_EQ(background.waiting(), 1U);
    EXPECT_TRUE(terminal.read().empty());
    EXPECT_EQ(link->baudrate(), 115200);
    EXPECT_FALSE(first) << "its time begins when it is sent";
    background.release();
    clock.advance(1ms);
    EXPECT_EQ(link->baudrate(), 57600);
    EXPECT_EQ(driverBaudrate(link->outlet().descriptor), 57600);
    EXPECT_FALSE(terminal.read().empty());
    clock.advance(1s);
    ASSERT_TRUE(first);
    EXPECT_EQ(first->error().fault, Fault::Timeout);
}

TEST_F(Rates, AStopThatComesMeanwhileIsTheNextToBeSent)
{
    const auto ticket = ask(4, 57600, Rank::Task, first);
    std::optional<Result<Frame>> other;
    const auto later = ask(5, 57600, Rank::Task, other);
    const auto stop = ask(6, 57600, Rank::Stop, second);
    background.release();
    clock.advance(1ms);
    (void)terminal.read();
    clock.advance(10ms); // the one in flight has its three milliseconds
    const auto bytes = terminal.read();
    ASSERT_GT(bytes.size(), 2U);
    EXPECT_EQ(bytes[2], 6) << "the node that is to stop";
}

TEST_F(Rates, WhatNobodyWantsAnyMoreIsNotAnsweredAndTheLineGoesOn)
{
    {
        const auto ticket = ask(4, 57600, Rank::Task, first);
    }
    const auto next = ask(5, 115200, Rank::Task, second);
    background.release();
    clock.advance(1s);
    background.release();
    clock.advance(1s);
    EXPECT_FALSE(first);
    ASSERT_TRUE(second);
    EXPECT_EQ(second->error().fault, Fault::Timeout);
    EXPECT_EQ(link->baudrate(), 115200);
}

TEST_F(Rates, ALinkThatIsClosedMeanwhileAnswersAndKeepsItsRate)
{
    const auto ticket = ask(4, 57600, Rank::Task, first);
    link->close();
    clock.advance(1ms);
    ASSERT_TRUE(first);
    EXPECT_EQ(first->error().fault, Fault::LinkLost);
    EXPECT_EQ(link->baudrate(), 115200);
    background.release();
    clock.advance(1s);
    EXPECT_EQ(link->baudrate(), 115200) << "too late: nobody waits for it";
}

TEST_F(Rates, ADriverThatDoesNotAnswerLosesTheLinkWithItsRemedy)
{
    const auto ticket = ask(4, 57600, Rank::Task, first);
    clock.advance(Link::openLimit + 1ms);
    EXPECT_EQ(link->state(), LinkState::Lost);
    EXPECT_NE(
        link->loss().message().english().find("its driver has not answered for 5 s; unplug it"), std::string::npos)
        << link->loss().message();
    ASSERT_TRUE(first);
    EXPECT_EQ(first->error().fault, Fault::LinkLost);
    background.release();
}

TEST_F(Rates, ThePortIsClosedInTheBackgroundBecauseItsDriverMayWaitForWhatItHasToSend)
{
    link->close();
    EXPECT_EQ(link->state(), LinkState::Closed);
    ASSERT_EQ(background.waiting(), 1U);
    EXPECT_EQ(background.lane(), terminal.path());
    pollfd master{terminal.descriptor(), POLLIN, 0};
    EXPECT_EQ(::poll(&master, 1, 0) == 1 && (master.revents & POLLHUP) != 0, false) << "somebody has it still";
    background.release();
    ASSERT_EQ(::poll(&master, 1, 0), 1);
    EXPECT_TRUE((master.revents & POLLHUP) != 0);
}

} // namespace
} // namespace mb::supermodified
