// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/virtualclock.h"
#include "transport/pacedclock.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace mb {
namespace {

using namespace std::chrono_literals;

constexpr Instant recordedAt{1436509052s};

TEST(PacedClock, StandsUntilItIsLetRun)
{
    VirtualClock outer;
    PacedClock clock(outer);
    clock.jump(recordedAt);
    bool ran = false;
    clock.arm(recordedAt + 1s, [&ran] { ran = true; });
    outer.advance(1h);
    EXPECT_FALSE(ran);
    EXPECT_EQ(clock.now(), recordedAt);
    clock.run(1.0);
    outer.advance(999ms);
    EXPECT_FALSE(ran);
    EXPECT_EQ(clock.now(), recordedAt + 999ms);
    outer.advance(1ms);
    EXPECT_TRUE(ran);
}

TEST(PacedClock, RunsWorkAtItsDeadlineWhateverThePace)
{
    for (const double pace : {0.01, 0.3, 1.0, 2.0, 7.0, 1000.0, 0.0}) {
        VirtualClock outer;
        outer.advance(123s);
        PacedClock clock(outer);
        clock.jump(recordedAt);
        std::vector<Duration> seen;
        const std::function<void()> again = [&] {
            seen.push_back(clock.now() - recordedAt);
            if (seen.size() < 1000)
                clock.arm(clock.now() + 333us, again);
        };
        clock.arm(recordedAt + 1ms, again);
        clock.run(pace);
        const Instant start = outer.now();
        ASSERT_TRUE(outer.runUntil([&] { return seen.size() == 1000; })) << pace;
        for (std::size_t i = 0; i < seen.size(); ++i)
            ASSERT_EQ(seen[i], 1ms + static_cast<int>(i) * Duration(333us)) << pace;
        const double took = std::chrono::duration<double>(outer.now() - start).count();
        EXPECT_NEAR(took, pace == 0.0 ? 0.0 : 0.333667 / pace, 1e-6) << pace;
    }
}

TEST(PacedClock, ChangesItsPaceWithoutAJump)
{
    VirtualClock outer;
    PacedClock clock(outer);
    clock.jump(recordedAt);
    clock.run(2.0);
    outer.advance(3s);
    clock.run(0.5);
    EXPECT_EQ(clock.now(), recordedAt + 6s);
    outer.advance(2s);
    clock.pause();
    outer.advance(2s);
    EXPECT_EQ(clock.now(), recordedAt + 7s);
    EXPECT_FALSE(clock.isRunning());
}

TEST(PacedClock, JumpsBackAndKeepsWhatIsArmed)
{
    VirtualClock outer;
    PacedClock clock(outer);
    clock.jump(recordedAt);
    int ran = 0;
    clock.run(1.0);
    outer.advance(10s);
    clock.arm(recordedAt + 11s, [&ran] { ++ran; });
    clock.jump(recordedAt);
    outer.advance(10s);
    EXPECT_EQ(ran, 0);
    outer.advance(1s);
    EXPECT_EQ(ran, 1);
}

TEST(PacedClock, GivesOthersTheirTurnAtFullSpeed)
{
    VirtualClock outer;
    PacedClock clock(outer);
    const std::function<void()> forever = [&] { clock.arm(clock.now() + 1us, forever); };
    clock.arm(clock.now(), forever);
    clock.run(0.0);
    bool turn = false;
    ASSERT_TRUE(outer.step());
    outer.post([&turn] { turn = true; });
    for (int i = 0; i < 3 && !turn; ++i)
        outer.step();
    EXPECT_TRUE(turn);
    clock.pause();
    EXPECT_FALSE(outer.step()) << "a clock that stands needs nothing of the outer one";
}

} // namespace
} // namespace mb
