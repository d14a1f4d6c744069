// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/background.h"
#include "async/scope.h"
#include "async/virtualclock.h"
#include "support/heldbackground.h"

#include <gtest/gtest.h>

#include <optional>

namespace mb {
namespace {

using namespace std::chrono_literals;

class InBackground : public testing::Test {
protected:
    void ask(WhenLate whenLate = WhenLate::Drop)
    {
        scope.spawn<int>(inBackground<int>(
                             background, clock, "lane", 5s, [this]() -> Result<int> { return ++worked; }, whenLate),
            [this](Result<int> result) { answer = std::move(result); });
    }

    VirtualClock clock;
    test::HeldBackground background;
    Scope scope{clock};
    int worked = 0;
    std::optional<Result<int>> answer;
};

} // namespace

TEST_F(InBackground, YieldsWhatTheWorkYields)
{
    ask();
    clock.advance(4s);
    EXPECT_FALSE(answer);
    background.release();
    clock.advance(1ms);
    ASSERT_TRUE(answer && *answer);
    EXPECT_EQ(**answer, 1);
}

TEST_F(InBackground, EndsAfterItsLimitAndDropsWhatHasNotBegun)
{
    ask();
    clock.advance(5001ms);
    ASSERT_TRUE(answer && !*answer);
    EXPECT_EQ(answer->error().fault, Fault::Timeout);
    background.release();
    EXPECT_EQ(worked, 0) << "nobody waits for it any more";
}

TEST_F(InBackground, FinishesLateWhatMustBeDone)
{
    ask(WhenLate::Finish);
    clock.advance(6s);
    ASSERT_TRUE(answer && !*answer);
    background.release();
    EXPECT_EQ(worked, 1);
}

TEST_F(InBackground, CancelledHearsNothingMore)
{
    ask();
    scope.clear();
    background.release();
    clock.advance(10s);
    EXPECT_FALSE(answer);
    EXPECT_EQ(worked, 0);
}

} // namespace mb
