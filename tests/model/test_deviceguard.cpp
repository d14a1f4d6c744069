// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/setpointstream.h"
#include "support/fakeguard.h"
#include "support/freezingclock.h"
#include "support/loosemotor.h"

#include <algorithm>

namespace mb {
namespace {

using namespace std::chrono_literals;
using test::FreezingClock;
using End = SetPointStream::End;
using Watch = GuardWatch::State;

const std::string driveFrame = "00000100#01";
const std::string stopFrame = "00000100#00";

/// A motor without watchdog, the stream that drives it, and a guardian that does what the test says.
class Guarded : public testing::Test {
protected:
    explicit Guarded(Outlet outlet = {Outlet::Form::CanSocket, 7})
        : link(clock, outlet)
    {
        EXPECT_TRUE(link.open());
        motor.guard().setSource(&guard);
    }
    [[nodiscard]] static SetPoint duty(double target = 0.3)
    {
        SetPoint setPoint;
        setPoint.mode = Mode::Duty;
        setPoint.target = target;
        return setPoint;
    }
    [[nodiscard]] auto count(const std::string &frame) const
    {
        return std::count(link.sent.begin(), link.sent.end(), frame);
    }
    void drive()
    {
        ASSERT_TRUE(stream.start(duty(), 10s));
        clock.advance(90ms);
        ASSERT_GT(count(driveFrame), 3);
    }
    void expectEnded(End end)
    {
        EXPECT_EQ(stream.end(), end) << toString(stream.end());
        ASSERT_FALSE(link.sent.empty());
        EXPECT_EQ(link.sent.back(), stopFrame);
        const auto driven = count(driveFrame);
        clock.advance(15s);
        EXPECT_EQ(count(driveFrame), driven) << "it never starts again by itself";
        EXPECT_EQ(stream.end(), end) << "nothing that comes later ends it once more";
    }

    FreezingClock clock;
    test::FakeGuard guard;
    test::LoggedLink link;
    test::LooseMotor motor{link, clock};
    SetPointStream stream{motor, clock};
};

TEST_F(Guarded, NothingIsSentBeforeTheGuardianHasConfirmed)
{
    guard.standsAtOnce = false;
    ASSERT_TRUE(stream.start(duty(), 10s));
    clock.advance(500ms);
    EXPECT_TRUE(link.sent.empty());
    EXPECT_TRUE(stream.update(duty(0.5))) << "the newest target is the one that starts";
    clock.advance(500ms);
    EXPECT_TRUE(link.sent.empty());
    EXPECT_EQ(motor.command(duty()).error().fault, Fault::Unsafe) << "not even past the stream";
    guard.become(Watch::Standing);
    EXPECT_EQ(count(driveFrame), 1);
    EXPECT_EQ(stream.setPoint().target, 0.5);
    clock.advance(100ms);
    EXPECT_EQ(count(driveFrame), 6);
    EXPECT_EQ(guard.lastScript.steps.size(), 1U);
}

TEST_F(Guarded, AGuardianThatDoesNotComeEndsTheAttempt)
{
    guard.standsAtOnce = false;
    ASSERT_TRUE(stream.start(duty(), 10s));
    clock.advance(2001ms);
    EXPECT_EQ(count(driveFrame), 0);
    expectEnded(End::Unguarded);
    EXPECT_EQ(stream.reason(), "no guardian came within two seconds");
    ASSERT_TRUE(stream.start(duty(), 10s));
    clock.advance(1999ms);
    EXPECT_TRUE(stream.isRunning());
    clock.advance(1ms);
    EXPECT_FALSE(stream.isRunning());
}

TEST_F(Guarded, StoppingWhileTheGuardianIsAwaitedDrivesNothingLater)
{
    guard.standsAtOnce = false;
    ASSERT_TRUE(stream.start(duty(), 10s));
    stream.stop();
    guard.become(Watch::Standing);
    EXPECT_EQ(count(driveFrame), 0);
    expectEnded(End::Stopped);
}

TEST_F(Guarded, ALeaseThatExpiresWhileTheGuardianIsAwaitedDrivesNothingLater)
{
    guard.standsAtOnce = false;
    ASSERT_TRUE(stream.start(duty(), 250ms));
    clock.advance(300ms);
    guard.become(Watch::Standing);
    EXPECT_EQ(count(driveFrame), 0);
    expectEnded(End::LeaseExpired);
}

TEST_F(Guarded, AGuardianThatCannotBeStartedRefusesTheMotion)
{
    guard.refusal = "motorbench-guardian is missing";
    const auto started = stream.start(duty(), 10s);
    ASSERT_FALSE(started);
    EXPECT_EQ(started.error(), (Error{Fault::Unsafe, say("motorbench-guardian is missing")}));
    clock.advance(1s);
    EXPECT_TRUE(link.sent.empty());
    EXPECT_FALSE(stream.isRunning());
}

TEST_F(Guarded, AProgramWithoutGuardianMayNotMoveIt)
{
    motor.guard().setSource(nullptr);
    EXPECT_EQ(motor.mayMove().error().fault, Fault::Unsafe);
    EXPECT_FALSE(stream.start(duty(), 10s));
    EXPECT_FALSE(motor.command(duty()));
    EXPECT_TRUE(link.sent.empty());
    motor.stop();
    EXPECT_EQ(count(stopFrame), 1) << "stopping is always allowed";
}

TEST_F(Guarded, ADeviceWithoutAStopScriptIsNotDriven)
{
    motor.script = {};
    const auto started = stream.start(duty(), 10s);
    ASSERT_FALSE(started);
    EXPECT_EQ(started.error().fault, Fault::Unsupported);
    EXPECT_TRUE(link.sent.empty());
}

TEST_F(Guarded, IsRenewedTenTimesASecondWhileItRuns)
{
    drive();
    guard.renewals = 0;
    clock.advance(9s);
    EXPECT_EQ(guard.renewals, 90);
}

TEST_F(Guarded, TheGuardianGoesOnlyWhenTheStopWasSeen)
{
    drive();
    stream.stop();
    guard.renewals = 0;
    clock.advance(1s);
    EXPECT_TRUE(guard.isWatching());
    EXPECT_GE(guard.renewals, 9) << "and is not made to act meanwhile";
    motor.seenStopped = true;
    clock.advance(20ms);
    EXPECT_FALSE(guard.isWatching());
    EXPECT_EQ(guard.released, 1);
    EXPECT_EQ(guard.abandoned, 0);
    const int renewals = guard.renewals;
    clock.advance(1s);
    EXPECT_EQ(guard.renewals, renewals);
}

TEST_F(Guarded, AGuardianThatStillStandsServesTheNextMotion)
{
    drive();
    stream.stop();
    clock.advance(50ms);
    drive();
    EXPECT_EQ(guard.calls, 1);
    motor.seenStopped = true;
    clock.advance(100ms);
    EXPECT_TRUE(guard.isWatching()) << "the earlier stop does not dismiss it";
}

TEST_F(Guarded, AGuardianThatDiesOrActsEndsTheMotion)
{
    for (const Watch state : {Watch::Gone, Watch::Acted}) {
        drive();
        guard.become(state, "the guardian ended unexpectedly");
        EXPECT_TRUE(motor.guard().hasFailed());
        EXPECT_FALSE(motor.guard().stands());
        expectEnded(End::Unguarded);
        EXPECT_EQ(stream.reason(), "the guardian ended unexpectedly");
        EXPECT_FALSE(stream.update(duty(0.5)));
    }
}

TEST_F(Guarded, APromiseHoldsForFourHundredMillisecondsAfterItWasRenewed)
{
    ASSERT_TRUE(motor.guard().call());
    EXPECT_TRUE(motor.guard().stands());
    clock.freeze(400ms - 1ns);
    EXPECT_TRUE(motor.guard().stands());
    EXPECT_FALSE(motor.guard().hasFailed());
    clock.freeze(1ns);
    EXPECT_FALSE(motor.guard().stands());
    EXPECT_TRUE(motor.guard().hasFailed());
    clock.advance(1ms); // renewed too late: that mends nothing
    EXPECT_FALSE(motor.guard().stands());
    EXPECT_TRUE(motor.guard().hasFailed());
    EXPECT_EQ(
        motor.guard().reason(), "this program was held up for so long that the guardian may have stopped the motor");
    ASSERT_TRUE(motor.guard().call());
    EXPECT_EQ(guard.calls, 2);
    EXPECT_TRUE(motor.guard().stands()) << "another one";
}

TEST_F(Guarded, WithoutAGuardianNothingStandsAndNothingHasFailed)
{
    EXPECT_FALSE(motor.guard().stands());
    EXPECT_FALSE(motor.guard().hasFailed());
    EXPECT_EQ(motor.guard().reason(), "the guardian does not stand by yet");
    motor.seenStopped = true;
    motor.guard().leave();
    motor.guard().dismiss();
    clock.advance(1s);
    EXPECT_EQ(guard.released, 0);
    EXPECT_EQ(guard.calls, 0);
}

TEST_F(Guarded, WhatIsLeftWhileItIsLookedAtIsReleasedOnce)
{
    drive();
    stream.stop();
    motor.seenStopped = true;
    motor.guard().leave();
    EXPECT_EQ(guard.released, 1);
    clock.advance(1s);
    EXPECT_EQ(guard.released, 1);
}

TEST_F(Guarded, AMotionThatIsRefusedOnceTheGuardianIsThereHasEnded)
{
    guard.standsAtOnce = false;
    ASSERT_TRUE(stream.start(duty(), 10s));
    motor.gate().setBusy(say("its firmware is written"));
    guard.become(Watch::Standing);
    EXPECT_EQ(stream.end(), End::Refused);
    motor.gate().setBusy({});
    clock.advance(5s);
    EXPECT_EQ(count(driveFrame), 0);
}

TEST_F(Guarded, ADismissedGuardianGoesWithinTenMillisecondsOnceTheMotorStands)
{
    drive();
    stream.stop();
    clock.advance(99ms);
    motor.seenStopped = true;
    EXPECT_TRUE(guard.isWatching());
    clock.advance(1ms);
    EXPECT_EQ(guard.released, 1);
    EXPECT_FALSE(guard.isWatching());
}

TEST_F(Guarded, ANewGuardianIsCalledForTheNextMotion)
{
    drive();
    guard.become(Watch::Gone, "the guardian ended unexpectedly");
    drive();
    EXPECT_EQ(guard.calls, 2);
    EXPECT_TRUE(stream.isRunning());
}

TEST_F(Guarded, AProgramThatWasFrozenNeverDrivesAfterTheGuardianMayHaveActed)
{
    for (const Duration frozen : {410ms, 500ms, 3000ms}) {
        drive();
        const auto driven = count(driveFrame);
        clock.freeze(frozen);
        EXPECT_FALSE(motor.guard().stands());
        EXPECT_FALSE(motor.command(duty())) << "before any timer had its turn";
        clock.advance(1ms);
        EXPECT_EQ(count(driveFrame), driven) << "not one frame, though its turn came before the guardian's message";
        expectEnded(End::Unguarded);
    }
}

TEST_F(Guarded, AShortStallIsSurvived)
{
    drive();
    clock.freeze(200ms);
    clock.advance(100ms);
    EXPECT_TRUE(stream.isRunning());
}

TEST_F(Guarded, APromiseThatComesAfterAFreezeIsNotTrusted)
{
    guard.standsAtOnce = false;
    ASSERT_TRUE(stream.start(duty(), 10s));
    clock.freeze(600ms);
    guard.become(Watch::Standing);
    clock.advance(100ms);
    EXPECT_EQ(count(driveFrame), 0);
    EXPECT_EQ(stream.end(), End::Unguarded);
}

TEST_F(Guarded, ALostLinkLeavesTheMotorToTheGuardian)
{
    drive();
    link.lose({Fault::LinkLost, say("bus-off")});
    EXPECT_EQ(stream.end(), End::LinkLost);
    EXPECT_EQ(guard.abandoned, 1);
    EXPECT_FALSE(guard.isWatching());
}

TEST_F(Guarded, AGuardianGoesAlsoWhereTheNextMotionWasRefusedWhileItsStopWasLookedFor)
{
    for (const bool isStoppedAgain : {false, true}) {
        guard.released = 0;
        motor.seenStopped = false;
        drive();
        stream.stop();
        motor.refuses = true;
        EXPECT_FALSE(stream.start(duty(), 10s));
        motor.refuses = false;
        if (isStoppedAgain)
            stream.stop();
        EXPECT_TRUE(guard.isWatching()) << "the motor may turn";
        motor.seenStopped = true;
        clock.advance(20ms);
        EXPECT_FALSE(guard.isWatching());
        EXPECT_EQ(guard.released, 1);
    }
}

TEST_F(Guarded, AStopOfAMotorThatNobodyDrivesAnyMoreDismissesItsGuardian)
{
    ASSERT_TRUE(motor.guard().call());
    stream.stop();
    motor.seenStopped = true;
    clock.advance(20ms);
    EXPECT_FALSE(guard.isWatching());
}

TEST_F(Guarded, AGuardianOfAFormerOpeningServesNoMotion)
{
    ASSERT_TRUE(motor.guard().call());
    link.lose({Fault::LinkLost, say("it came out")});
    EXPECT_FALSE(guard.isWatching());
    EXPECT_EQ(guard.abandoned, 1);
    ASSERT_TRUE(link.open());
    drive();
    EXPECT_EQ(guard.calls, 2);
}

TEST(GuardedEnd, AStreamThatEndsWithItsProgramLeavesAnUnconfirmedStopToTheGuardian)
{
    for (const bool seen : {false, true}) {
        FreezingClock clock;
        test::FakeGuard guard;
        test::LoggedLink link(clock, {Outlet::Form::CanSocket, 7});
        ASSERT_TRUE(link.open());
        {
            test::LooseMotor motor(link, clock);
            motor.guard().setSource(&guard);
            SetPointStream stream(motor, clock);
            SetPoint setPoint;
            setPoint.mode = Mode::Duty;
            ASSERT_TRUE(stream.start(setPoint, 10s));
            motor.seenStopped = seen;
            stream.stop();
        }
        EXPECT_EQ(link.sent.back(), stopFrame);
        EXPECT_EQ(guard.released, seen ? 1 : 0);
        EXPECT_EQ(guard.abandoned, seen ? 0 : 1);
    }
}

class OnADriver : public Guarded {
protected:
    OnADriver()
        : Guarded(Outlet{})
    {
    }
};

TEST_F(OnADriver, AClosedLinkIsJudgedOnceItIsOpen)
{
    EXPECT_FALSE(motor.guard().possible());
    link.close();
    EXPECT_TRUE(motor.guard().possible());
}

TEST_F(OnADriver, ALinkThatNobodyElseCanUseDrivesNoMotorWithoutWatchdog)
{
    const auto allowed = motor.mayMove();
    ASSERT_FALSE(allowed);
    EXPECT_EQ(allowed.error().fault, Fault::Unsafe);
    EXPECT_FALSE(stream.start(duty(), 10s));
    EXPECT_EQ(guard.calls, 0);
    EXPECT_TRUE(link.sent.empty());
}

class Inside : public Guarded {
protected:
    Inside()
        : Guarded(Outlet{Outlet::Form::InProcess, -1})
    {
    }
};

TEST_F(Inside, AMotorThatEndsWithTheProgramNeedsNoGuardian)
{
    drive();
    EXPECT_EQ(guard.calls, 0);
    clock.freeze(200ms);
    clock.advance(30ms);
    EXPECT_TRUE(stream.isRunning());
}

TEST(GuardedFamilies, AWatchdogNeedsNoGuardian)
{
    FreezingClock clock;
    test::LoggedLink link(clock, {Outlet::Form::CanSocket, 7});
    ASSERT_TRUE(link.open());
    static constexpr Family watched = [] {
        Family family = test::looseFamily;
        family.capabilities.watchdog = true;
        return family;
    }();
    test::LooseMotor motor(link, clock, watched);
    EXPECT_TRUE(motor.mayMove());
    SetPoint setPoint;
    setPoint.mode = Mode::Duty;
    EXPECT_TRUE(motor.command(setPoint));
}

} // namespace
} // namespace mb
