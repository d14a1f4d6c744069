// SPDX-License-Identifier: GPL-3.0-or-later
// Orders to motors that have to wait: the newest goes, and an axis that is switched off does not wait for the others.
#include "quadquad2drvboard.h"

#include "async/scope.h"
#include "async/sleep.h"
#include "families/quadquad2drv/codec.h"
#include "families/quadquad2drv/packetport.h"
#include "transport/spilink.h"

namespace mb::quadquad2drv {
namespace {

/// The wire is taken for so long.
Task<void> occupy(SpiLink &link, Clock &clock, Duration time)
{
    const Turns::Turn turn = co_await link.turns().take();
    co_await Sleep(clock, time);
    co_return {};
}

SetPoint duty(int axis, double target)
{
    SetPoint setPoint;
    setPoint.axis = axis;
    setPoint.mode = Mode::Duty;
    setPoint.target = target;
    return setPoint;
}

struct QuadQuad2DrvOrders : testing::Test {
    void SetUp() override
    {
        bench.renew();
        ASSERT_TRUE(bench.stream().start(duty(1, 0.1), 1s));
        for (int axis = 2; axis <= 4; ++axis)
            ASSERT_TRUE(bench.stream().update(duty(axis, 0.1)));
        bench.clock.advance(1s);
        m_scope.spawn<void>(occupy(static_cast<SpiLink &>(*bench.link), bench.clock, 250ms));
        bench.clock.advance(240ms);
        bench.sent.clear();
    }
    [[nodiscard]] std::size_t sentBefore(const Bytes &packet) const
    {
        std::size_t orders = 0;
        for (const Bytes &one : bench.sent) {
            if (one == packet)
                return orders;
            orders += one[2] == static_cast<std::uint8_t>(PacketId::SetPower) ? 1U : 0U;
        }
        return 1000;
    }
    Board bench{"quadquad2drv:0"};

private:
    Scope m_scope{bench.clock};
};

TEST_F(QuadQuad2DrvOrders, AnAxisThatIsSwitchedOffDoesNotWaitForTheTargetsOfTheOthers)
{
    SetPoint off;
    off.axis = 2;
    off.mode = Mode::Off;
    ASSERT_TRUE(bench.stream().update(off));
    EXPECT_TRUE(bench.device->liveness().axes[1].moving) << "until the board has taken it";
    bench.clock.advance(100ms);
    EXPECT_LE(sentBefore(setControlMode(2, ControlMode::Off)), 1U) << "the one that was on its way";
    bench.clock.advance(3s);
    EXPECT_FALSE(bench.device->liveness().axes[1].moving);
    EXPECT_EQ(bench.device->liveness().axes[1].mode, Mode::Off);
    EXPECT_TRUE(bench.device->liveness().axes[0].moving) << "the others go on";
}

TEST_F(QuadQuad2DrvOrders, ANewerTargetTakesThePlaceOfTheOneThatWaitsThoughOtherAxesWereToldSince)
{
    ASSERT_TRUE(bench.stream().update(duty(2, 0.3)));
    bench.clock.advance(100ms);
    EXPECT_LE(sentBefore(setPower(2, 2457)), 4U) << "one of each axis, not all since the wire was taken";
}

TEST_F(QuadQuad2DrvOrders, AnAxisThatIsSwitchedOffAndOnAgainAtOnceTakesItsModeAnew)
{
    SetPoint off;
    off.axis = 2;
    off.mode = Mode::Off;
    ASSERT_TRUE(bench.stream().update(off));
    ASSERT_TRUE(bench.stream().update(duty(2, 0.3)));
    bench.clock.advance(500ms);
    EXPECT_TRUE(bench.hasSent(setControlMode(2, ControlMode::Power)));
    EXPECT_TRUE(bench.hasSent(setPower(2, 2457)));
    EXPECT_EQ(bench.device->liveness().axes[1].mode, Mode::Duty);
}

TEST(QuadQuad2DrvPlace, IsLearnedAnewEachTimeThatAnotherProgramHasHiddenIt)
{
    Board bench("quadquad2drv:0");
    PacketPort other(static_cast<SpiLink &>(*bench.link), bench.clock);
    SetPoint here;
    here.axis = 2;
    here.mode = Mode::Position;
    for (int time = 1; time <= 2; ++time) {
        ASSERT_TRUE(run(bench.clock, other.request(setDataMask(0x02, 0x06))));
        bench.clock.advance(500ms);
        EXPECT_FALSE(bench.stream().start(here, 1s)) << time;
        bench.clock.advance(500ms);
        ASSERT_TRUE(bench.stream().start(here, 1s)) << time;
        bench.clock.advance(500ms);
        bench.stream().stop();
        bench.clock.advance(1s);
    }
}

} // namespace
} // namespace mb::quadquad2drv
