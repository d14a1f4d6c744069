// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/sleep.h"
#include "async/task.h"
#include "async/turns.h"
#include "async/virtualclock.h"

#include <gtest/gtest.h>

#include <string>

namespace mb {
namespace {

using namespace std::chrono_literals;

Task<void> talk(Turns &turns, Clock &clock, char name, std::string &said)
{
    const Turns::Turn turn = co_await turns.take();
    said += name;
    co_await Sleep(clock, 1ms);
    said += name;
    co_return {};
}

struct TurnsTest : testing::Test {
    VirtualClock clock;
    Turns turns{clock};
    std::string said;
};

TEST_F(TurnsTest, OneTalksAtATimeInTheOrderOfAsking)
{
    Task<void> a = talk(turns, clock, 'a', said);
    Task<void> b = talk(turns, clock, 'b', said);
    Task<void> c = talk(turns, clock, 'c', said);
    a.start();
    b.start();
    c.start();
    clock.advance(10ms);
    EXPECT_EQ(said, "aabbcc");
    EXPECT_TRUE(turns.isFree());
}

TEST_F(TurnsTest, WhoIsCancelledWhileTalkingLetsTheNextOneTalk)
{
    Task<void> a = talk(turns, clock, 'a', said);
    Task<void> b = talk(turns, clock, 'b', said);
    a.start();
    b.start();
    a.cancel();
    clock.advance(10ms);
    EXPECT_EQ(said, "abb");
}

TEST_F(TurnsTest, WhoIsCancelledWhileWaitingIsPassedOver)
{
    Task<void> a = talk(turns, clock, 'a', said);
    Task<void> b = talk(turns, clock, 'b', said);
    Task<void> c = talk(turns, clock, 'c', said);
    a.start();
    b.start();
    c.start();
    b.cancel();
    clock.advance(10ms);
    EXPECT_EQ(said, "aacc");
    EXPECT_TRUE(turns.isFree());
}

} // namespace
} // namespace mb
