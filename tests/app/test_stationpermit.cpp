// SPDX-License-Identifier: GPL-3.0-or-later
// Who has armed a station, and until when.
#include "app/engine/stationpermit.h"
#include "support/freezingclock.h"

#include <gtest/gtest.h>

namespace mb {
namespace {

using namespace std::chrono_literals;

TEST(StationPermit, IsOverFiveMinutesAfterTheLastUnit)
{
    test::FreezingClock clock;
    StationPermit permit(clock);
    permit.arm(true);
    clock.advance(4min);
    permit.restart();
    clock.advance(4min);
    EXPECT_TRUE(permit.isArmed());
    clock.advance(1min);
    EXPECT_FALSE(permit.isArmed());
    EXPECT_FALSE(permit.isPermitted());
}

TEST(StationPermit, IsOverWhenTheComputerHasSlept)
{
    test::FreezingClock clock;
    StationPermit permit(clock);
    permit.arm(true);
    clock.suspend(5ms); // two clocks are not read at one instant
    clock.advance(1s);
    EXPECT_TRUE(permit.isArmed());
    clock.suspend(2h);
    clock.advance(1s);
    EXPECT_FALSE(permit.isArmed());
    EXPECT_FALSE(permit.isPermitted());
    permit.arm(true);
    clock.advance(1s);
    EXPECT_TRUE(permit.isArmed());
}

TEST(StationPermit, AUnitThatComesAfterASleepDoesNotLengthenIt)
{
    test::FreezingClock clock;
    StationPermit permit(clock);
    permit.arm(true);
    clock.suspend(2h);
    permit.restart();
    EXPECT_FALSE(permit.isArmed());
}

} // namespace
} // namespace mb
