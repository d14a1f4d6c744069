// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/sleep.h"
#include "async/virtualclock.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

using namespace mb;
using namespace std::chrono_literals;

TEST(VirtualClock, RunsWorkInTheOrderOfDeadlinesThenOfArming)
{
    VirtualClock clock;
    std::string order;
    clock.arm(clock.now() + 2ms, [&order] { order += 'c'; });
    clock.arm(clock.now() + 1ms, [&order] { order += 'a'; });
    clock.arm(clock.now() + 2ms, [&order] { order += 'd'; });
    clock.arm(clock.now() + 1ms, [&order] { order += 'b'; });
    clock.advance(2ms);
    EXPECT_EQ(order, "abcd");
}

TEST(VirtualClock, StandsAtTheDeadlineWhileItsWorkRunsAndAtTheEndAfterwards)
{
    VirtualClock clock;
    Instant seen{};
    clock.arm(clock.now() + 3ms, [&] { seen = clock.now(); });
    clock.advance(10ms);
    EXPECT_EQ(seen.time_since_epoch(), 3ms);
    EXPECT_EQ(clock.now().time_since_epoch(), 10ms);
}

TEST(VirtualClock, RunsPastDeadlinesNowAndNeverGoesBack)
{
    VirtualClock clock;
    clock.advance(5ms);
    Instant seen{};
    clock.arm(Instant(1ms), [&] { seen = clock.now(); });
    EXPECT_TRUE(clock.step());
    EXPECT_EQ(seen.time_since_epoch(), 5ms);
}

TEST(VirtualClock, PostedWorkRunsAfterThePresentCallback)
{
    VirtualClock clock;
    std::string order;
    clock.post([&] {
        clock.post([&order] { order += '2'; });
        order += '1';
    });
    clock.advance(0ms);
    EXPECT_EQ(order, "12");
}

TEST(VirtualClock, DisarmedWorkDoesNotRunEvenFromTheSameDeadline)
{
    VirtualClock clock;
    bool ran = false;
    Clock::Key second{};
    clock.arm(clock.now() + 1ms, [&] { clock.disarm(second); });
    second = clock.arm(clock.now() + 1ms, [&ran] { ran = true; });
    clock.advance(1ms);
    EXPECT_FALSE(ran);
    clock.disarm(second);
    EXPECT_EQ(clock.armed(), 0U);
}

TEST(VirtualClock, DisarmingMayDestroyWhatDisarmsOtherWork)
{
    VirtualClock clock;
    auto timer = std::make_shared<Timer>(clock);
    timer->start(clock.now() + 2ms, [] {});
    const auto key = clock.arm(clock.now() + 1ms, [timer] {});
    timer.reset();
    clock.disarm(key);
    EXPECT_EQ(clock.armed(), 0U);
}

TEST(VirtualClock, RunUntilEndsWhenDoneWhenDryAndAtTheLimit)
{
    VirtualClock clock;
    int count = 0;
    Timer timer(clock);
    std::function<void()> again = [&] {
        ++count;
        timer.startIn(1ms, again);
    };
    EXPECT_FALSE(clock.runUntil([] { return false; }));
    timer.startIn(1ms, again);
    EXPECT_TRUE(clock.runUntil([&count] { return count == 5; }));
    EXPECT_EQ(clock.now().time_since_epoch(), 5ms);
    EXPECT_FALSE(clock.runUntil([] { return false; }, 10ms));
    EXPECT_EQ(count, 15);
}

TEST(Timer, KeepsOnlyTheLastDeadline)
{
    VirtualClock clock;
    int runs = 0;
    Timer timer(clock);
    timer.startIn(1ms, [&runs] { runs += 1; });
    timer.startIn(5ms, [&runs] { runs += 10; });
    EXPECT_EQ(clock.armed(), 1U);
    clock.advance(2ms);
    EXPECT_EQ(runs, 0);
    EXPECT_TRUE(timer.isActive());
    clock.advance(3ms);
    EXPECT_EQ(runs, 10);
    EXPECT_FALSE(timer.isActive());
}

TEST(Timer, IsInactiveInItsOwnCallbackAndMayBeStartedThere)
{
    VirtualClock clock;
    Timer timer(clock);
    bool active = true;
    int runs = 0;
    timer.startIn(1ms, [&] {
        active = timer.isActive();
        timer.startIn(1ms, [&runs] { ++runs; });
    });
    clock.advance(2ms);
    EXPECT_FALSE(active);
    EXPECT_EQ(runs, 1);
}

TEST(Timer, MayBeDestroyedByItsCallback)
{
    VirtualClock clock;
    auto timer = std::make_unique<Timer>(clock);
    bool after = false;
    timer->startIn(1ms, [&timer, &after] {
        timer.reset();
        after = true;
    });
    clock.advance(1ms);
    EXPECT_TRUE(after);
    EXPECT_EQ(clock.armed(), 0U);
}

TEST(Timer, IsForgottenWithItsOwner)
{
    VirtualClock clock;
    bool ran = false;
    {
        Timer timer(clock);
        timer.startIn(1ms, [&ran] { ran = true; });
    }
    EXPECT_EQ(clock.armed(), 0U);
    clock.advance(1s);
    EXPECT_FALSE(ran);
}
