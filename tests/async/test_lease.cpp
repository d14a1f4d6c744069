// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/lease.h"
#include "async/virtualclock.h"

#include <gtest/gtest.h>

#include <memory>

using namespace mb;
using namespace std::chrono_literals;

namespace {

/// As somebody has it who was heard of just now.
void holdFromNow(Lease &lease)
{
    lease.renew();
    lease.hold(250ms);
}

} // namespace

TEST(Lease, EndsOnceAfterItsTermWithoutRenewal)
{
    VirtualClock clock;
    int ends = 0;
    Lease lease(clock, [&ends] { ++ends; });
    holdFromNow(lease);
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
    Lease lease(clock, [&ends] { ++ends; });
    holdFromNow(lease);
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
        Lease lease(clock, [&ends] { ++ends; });
        holdFromNow(lease);
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
    lease = std::make_unique<Lease>(clock, [&lease, &ends] {
        lease.reset();
        ++ends;
    });
    holdFromNow(*lease);
    clock.advance(250ms);
    EXPECT_EQ(ends, 1);
    EXPECT_EQ(lease, nullptr);
}

TEST(Lease, CountsFromTheLastRenewalAlsoOfBeforeItIsHeld)
{
    VirtualClock clock;
    int ends = 0;
    Lease lease(clock, [&ends] { ++ends; });
    EXPECT_TRUE(lease.isOver(250ms)) << "nobody was ever heard of";
    lease.renew();
    clock.advance(200ms);
    EXPECT_FALSE(lease.isOver(250ms));
    lease.hold(250ms);
    clock.advance(49ms);
    EXPECT_EQ(ends, 0);
    clock.advance(1ms);
    EXPECT_EQ(ends, 1);
    EXPECT_TRUE(lease.isOver(250ms));
    lease.renew();
    lease.hold(250ms);
    lease.release();
    clock.advance(1s);
    EXPECT_EQ(ends, 1) << "nothing is held";
}
