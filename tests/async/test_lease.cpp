// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/lease.h"
#include "async/virtualclock.h"

#include <gtest/gtest.h>

#include <memory>

using namespace mb;
using namespace std::chrono_literals;

TEST(Lease, EndsOnceAfterItsTermWithoutRenewal)
{
    VirtualClock clock;
    int ends = 0;
    const Lease lease(clock, 250ms, [&ends] { ++ends; });
    clock.advance(249ms);
    EXPECT_EQ(ends, 0);
    clock.advance(1ms);
    EXPECT_EQ(ends, 1);
    clock.advance(10s);
    EXPECT_EQ(ends, 1);
}

TEST(Lease, LivesWhileItIsRenewedInTime)
{
    VirtualClock clock;
    int ends = 0;
    Lease lease(clock, 250ms, [&ends] { ++ends; });
    for (int i = 0; i < 20; ++i) {
        clock.advance(249ms);
        lease.renew();
    }
    EXPECT_EQ(ends, 0);
    clock.advance(250ms);
    EXPECT_EQ(ends, 1);
}

TEST(Lease, DestroyedBeforeItsEndSaysNothing)
{
    VirtualClock clock;
    int ends = 0;
    {
        const Lease lease(clock, 250ms, [&ends] { ++ends; });
    }
    clock.advance(1s);
    EXPECT_EQ(ends, 0);
    EXPECT_EQ(clock.armed(), 0U);
}

TEST(Lease, MayBeDestroyedByItsOwnEnd)
{
    VirtualClock clock;
    int ends = 0;
    std::unique_ptr<Lease> lease;
    lease = std::make_unique<Lease>(clock, 250ms, [&lease, &ends] {
        lease.reset();
        ++ends;
    });
    clock.advance(250ms);
    EXPECT_EQ(ends, 1);
    EXPECT_EQ(lease, nullptr);
}
