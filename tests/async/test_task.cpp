// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/sleep.h"
#include "async/task.h"
#include "async/virtualclock.h"
#include "latertasks.h"
#include "witness.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace mb;
using namespace std::chrono_literals;
using test::failLater;
using test::valueLater;
using test::valueNow;
using test::Witness;

namespace {

// Every level of a chain takes stack; AddressSanitizer takes several times as much of it.
#if defined(__SANITIZE_ADDRESS__)
constexpr int deep = 2'000;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr int deep = 2'000;
#else
constexpr int deep = 10'000;
#endif
#else
constexpr int deep = 10'000;
#endif

Task<int> failNow()
{
    co_return fail(Fault::Refused, say("now"));
}

Task<void> nothing()
{
    co_return {};
}

Task<std::string> textLater(Clock &clock, std::string text)
{
    co_await Sleep(clock, 1ms);
    co_return text + "!";
}

Task<int> sumOf(Clock &clock, int &alive)
{
    const Witness outer(alive);
    const int a = co_await valueNow(40);
    const int b = co_await valueLater(clock, 2);
    co_return a + b;
}

Task<int> passesOn(Task<int> inner, int &alive, bool &reached)
{
    const Witness local(alive);
    const int value = co_await std::move(inner);
    reached = true;
    co_return value;
}

Task<std::string> tries(Task<int> inner)
{
    const Result<int> result = co_await std::move(inner).attempt();
    co_return result ? std::to_string(*result) : std::string(toString(result.error().fault));
}

Task<int> nested(Clock &clock, int depth, int &alive)
{
    const Witness local(alive);
    if (depth == 0) {
        co_await Sleep(clock, 1ms);
        co_return 0;
    }
    const int below = co_await nested(clock, depth - 1, alive);
    co_return below + 1;
}

Task<int> nestedFailure(Clock &clock, int depth)
{
    auto inner = depth == 0 ? failLater(clock) : nestedFailure(clock, depth - 1);
    co_return co_await std::move(inner);
}

Task<int> suspendsThenFailsInline(Clock &clock, int &alive)
{
    const Witness local(alive);
    co_await Sleep(clock, 1ms);
    co_return co_await failNow();
}

Task<int> manyInline(int count)
{
    int sum = 0;
    for (int i = 0; i < count; ++i) {
        auto one = valueNow(1);
        sum += co_await std::move(one);
    }
    co_return sum;
}

Task<int> threeSteps(Clock &clock, int &alive)
{
    const Witness all(alive);
    for (int i = 0; i < 3; ++i) {
        const Witness step(alive);
        co_await valueLater(clock, i);
    }
    co_await Sleep(clock, 1ms);
    co_return 3;
}

} // namespace

TEST(Task, DoesNothingUntilItIsStarted)
{
    VirtualClock clock;
    int alive = 0;
    {
        auto task = sumOf(clock, alive);
        EXPECT_EQ(alive, 0);
        EXPECT_FALSE(task.isFinished());
    }
    EXPECT_EQ(alive, 0);
    EXPECT_EQ(clock.armed(), 0U);
}

TEST(Task, YieldsItsValueAndSaysSoOnce)
{
    VirtualClock clock;
    int alive = 0;
    int calls = 0;
    auto task = sumOf(clock, alive);
    task.start([&calls] { ++calls; });
    EXPECT_FALSE(task.isFinished());
    EXPECT_EQ(alive, 1);
    clock.advance(1ms);
    ASSERT_TRUE(task.isFinished());
    EXPECT_EQ(task.result().value(), 42);
    EXPECT_EQ(calls, 1);
    EXPECT_EQ(alive, 0);
}

TEST(Task, FinishesInlineWhenNothingSuspends)
{
    int calls = 0;
    auto task = manyInline(3);
    task.start([&calls] { ++calls; });
    EXPECT_TRUE(task.isFinished());
    EXPECT_EQ(task.result().value(), 3);
    EXPECT_EQ(calls, 1);
}

TEST(Task, OfVoidFinishesWithoutAValue)
{
    auto task = nothing();
    task.start();
    ASSERT_TRUE(task.isFinished());
    EXPECT_TRUE(task.result().has_value());
}

TEST(Task, MovesTextThroughASuspension)
{
    VirtualClock clock;
    auto task = textLater(clock, "a text that is too long for the small string buffer");
    task.start();
    clock.advance(1ms);
    EXPECT_EQ(task.result().value(), "a text that is too long for the small string buffer!");
}

TEST(Task, HandsAnInlineFailureToItsCallerWithoutRunningTheRest)
{
    int alive = 0;
    bool reached = false;
    auto task = passesOn(failNow(), alive, reached);
    task.start();
    ASSERT_TRUE(task.isFinished());
    EXPECT_EQ(task.result().error(), (Error{Fault::Refused, say("now")}));
    EXPECT_FALSE(reached);
    task.cancel();
    EXPECT_EQ(alive, 0);
}

TEST(Task, HandsALaterFailureThroughSeveralCallers)
{
    VirtualClock clock;
    int alive = 0;
    bool reached = false;
    auto inner = passesOn(failLater(clock), alive, reached);
    auto task = passesOn(std::move(inner), alive, reached);
    int calls = 0;
    task.start([&calls] { ++calls; });
    clock.advance(1ms);
    ASSERT_TRUE(task.isFinished());
    EXPECT_EQ(task.result().error(), (Error{Fault::Timeout, say("later")}));
    EXPECT_FALSE(reached);
    EXPECT_EQ(calls, 1);
    task.cancel();
    EXPECT_EQ(alive, 0);
}

TEST(Task, AnInlineFailureAfterASuspensionReachesSuspendedCallers)
{
    VirtualClock clock;
    int alive = 0;
    bool reached = false;
    auto task = tries(passesOn(suspendsThenFailsInline(clock, alive), alive, reached));
    task.start();
    EXPECT_EQ(alive, 2);
    clock.advance(1ms);
    ASSERT_TRUE(task.isFinished());
    EXPECT_EQ(task.result().value(), "refused");
    EXPECT_FALSE(reached);
    EXPECT_EQ(alive, 0);
}

TEST(Task, AttemptYieldsValueOrFaultWithoutEndingTheCaller)
{
    VirtualClock clock;
    std::vector<Task<std::string>> tasks;
    tasks.push_back(tries(valueNow(7)));
    tasks.push_back(tries(failNow()));
    tasks.push_back(tries(valueLater(clock, 8)));
    tasks.push_back(tries(failLater(clock)));
    for (auto &task : tasks)
        task.start();
    clock.advance(1ms);
    std::vector<std::string> results;
    for (auto &task : tasks)
        results.push_back(task.result().value());
    EXPECT_EQ(results, (std::vector<std::string>{"7", "refused", "8", "timeout"}));
}

TEST(Task, CancelledAtAnySuspensionPointDestroysItsLocalsAndTimers)
{
    for (int steps = 0; steps <= 4; ++steps) {
        VirtualClock clock;
        int alive = 0;
        auto task = threeSteps(clock, alive);
        task.start();
        for (int i = 0; i < steps; ++i)
            ASSERT_TRUE(clock.step());
        EXPECT_EQ(task.isFinished(), steps == 4) << steps;
        task.cancel();
        EXPECT_EQ(alive, 0) << steps;
        EXPECT_EQ(clock.armed(), 0U) << steps;
    }
}

TEST(Task, NestsDeepAndUnwindsWithItsValue)
{
    VirtualClock clock;
    int alive = 0;
    auto task = nested(clock, deep, alive);
    task.start();
    EXPECT_EQ(alive, deep + 1);
    clock.advance(1ms);
    ASSERT_TRUE(task.isFinished());
    EXPECT_EQ(task.result().value(), deep);
    EXPECT_EQ(alive, 0);
}

TEST(Task, CancelsADeepChain)
{
    VirtualClock clock;
    int alive = 0;
    auto task = nested(clock, deep, alive);
    task.start();
    task.cancel();
    EXPECT_EQ(alive, 0);
    EXPECT_EQ(clock.armed(), 0U);
}

TEST(Task, HandsAFailureThroughADeepChain)
{
    VirtualClock clock;
    auto task = nestedFailure(clock, deep);
    task.start();
    clock.advance(1ms);
    ASSERT_TRUE(task.isFinished());
    EXPECT_EQ(task.result().error().fault, Fault::Timeout);
}

TEST(Task, InlineCompletionsInALoopNeedNoStack)
{
    auto task = manyInline(1'000'000);
    task.start();
    EXPECT_EQ(task.result().value(), 1'000'000);
}

TEST(Task, MovingOverATaskCancelsTheOldOne)
{
    VirtualClock clock;
    int alive = 0;
    auto task = threeSteps(clock, alive);
    task.start();
    task = sumOf(clock, alive);
    EXPECT_EQ(alive, 0);
    EXPECT_EQ(clock.armed(), 0U);
}
