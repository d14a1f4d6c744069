// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/eventloop.h"

#include <gtest/gtest.h>

#include <QSocketNotifier>

#include <string>
#include <utility>

#include <unistd.h>

using namespace mb;
using namespace std::chrono_literals;

TEST(QtClock, RunsWorkInTheOrderOfDeadlinesAndNeverEarly)
{
    test::EventLoop loop;
    std::string order;
    int early = 0;
    const Instant start = loop.clock().now();
    const auto arm = [&](Duration delay, char name) {
        loop.clock().arm(start + delay, [&, delay, name] {
            order += name;
            early += loop.clock().now() < start + delay ? 1 : 0;
        });
    };
    arm(3ms, 'd');
    arm(100us, 'a');
    arm(1ms, 'b');
    arm(1ms, 'c');
    ASSERT_TRUE(loop.runUntil([&order] { return order.size() == 4; }));
    EXPECT_EQ(order, "abcd");
    EXPECT_EQ(early, 0);
}

TEST(QtClock, AnEarlierDeadlineArmedLaterIsServedFirst)
{
    test::EventLoop loop;
    std::string order;
    const Instant start = loop.clock().now();
    loop.clock().arm(start + 20ms, [&order] { order += 'b'; });
    loop.clock().arm(start + 1ms, [&order] { order += 'a'; });
    ASSERT_TRUE(loop.runUntil([&order] { return order.size() == 2; }));
    EXPECT_EQ(order, "ab");
}

TEST(QtClock, TurnsTheLoopForWhatIsDueOnly)
{
    test::EventLoop loop;
    bool due = false;
    int turns = 0;
    loop.clock().arm(loop.clock().now() + 100ms, [&due] { due = true; });
    ASSERT_TRUE(loop.runUntil([&] {
        ++turns;
        return due;
    }));
    EXPECT_LE(turns, 25) << "one every 5 ms, of the loop of the tests";
}

TEST(QtClock, DisarmedWorkDoesNotRunAndTheRestDoes)
{
    test::EventLoop loop;
    std::string order;
    const Instant start = loop.clock().now();
    const auto key = loop.clock().arm(start + 1ms, [&order] { order += 'x'; });
    loop.clock().arm(start + 2ms, [&order] { order += 'a'; });
    loop.clock().disarm(key);
    ASSERT_TRUE(loop.runUntil([&order] { return !order.empty(); }));
    EXPECT_EQ(order, "a");
    EXPECT_EQ(loop.clock().armed(), 0U);
}

TEST(QtClock, WorkThatArmsItselfAgainRunsAgain)
{
    test::EventLoop loop;
    int runs = 0;
    Timer timer(loop.clock());
    std::function<void()> again = [&] {
        if (++runs < 50)
            timer.startIn(131us, again);
    };
    timer.startIn(0us, again);
    EXPECT_TRUE(loop.runUntil([&runs] { return runs == 50; }));
}

TEST(QtClock, ADeadlineLongPastRunsSoon)
{
    test::EventLoop loop;
    bool ran = false;
    loop.clock().arm(Instant{}, [&ran] { ran = true; });
    EXPECT_TRUE(loop.runUntil([&ran] { return ran; }));
}

TEST(QtClock, BusyWorkStarvesNoDescriptor)
{
    for (const bool always : {false, true}) {
        test::EventLoop loop;
        int ends[2] = {-1, -1};
        ASSERT_EQ(::pipe(ends), 0);
        bool readable = false;
        QSocketNotifier notifier(ends[0], QSocketNotifier::Read);
        QObject::connect(&notifier, &QSocketNotifier::activated, &notifier, [&] {
            readable = true;
            notifier.setEnabled(false);
        });
        ASSERT_EQ(::write(ends[1], "x", 1), 1);
        Timer timer(loop.clock());
        std::function<void()> again = [&] {
            if (!readable)
                timer.start(always ? Instant{} : loop.clock().now(), again);
        };
        again();
        EXPECT_TRUE(loop.runUntil([&readable] { return readable; })) << always;
        ::close(ends[0]);
        ::close(ends[1]);
    }
}

TEST(QtClock, KnowsUnixTime)
{
    test::EventLoop loop;
    const auto unixTime = loop.clock().now().time_since_epoch() + loop.clock().unixOffset();
    EXPECT_GT(unixTime, std::chrono::hours(24 * 365 * 50));
}

namespace {

/// A pair of clocks that a test moves.
struct Computer {
    Duration awake = 1h;
    Duration asleep{};
    Duration heldUp{}; ///< the next look at the second clock takes this long
    [[nodiscard]] KernelClocks clocks()
    {
        return {[this] { return awake; },
            [this] {
                const Duration seen = awake + asleep;
                awake += std::exchange(heldUp, {});
                return seen;
            }};
    }
};

} // namespace

TEST(QtClock, TellsHowLongTheComputerHasSleptByTwoClocksOfTheKernel)
{
    test::EventLoop loop;
    Computer computer;
    const QtClock clock(computer.clocks());
    EXPECT_EQ(clock.slept(), 0s);
    computer.awake += 10s;
    EXPECT_EQ(clock.slept(), 0s) << "time in which it was awake";
    computer.asleep = 90s;
    EXPECT_EQ(clock.slept(), 90s);
}

TEST(QtClock, KnowsOfATimeWhetherItWasBeforeTheComputerSlept)
{
    test::EventLoop loop;
    Computer computer;
    const Instant before = loop.clock().now();
    QtClock clock(computer.clocks());
    computer.asleep = 90s;
    const SleepLog sleeps = clock.sleeps();
    EXPECT_EQ(sleeps.sleptAt(before), 0s);
    EXPECT_EQ(sleeps.sleptAt(clock.now()), 90s);
}

TEST(QtClock, AProgramHeldUpBetweenTheTwoClocksDoesNotTakeThatForSleep)
{
    test::EventLoop loop;
    Computer computer;
    const QtClock clock(computer.clocks());
    computer.heldUp = 300ms;
    EXPECT_EQ(clock.slept(), 0s);
}

TEST(QtClock, OfALookThatTakesItsTimeTheMiddleCounts)
{
    test::EventLoop loop;
    Duration now = 1h;
    Duration slept{};
    Duration look{};
    const QtClock clock(KernelClocks{[&] { return now; },
        [&] {
            now += look / 2; // as long before it was read as after
            const Duration seen = now + slept;
            now += look / 2;
            return seen;
        }});
    look = 1ms;
    slept = 90s;
    EXPECT_EQ(clock.slept(), 90s);
}

TEST(QtClock, TheKernelsOwnClocksDoNotDriftWhileItIsAwake)
{
    test::EventLoop loop;
    const Duration before = loop.clock().slept();
    bool later = false;
    loop.clock().arm(loop.clock().now() + 20ms, [&later] { later = true; });
    ASSERT_TRUE(loop.runUntil([&later] { return later; }));
    EXPECT_LT(std::chrono::abs(loop.clock().slept() - before), 1ms);
}
