// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/virtualclock.h"
#include "model/leaserenewal.h"
#include "support/simulatedsession.h"

#include <gtest/gtest.h>

#include <optional>

namespace mb {
namespace {

using namespace std::chrono_literals;

TEST(LeaseRenewal, RenewsAtOnceAndTenTimesASecondUntilItIsGone)
{
    VirtualClock clock;
    int renewals = 0;
    {
        const LeaseRenewal renewal(clock, [&renewals] { ++renewals; });
        EXPECT_EQ(renewals, 1);
        clock.advance(1s);
        EXPECT_EQ(renewals, 11);
    }
    clock.advance(1s);
    EXPECT_EQ(renewals, 11);
    EXPECT_EQ(clock.armed(), 0U);
}

TEST(LeaseRenewal, EndsWhenItIsToldToAlsoFromInside)
{
    VirtualClock clock;
    int renewals = 0;
    std::optional<LeaseRenewal> renewal;
    renewal.emplace(clock, [&] {
        if (++renewals == 3)
            renewal->stop();
    });
    clock.advance(1s);
    EXPECT_EQ(renewals, 3);
    EXPECT_EQ(clock.armed(), 0U);
}

TEST(LeaseRenewal, KeepsAMotorTurningAndNoLongerThanItsTerm)
{
    test::SimulatedSession bench;
    bench.scan();
    Device *device = bench.device(5);
    ASSERT_NE(device, nullptr);
    bench.clock.advance(200ms);
    SetPoint setPoint;
    setPoint.mode = Mode::Duty;
    setPoint.target = 0.2;
    SetPointStream &stream = bench.session.stream(*device);
    ASSERT_TRUE(stream.start(setPoint, LeaseRenewal::term));
    {
        const LeaseRenewal renewal(bench.clock, [&stream] { stream.renew(); });
        bench.clock.advance(5s);
        EXPECT_TRUE(stream.isRunning());
        EXPECT_TRUE(bench.simulator("dmc60c:5")->isOutputOn());
    }
    bench.clock.advance(LeaseRenewal::term + 1ms);
    EXPECT_EQ(stream.end(), SetPointStream::End::LeaseExpired);
    EXPECT_FALSE(bench.simulator("dmc60c:5")->isOutputOn());
}

} // namespace
} // namespace mb
