// SPDX-License-Identifier: GPL-3.0-or-later
// Waiting for a link that went: asked every quarter of a second, trusted after one more.
#include "async/virtualclock.h"
#include "model/linkreturn.h"
#include "support/simulatedsession.h"
#include "transport/backends/virtualcan.h"
#include "transport/backends/virtualserial.h"

#include <gtest/gtest.h>

namespace mb {
namespace {

using namespace std::chrono_literals;

struct LinkReturn : testing::Test {
    LinkReturn() { EXPECT_TRUE(link.open()); }
    VirtualClock clock;
    VirtualSerialLine line{clock, VirtualSerialLine::Wiring::HalfDuplex, 1};
    VirtualSerialLink link{*LinkAddress::parse("sim:serial"), line};
};

TEST_F(LinkReturn, ALinkThatIsOpenIsTrustedAfterAQuarterOfASecond)
{
    const Instant before = clock.now();
    ASSERT_TRUE(test::run(clock, linkReturn(link, clock, 10s)));
    EXPECT_EQ(clock.now() - before, 250ms);
}

TEST_F(LinkReturn, ALinkThatSomebodyClosedIsNotWaitedFor)
{
    link.close();
    const Instant before = clock.now();
    const auto back = test::run(clock, linkReturn(link, clock, 10s));
    ASSERT_FALSE(back);
    EXPECT_EQ(back.error().fault, Fault::LinkLost);
    EXPECT_EQ(clock.now() - before, 250ms);
}

TEST_F(LinkReturn, ALineWhoseCableWasPulledIsOpenedAndTrustedAfterAnotherQuarter)
{
    line.pull(link);
    ASSERT_EQ(link.state(), LinkState::Lost);
    const Instant before = clock.now();
    ASSERT_TRUE(test::run(clock, linkReturn(link, clock, 10s)));
    EXPECT_EQ(link.state(), LinkState::Open);
    EXPECT_EQ(clock.now() - before, 500ms);
}

/// Its errors would only go on.
TEST(LinkReturnOfABus, OneThatIsOffIsLeftToWhoeverMendsIt)
{
    VirtualClock clock;
    VirtualCanBus bus{clock, 1'000'000, 1};
    VirtualCanLink link{*LinkAddress::parse("sim:can"), bus};
    ASSERT_TRUE(link.open());
    bus.forceBusOff(link);
    const Instant before = clock.now();
    const auto back = test::run(clock, linkReturn(link, clock, 10s));
    ASSERT_FALSE(back);
    EXPECT_EQ(back.error().fault, Fault::LinkLost);
    EXPECT_EQ(link.state(), LinkState::Lost);
    EXPECT_EQ(clock.now() - before, 250ms);
}

} // namespace
} // namespace mb
