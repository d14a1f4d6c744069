// SPDX-License-Identifier: GPL-3.0-or-later
// Who has armed a station, and until when.
#include "app/engine/stationpermit.h"
#include "model/family.h"
#include "model/registry.h"
#include "support/freezingclock.h"
#include "transport/backends/virtualcan.h"

#include <gtest/gtest.h>

namespace mb {
namespace {

using namespace std::chrono_literals;

MayTurn mayTurn(const StationPermit &permit)
{
    ServiceView view;
    permit.describe(view);
    return view.mayTurn;
}

TEST(StationPermit, IsOverFiveMinutesAfterTheLastUnit)
{
    test::FreezingClock clock;
    StationPermit permit(clock);
    permit.arm(true);
    clock.advance(4min);
    permit.setServed(true);
    clock.advance(20min);
    EXPECT_EQ(mayTurn(permit), MayTurn::Every) << "a unit is there";
    permit.setServed(false);
    clock.advance(4min);
    EXPECT_EQ(mayTurn(permit), MayTurn::Every);
    clock.advance(1min);
    EXPECT_EQ(mayTurn(permit), MayTurn::Nothing);
}

TEST(StationPermit, IsOverWhenTheComputerHasSlept)
{
    test::FreezingClock clock;
    StationPermit permit(clock);
    permit.arm(true);
    clock.suspend(5ms); // two clocks are not read at one instant
    clock.advance(1s);
    EXPECT_EQ(mayTurn(permit), MayTurn::Every);
    clock.suspend(2h);
    clock.advance(1s);
    EXPECT_EQ(mayTurn(permit), MayTurn::Nothing);
    permit.arm(true);
    clock.advance(1s);
    EXPECT_EQ(mayTurn(permit), MayTurn::Every);
}

TEST(StationPermit, AUnitThatComesAfterASleepDoesNotLengthenIt)
{
    test::FreezingClock clock;
    StationPermit permit(clock);
    permit.arm(true);
    clock.suspend(2h);
    permit.setServed(true);
    EXPECT_EQ(mayTurn(permit), MayTurn::Nothing);
}

TEST(StationPermit, LetsNothingTurnAfterASleepInTheLastSecondOfTheAnnouncement)
{
    test::FreezingClock clock;
    VirtualCanBus bus(clock, 1'000'000, 1);
    VirtualCanLink link(*LinkAddress::parse("sim:can"), bus);
    ASSERT_TRUE(link.open());
    Identity identity;
    identity.family = "dmc60c";
    identity.address = 5;
    const auto device = findFamily(families(), identity.family)->open(link, clock, identity);
    StationPermit permit(clock);
    NoProgress progress;
    permit.arm(true);
    auto waiting = permit.beforeMotion(*device, {}, progress);
    waiting.start();
    clock.advance(2500ms);
    clock.suspend(2h);
    clock.advance(1s);
    EXPECT_FALSE(waiting.isFinished());
    EXPECT_EQ(mayTurn(permit), MayTurn::Nothing);
}

} // namespace
} // namespace mb
