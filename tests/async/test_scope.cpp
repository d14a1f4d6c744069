// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/scope.h"
#include "async/sleep.h"
#include "async/virtualclock.h"
#include "latertasks.h"
#include "witness.h"

#include <gtest/gtest.h>

#include <memory>

using namespace mb;
using namespace std::chrono_literals;
using test::failLater;
using test::valueLater;
using test::valueNow;
using test::Witness;

namespace {

Task<int> passesOnAlive(Task<int> inner, int &alive, bool &reached)
{
    const Witness local(alive);
    const int value = co_await std::move(inner);
    reached = true;
    co_return value;
}

Task<int> sleeps(Clock &clock, int &alive)
{
    const Witness all(alive);
    co_await Sleep(clock, 3ms);
    co_return 3;
}

} // namespace

TEST(Scope, TellsTheResultFromTheClockNotFromTheTask)
{
    VirtualClock clock;
    Scope scope(clock);
    int got = 0;
    scope.spawn<int>(valueNow(5), [&got](Result<int> result) { got = *result; });
    EXPECT_EQ(got, 0);
    EXPECT_FALSE(scope.isIdle());
    clock.advance(0ms);
    EXPECT_EQ(got, 5);
    EXPECT_TRUE(scope.isIdle());
}

TEST(Scope, ForgetsTasksWithoutACallback)
{
    VirtualClock clock;
    Scope scope(clock);
    scope.spawn<int>(valueLater(clock, 1));
    scope.spawn<int>(failLater(clock));
    clock.advance(1ms);
    EXPECT_TRUE(scope.isIdle());
    EXPECT_EQ(clock.armed(), 0U);
}

TEST(Scope, CancelsWhatStillRunsWhenItIsDestroyed)
{
    VirtualClock clock;
    int alive = 0;
    bool told = false;
    {
        Scope scope(clock);
        scope.spawn<int>(sleeps(clock, alive), [&told](Result<int>) { told = true; });
        scope.spawn<int>(valueNow(1), [&told](Result<int>) { told = true; });
        EXPECT_EQ(alive, 1);
    }
    EXPECT_EQ(alive, 0);
    EXPECT_EQ(clock.armed(), 0U);
    clock.advance(1s);
    EXPECT_FALSE(told);
}

TEST(Scope, MayBeDestroyedByItsFinishedCallback)
{
    VirtualClock clock;
    int alive = 0;
    auto scope = std::make_unique<Scope>(clock);
    scope->spawn<int>(sleeps(clock, alive));
    bool told = false;
    scope->spawn<int>(valueNow(1), [&scope, &told](Result<int>) {
        scope.reset();
        told = true;
    });
    clock.advance(0ms);
    EXPECT_TRUE(told);
    EXPECT_EQ(scope, nullptr);
    EXPECT_EQ(alive, 0);
    EXPECT_EQ(clock.armed(), 0U);
}

TEST(Scope, LocalsOfAFailedTaskAreGoneWhenItsCallbackRuns)
{
    VirtualClock clock;
    Scope scope(clock);
    int alive = 0;
    int aliveInCallback = -1;
    bool reached = false;
    scope.spawn<int>(passesOnAlive(failLater(clock), alive, reached), [&](Result<int> result) {
        EXPECT_FALSE(result.has_value());
        aliveInCallback = alive;
    });
    clock.advance(1ms);
    EXPECT_EQ(aliveInCallback, 0);
    EXPECT_FALSE(reached);
}

TEST(Scope, MaySpawnFromItsFinishedCallback)
{
    VirtualClock clock;
    Scope scope(clock);
    int got = 0;
    scope.spawn<int>(valueNow(1),
        [&](Result<int>) { scope.spawn<int>(valueLater(clock, 2), [&got](Result<int> result) { got = *result; }); });
    clock.advance(1ms);
    EXPECT_EQ(got, 2);
    EXPECT_TRUE(scope.isIdle());
}
