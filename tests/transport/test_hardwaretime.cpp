// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/backends/hardwaretime.h"

#include <gtest/gtest.h>

using namespace mb;
using namespace std::chrono_literals;

TEST(HardwareTime, KeepsTheDistancesOfTheAdapterWhateverTheDelayOfTheKernel)
{
    HardwareTime time;
    const Instant start(1000s);
    const Instant first = time.align(5ms, start + 100us);
    EXPECT_EQ(first, start + 100us);
    EXPECT_EQ(time.align(6ms, start + 1ms + 20us), start + 1ms + 20us);
    const Instant late = time.align(7ms, start + 2ms + 900us);
    EXPECT_GE(late, start + 2ms + 20us);
    EXPECT_LE(late, start + 2ms + 21us);
}

TEST(HardwareTime, IsNeverLaterThanTheKernelsStamp)
{
    HardwareTime time;
    const Instant start(1000s);
    for (int i = 0; i < 1000; ++i) {
        const Instant arrived = start + i * 1ms + (i * 37 % 500) * 1us;
        EXPECT_LE(time.align(i * 1ms, arrived), arrived);
    }
}

TEST(HardwareTime, FollowsAClockThatIsSlowBy50PartsPerMillion)
{
    HardwareTime time;
    const Instant start(1000s);
    Duration worst{};
    for (int i = 0; i < 10'000; ++i) {
        const Instant arrived = start + i * 10ms;
        const Duration hardware = i * 10ms - i * 500ns;
        worst = std::max(worst, arrived - time.align(hardware, arrived));
    }
    EXPECT_LE(worst, 1us);
}

TEST(HardwareTime, BeginsAnewWhenTheAdapterDoes)
{
    HardwareTime time;
    const Instant start(1000s);
    EXPECT_EQ(time.align(100s, start), start);
    EXPECT_EQ(time.align(1ms, start + 1s), start + 1s);
}
