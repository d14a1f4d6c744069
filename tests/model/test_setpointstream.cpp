// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/family.h"
#include "model/registry.h"
#include "model/setpointstream.h"
#include "support/freezingclock.h"
#include "transport/backends/virtualcan.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <vector>

namespace mb {
namespace {

using namespace std::chrono_literals;
using StreamEnd = SetPointStream::End;

constexpr std::uint32_t controlOfFive = 0x02060005U;

struct FirstFound final : ScanSink {
    void found(const Identity &identity) override { last = identity; }
    void progress(const Message &, int, int) override { }
    Identity last;
};

/// A simulated controller number 5, the host that drives it, and somebody else on the same bus.
class Stream : public testing::Test {
protected:
    Stream()
    {
        EXPECT_TRUE(host.open() && box.open() && other.open());
        unit = std::move(*family.simulate(box, clock, *SimulatedUnit::parse("dmc60c:5")));
        heard = other.received().add([this](const CanFrame &frame) {
            if (frame.id == controlOfFive)
                control.push_back(frame);
        });
        FirstFound sink;
        auto scan = family.scan(host, clock, sink);
        scan.start();
        clock.advance(1s);
        EXPECT_TRUE(scan.isFinished());
        device = family.open(host, clock, sink.last);
        stream = std::make_unique<SetPointStream>(*device, clock);
        clock.advance(500ms);
        EXPECT_TRUE(device->liveness().heard);
    }
    static SetPoint duty(double target)
    {
        SetPoint setPoint;
        setPoint.mode = Mode::Duty;
        setPoint.target = target;
        return setPoint;
    }
    void drive(Duration lease = 10s)
    {
        ASSERT_TRUE(stream->start(duty(0.3), lease));
        clock.advance(100ms);
        ASSERT_TRUE(unit->isOutputOn());
    }
    [[nodiscard]] static bool isStop(const CanFrame &frame) { return frame.data[0] == 0x0F; }
    /// The stream ended so, its last frame was a stop, and nothing drives it again.
    void expectEnded(StreamEnd end)
    {
        EXPECT_FALSE(stream->isRunning());
        EXPECT_EQ(stream->end(), end) << toString(stream->end());
        EXPECT_FALSE(stream->reason().empty());
        EXPECT_FALSE(stream->update(duty(0.5))) << "it never starts again by itself";
        stream->renew();
        clock.advance(200ms);
        EXPECT_FALSE(unit->isOutputOn());
        const std::size_t sent = control.size();
        clock.advance(2s);
        EXPECT_TRUE(std::all_of(control.begin() + static_cast<std::ptrdiff_t>(sent), control.end(), isStop))
            << "a stop may be repeated, nothing else";
        clock.advance(10s);
        EXPECT_EQ(stream->end(), end) << "nothing that comes later ends it once more";
    }

    const Family &family = *findFamily(families(), "dmc60c");
    test::FreezingClock clock;
    VirtualCanBus bus{clock, 1'000'000, 1};
    LinkAddress address{*LinkAddress::parse("sim:can")};
    VirtualCanLink host{address, bus};
    VirtualCanLink box{address, bus};
    VirtualCanLink other{address, bus};
    std::unique_ptr<Simulator> unit;
    std::vector<CanFrame> control; ///< as the bus saw them
    Subscription heard;
    std::unique_ptr<Device> device;
    std::unique_ptr<SetPointStream> stream;
};

TEST_F(Stream, SendsOneFrameEveryPeriod)
{
    drive();
    control.clear();
    clock.advance(1s);
    const double expected = 1.0 / std::chrono::duration<double>(family.capabilities.commandPeriod).count();
    EXPECT_NEAR(static_cast<double>(control.size()), expected, 1.0);
}

TEST_F(Stream, StopsWhenAskedAtOnce)
{
    drive();
    stream->stop();
    clock.advance(2ms);
    EXPECT_FALSE(unit->isOutputOn());
    ASSERT_FALSE(control.empty());
    EXPECT_TRUE(isStop(control.back()));
    expectEnded(StreamEnd::Stopped);
}

TEST_F(Stream, StopsWhenNobodyRenewsTheLease)
{
    drive(250ms);
    for (int i = 0; i < 10; ++i) {
        stream->renew();
        clock.advance(200ms);
    }
    EXPECT_TRUE(stream->isRunning());
    clock.advance(49ms);
    EXPECT_TRUE(stream->isRunning());
    clock.advance(2ms);
    EXPECT_FALSE(unit->isOutputOn());
    EXPECT_TRUE(isStop(control.back()));
    expectEnded(StreamEnd::LeaseExpired);
}

TEST_F(Stream, AStoryThatBeginsByItselfHasWhatIsLeftOfItsLease)
{
    constexpr auto since = SetPointStream::Since::Renewal;
    const auto starts = [this] { return stream->start(duty(0.3), 1s, {}, since).has_value(); };
    EXPECT_FALSE(starts()) << "nobody was ever heard of";
    stream->renew();
    clock.advance(600ms);
    ASSERT_TRUE(starts());
    clock.advance(399ms);
    EXPECT_TRUE(stream->isRunning());
    clock.advance(1ms);
    EXPECT_EQ(stream->end(), StreamEnd::LeaseExpired);
    clock.advance(500ms);
    control.clear();
    EXPECT_FALSE(starts());
    EXPECT_EQ(stream->end(), StreamEnd::LeaseExpired);
    EXPECT_TRUE(control.empty());
    ASSERT_TRUE(stream->start(duty(0.3), 1s)) << "somebody's order";
    stream->stop();
    clock.advance(900ms);
    EXPECT_TRUE(starts()) << "it counted from there";
}

TEST_F(Stream, StopsWhenAnotherMasterSendsControlFrames)
{
    drive();
    for (int i = 0; i < 20 && stream->isRunning(); ++i) {
        CanFrame foreign = control.back();
        ASSERT_TRUE(other.send(foreign));
        clock.advance(20ms);
    }
    EXPECT_EQ(stream->end(), StreamEnd::ForeignMaster);
    EXPECT_TRUE(isStop(control.back()));
    expectEnded(StreamEnd::ForeignMaster);
    EXPECT_FALSE(stream->start(duty(0.1), 1s).has_value() && device->liveness().foreignMaster);
}

TEST_F(Stream, RefusesToStartWhileAnotherMasterDrives)
{
    drive();
    const CanFrame foreign = control.back();
    stream->stop();
    clock.advance(1s);
    for (int i = 0; i < 10; ++i) {
        ASSERT_TRUE(other.send(foreign));
        clock.advance(20ms);
    }
    const std::size_t before = control.size();
    const auto started = stream->start(duty(0.3), 1s);
    ASSERT_FALSE(started);
    EXPECT_EQ(started.error().fault, Fault::Unsafe);
    clock.advance(5ms);
    EXPECT_EQ(control.size(), before) << "nothing was sent";
}

TEST_F(Stream, EndsWhenTheLinkIsBusOffAndTheDeviceStopsByItself)
{
    drive();
    bus.forceBusOff(host);
    EXPECT_EQ(stream->end(), StreamEnd::LinkLost);
    clock.advance(124ms);
    EXPECT_FALSE(unit->isOutputOn());
    expectEnded(StreamEnd::LinkLost);
    EXPECT_FALSE(stream->start(duty(0.3), 1s));
}

TEST_F(Stream, ASimulatedUnitThatIsCutOffTheBusStopsByItself)
{
    drive();
    box.close();
    clock.advance(1ms);
    EXPECT_FALSE(unit->isOutputOn());
}

TEST_F(Stream, DoesNotGoOnWhenTheLinkIsBack)
{
    drive();
    bus.forceBusOff(host);
    clock.advance(300ms);
    ASSERT_TRUE(host.open());
    const std::size_t before = control.size();
    clock.advance(1s);
    EXPECT_EQ(control.size(), before);
    EXPECT_FALSE(unit->isOutputOn());
}

TEST_F(Stream, StopsWhenTheDeviceIsNotHeardAnyMore)
{
    drive();
    clock.advance(1s);
    unit->setPowered(false);
    clock.advance(500ms);
    EXPECT_EQ(stream->end(), StreamEnd::DeviceSilent);
    expectEnded(StreamEnd::DeviceSilent);
}

TEST_F(Stream, DoesNotDriveADeviceThatCameBackFromAPowerCycle)
{
    drive();
    clock.advance(1s);
    unit->setPowered(false);
    clock.advance(200ms); // as long as a lost supply takes to come back
    unit->setPowered(true);
    clock.advance(3s);
    EXPECT_FALSE(stream->isRunning());
    EXPECT_TRUE(stream->end() == StreamEnd::DeviceRestarted || stream->end() == StreamEnd::DeviceSilent)
        << toString(stream->end());
    expectEnded(stream->end());
}

TEST_F(Stream, KeepsTheOldTargetWhenTheNewOneIsNotLegal)
{
    drive();
    for (const double target :
        {1.5, -2.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
        EXPECT_FALSE(stream->update(duty(target))) << target;
    EXPECT_TRUE(stream->isRunning());
    EXPECT_EQ(stream->setPoint().target, 0.3);
    EXPECT_TRUE(stream->update(duty(-0.2)));
    EXPECT_EQ(stream->setPoint().target, -0.2);
}

TEST_F(Stream, SendsNothingForAnIllegalFirstTarget)
{
    EXPECT_FALSE(stream->start(duty(1.5), 1s));
    clock.advance(100ms);
    EXPECT_TRUE(control.empty());
    EXPECT_FALSE(stream->isRunning());
}

TEST_F(Stream, MakesNoBurstAfterAStallThatTheDeviceOutlasts)
{
    drive();
    clock.advance(7ms);
    clock.freeze(70ms);
    control.clear();
    clock.advance(15ms);
    EXPECT_LE(control.size(), 1U) << "three periods went by";
    clock.advance(200ms);
    for (std::size_t i = 1; i < control.size(); ++i)
        EXPECT_GE(control[i].time - control[i - 1].time, 15ms);
    EXPECT_TRUE(stream->isRunning());
}

TEST_F(Stream, EndsAfterAStallInWhichTheWatchdogOfTheDeviceFired)
{
    for (const auto stall : {146ms, 283ms}) {
        drive();
        clock.advance(7ms);
        clock.freeze(stall);
        control.clear();
        clock.advance(50ms);
        ASSERT_FALSE(control.empty());
        for (const CanFrame &frame : control)
            EXPECT_TRUE(isStop(frame)) << "the motor stood, and nothing may start it again";
        EXPECT_NE(stream->reason().english().find("held up"), std::string::npos) << stream->reason();
        expectEnded(StreamEnd::Late);
    }
}

TEST_F(Stream, ANewTargetOrARenewalThatComesFirstAfterAStallDoesNotStartTheMotorAgain)
{
    drive();
    clock.advance(7ms);
    clock.freeze(146ms);
    control.clear();
    EXPECT_FALSE(stream->update(duty(0.5)));
    clock.advance(5ms);
    for (const CanFrame &frame : control)
        EXPECT_TRUE(isStop(frame));
    expectEnded(StreamEnd::Late);

    drive(120ms);
    clock.freeze(146ms);
    stream->renew();
    expectEnded(StreamEnd::Late);
}

TEST_F(Stream, AStallBetweenTheLookAtTheClockAndTheFrameEndsInAStopAtOnce)
{
    drive();
    Instant thawed{};
    const Subscription leaving = host.traffic().add([&](const Traffic &passed) {
        const bool isOrder = passed.direction == Direction::Sent && passed.can->id == controlOfFive;
        if (!isOrder || thawed != Instant{})
            return;
        clock.freeze(146ms);
        thawed = clock.now();
    });
    clock.advance(172ms); // an order is due within 20 ms
    ASSERT_NE(thawed, Instant{});
    const auto stop = std::ranges::find_if(control, isStop);
    ASSERT_NE(stop, control.end());
    EXPECT_LT(stop->time - thawed, 1ms) << "the motor stood, and what was on its way has started it";
    EXPECT_TRUE(std::all_of(stop, control.end(), isStop));
    expectEnded(StreamEnd::Late);
}

TEST_F(Stream, NothingMovesAgainWhenTheComputerWakesUp)
{
    drive();
    clock.advance(7ms);
    clock.suspend(10s);
    control.clear();
    clock.advance(50ms);
    ASSERT_FALSE(control.empty());
    EXPECT_TRUE(isStop(control.front())) << "not one set-point after the sleep";
    expectEnded(StreamEnd::Slept);
}

TEST_F(Stream, ADeviceWithoutWatchdogIsGivenAQuarterOfASecond)
{
    for (const Family *each : families()) {
        if (!each->capabilities.watchdog) {
            EXPECT_EQ(each->capabilities.commandLimit, 250ms) << each->key;
        }
        EXPECT_GE(each->capabilities.commandLimit, 3 * each->capabilities.commandPeriod) << each->key;
    }
}

TEST_F(Stream, EndsAStallThatIsLongerThanTheLeaseInAStop)
{
    drive(150ms);
    clock.freeze(80ms);
    control.clear();
    clock.advance(50ms);
    ASSERT_FALSE(control.empty());
    EXPECT_TRUE(isStop(control.back()));
    expectEnded(StreamEnd::LeaseExpired);
}

TEST_F(Stream, GlidesFromWhereTheMotorIsNoFasterThanItsRate)
{
    ASSERT_TRUE(stream->start(duty(0.6), 60s, {2.0, 0.0}));
    EXPECT_EQ(stream->setPoint().target, 0.0) << "the first frame is where it is";
    double before = 0.0;
    for (int i = 0; i < 50; ++i) {
        clock.advance(20ms);
        const double now = stream->setPoint().target;
        EXPECT_LE(now - before, 2.0 * 0.020 + 1e-9);
        EXPECT_NEAR(now, std::min(0.6, 2.0 * 0.020 * (i + 1)), 0.041);
        before = now;
    }
    EXPECT_EQ(stream->setPoint().target, 0.6);
    EXPECT_FALSE(stream->isGliding());
}

TEST_F(Stream, TakesANewTargetAlongOnTheWay)
{
    ASSERT_TRUE(stream->start(duty(0.8), 60s, {1.0, 0.0}));
    clock.advance(400ms);
    const double turned = stream->setPoint().target;
    EXPECT_NEAR(turned, 0.4, 0.021);
    ASSERT_TRUE(stream->update(duty(-0.8), {1.0, {}}));
    EXPECT_LE(std::abs(stream->setPoint().target - turned), 0.021);
    clock.advance(200ms);
    EXPECT_NEAR(stream->setPoint().target, turned - 0.2, 0.021);
    clock.advance(10s);
    EXPECT_EQ(stream->setPoint().target, -0.8);
    clock.advance(5s); // a long rest is no reason to jump
    ASSERT_TRUE(stream->update(duty(0.8), {1.0, {}}));
    EXPECT_EQ(stream->setPoint().target, -0.8);
    clock.advance(100ms);
    EXPECT_NEAR(stream->setPoint().target, -0.7, 0.021);
}

TEST_F(Stream, HoldsWhereItIsBeforeItJumps)
{
    ASSERT_TRUE(stream->start(duty(0.3), 60s, {0.0, 0.1}));
    EXPECT_EQ(stream->setPoint().target, 0.1);
    clock.advance(family.capabilities.commandPeriod + 1ms);
    EXPECT_EQ(stream->setPoint().target, 0.3);
    ASSERT_TRUE(stream->update(duty(0.5)));
    EXPECT_EQ(stream->setPoint().target, 0.5) << "what moves already jumps at once without a rate";
}

TEST_F(Stream, EndsAGlideWithTheMotion)
{
    ASSERT_TRUE(stream->start(duty(0.8), 300ms, {1.0, 0.0}));
    clock.advance(1s);
    EXPECT_FALSE(stream->isGliding());
    expectEnded(StreamEnd::LeaseExpired);
}

TEST_F(Stream, AStartWhileItRunsIsANewTargetAndAnIllegalOneChangesNothing)
{
    drive(400ms);
    clock.advance(300ms);
    ASSERT_TRUE(stream->start(duty(0.6), 400ms));
    EXPECT_EQ(stream->setPoint().target, 0.6);
    clock.advance(300ms);
    EXPECT_TRUE(stream->isRunning()) << "it was renewed";
    EXPECT_FALSE(stream->start(duty(7.0), 400ms));
    EXPECT_EQ(stream->setPoint().target, 0.6);
    clock.advance(101ms);
    expectEnded(StreamEnd::LeaseExpired);
}

TEST_F(Stream, IsNotStartedOnceItsUserHasCalledItOff)
{
    bool calledOff = true;
    stream->setCalledOff(&calledOff);
    const auto started = stream->start(duty(0.3), 1s);
    ASSERT_FALSE(started);
    EXPECT_EQ(started.error().fault, Fault::Cancelled);
    EXPECT_EQ(started.error().text(), "the user stopped it");
    EXPECT_FALSE(stream->isRunning());
    SetPoint off;
    off.mode = Mode::Off;
    EXPECT_TRUE(stream->start(off, 1s)) << "a stop is always allowed";
    stream->stop();
    calledOff = false;
    EXPECT_TRUE(stream->start(duty(0.3), 1s));
}

TEST_F(Stream, StopsTheMotorWithItsOwnEnd)
{
    drive();
    stream.reset();
    clock.advance(5ms);
    EXPECT_FALSE(unit->isOutputOn());
    EXPECT_TRUE(isStop(control.back()));
}

} // namespace
} // namespace mb
