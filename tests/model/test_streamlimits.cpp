// SPDX-License-Identifier: GPL-3.0-or-later
// The limits of a set-point stream, each from both sides, and what its glides tell a motor frame by frame.
#include "model/setpointslew.h"
#include "model/setpointstream.h"
#include "support/fakeguard.h"
#include "support/freezingclock.h"
#include "support/loosemotor.h"

namespace mb {
namespace {

using namespace std::chrono_literals;
using End = SetPointStream::End;
using TimedTargets = std::vector<std::pair<double, double>>; ///< ms since the start, target

constexpr Mode streamModes[] = {Mode::Duty, Mode::Velocity};

/// Watched by itself, so that no guardian is needed; a frame every 20 ms, and 70 ms without one are too long.
constexpr Family familyWithAxes(int axes)
{
    Family family = test::looseFamily;
    family.modes = streamModes;
    family.capabilities.watchdog = true;
    family.capabilities.axes = axes;
    family.capabilities.commandLimit = 70ms;
    return family;
}
constexpr Family oneAxisFamily = familyWithAxes(1);
constexpr Family twoAxesFamily = familyWithAxes(2);

/// Keeps what it is told, with times.
class NotingMotor final : public test::MuteDevice {
public:
    NotingMotor(CanLink &link, Clock &clock, const Family &family)
        : MuteDevice(family, link, clock, {})
        , m_begin(clock.now())
    {
    }
    void hear(bool heard)
    {
        Liveness now = liveness();
        now.heard = heard;
        setLiveness(now);
    }
    TimedTargets frames; ///< of axis 1
    TimedTargets others;
    int stops = 0;
    bool isCut = false; ///< its link has gone, and nobody has noticed yet

private:
    Result<void> doCommand(const SetPoint &setPoint) override
    {
        if (isCut)
            return fail(Fault::LinkLost, say("can0 was switched off"));
        const double at = std::chrono::duration<double, std::milli>(clock().now() - m_begin).count();
        (setPoint.axis == 1 ? frames : others).emplace_back(at, setPoint.target);
        return {};
    }
    void doStop() override { ++stops; }
    [[nodiscard]] bool isSeenStopped() const override { return true; }

    Instant m_begin;
};

SetPoint setPointTo(double target, Mode mode = Mode::Duty, int axis = 1)
{
    SetPoint setPoint;
    setPoint.mode = mode;
    setPoint.target = target;
    setPoint.axis = axis;
    return setPoint;
}

class StreamLimits : public testing::Test {
protected:
    explicit StreamLimits(const Family &family = oneAxisFamily)
        : motor(link, clock, family)
    {
        EXPECT_TRUE(link.open());
        told = stream.changed().add([this] { ++changes; });
    }
    /// After `more` it still runs, and ends with 1 ns more.
    void expectLimit(Duration more, void (test::FreezingClock::*pass)(Duration), End end)
    {
        (clock.*pass)(more);
        stream.renew();
        EXPECT_TRUE(stream.isRunning()) << stream.reason();
        (clock.*pass)(1ns);
        stream.renew();
        EXPECT_EQ(stream.end(), end) << toString(stream.end());
    }

    test::FreezingClock clock;
    test::LoggedLink link{clock, {Outlet::Form::CanSocket, 7}};
    NotingMotor motor;
    SetPointStream stream{motor, clock};
    Subscription told;
    int changes = 0;
};

TEST_F(StreamLimits, AFrameMayBeAsLateAsTheDeviceWaitsForIt)
{
    ASSERT_TRUE(stream.start(setPointTo(0.3), 10s));
    expectLimit(70ms, &test::FreezingClock::freeze, End::Late);
    EXPECT_EQ(stream.reason(), "this program was held up for 70 ms, longer than the motor goes without a set-point");
}

TEST_F(StreamLimits, TwentyMillisecondsOfSleepAreTheToleranceOfTwoClocks)
{
    ASSERT_TRUE(stream.start(setPointTo(0.3), 10s));
    expectLimit(20ms, &test::FreezingClock::suspend, End::Slept);
}

TEST_F(StreamLimits, EachFrameForgivesTheSleepBeforeIt)
{
    ASSERT_TRUE(stream.start(setPointTo(0.3), 10s));
    for (int i = 0; i < 10; ++i) {
        clock.suspend(20ms);
        clock.advance(20ms);
    }
    EXPECT_TRUE(stream.isRunning());
}

TEST_F(StreamLimits, ADeviceHasHalfASecondToBeHeard)
{
    motor.hear(false);
    ASSERT_TRUE(stream.start(setPointTo(0.3), 10s));
    expectLimit(500ms, &test::FreezingClock::advance, End::DeviceSilent);
}

TEST_F(StreamLimits, AFrameComesEveryPeriodAndAfterAStallOneNotTwo)
{
    ASSERT_TRUE(stream.start(setPointTo(0.3), 10s));
    clock.advance(50ms);
    clock.freeze(30ms); // until the frame of 60 ms and that of 80 ms are due
    clock.advance(35ms);
    EXPECT_EQ(motor.frames, (TimedTargets{{0, 0.3}, {20, 0.3}, {40, 0.3}, {80, 0.3}, {100, 0.3}}));
}

TEST_F(StreamLimits, ANewTargetGoesOutAtOnceBetweenTheFramesOfThePeriod)
{
    ASSERT_TRUE(stream.start(setPointTo(0.3), 10s));
    clock.advance(30ms);
    ASSERT_TRUE(stream.update(setPointTo(0.5)));
    clock.advance(15ms);
    ASSERT_TRUE(stream.follow(setPointTo(0.6)));
    clock.advance(20ms);
    EXPECT_EQ(motor.frames, (TimedTargets{{0, 0.3}, {20, 0.3}, {30, 0.5}, {40, 0.5}, {45, 0.6}, {60, 0.6}}));
}

TEST_F(StreamLimits, OnlyAnUpdateRenewsTheLease)
{
    ASSERT_TRUE(stream.start(setPointTo(0.3), 100ms));
    clock.advance(60ms);
    ASSERT_TRUE(stream.update(setPointTo(0.4)));
    clock.advance(60ms);
    ASSERT_TRUE(stream.follow(setPointTo(0.5)));
    clock.advance(39ms);
    EXPECT_TRUE(stream.isRunning());
    clock.advance(1ms);
    EXPECT_EQ(stream.end(), End::LeaseExpired);
}

TEST_F(StreamLimits, ListenersHearOfTheStartOfTargetsOfGlidesAndOfTheEnd)
{
    ASSERT_TRUE(stream.start(setPointTo(0.3), 10s));
    EXPECT_EQ(changes, 1);
    clock.advance(1s);
    EXPECT_EQ(changes, 1) << "a set-point that stays is no news";
    ASSERT_TRUE(stream.update(setPointTo(0.5), {1.0, {}}));
    EXPECT_EQ(changes, 2);
    clock.advance(1s);
    EXPECT_EQ(changes, 2 + 10) << "200 ms of way";
    stream.stop();
    EXPECT_EQ(changes, 13);
    stream.stop();
    EXPECT_EQ(changes, 13) << "it has ended already";
}

TEST_F(StreamLimits, AStopIsSentWhetherItRunsOrNotButNoneByAnEndThatEndsNothing)
{
    {
        SetPointStream unused(motor, clock);
    }
    EXPECT_EQ(motor.stops, 0);
    stream.stop();
    EXPECT_EQ(motor.stops, 1);
    ASSERT_TRUE(stream.start(setPointTo(0.3), 10s));
    stream.stop();
    EXPECT_EQ(motor.stops, 2);
    EXPECT_EQ(stream.end(), End::Stopped);
    {
        SetPointStream running(motor, clock);
        ASSERT_TRUE(running.start(setPointTo(0.3), 10s));
    }
    EXPECT_EQ(motor.stops, 3);
}

TEST_F(StreamLimits, AMotionThatIsRefusedWhileItRunsEndsInAStop)
{
    for (const bool update : {false, true}) {
        ASSERT_TRUE(stream.start(setPointTo(0.3), 10s));
        const int before = motor.stops;
        motor.gate().setBusy(say("its firmware is written"));
        if (update) {
            EXPECT_FALSE(stream.update(setPointTo(0.4)));
        } else {
            clock.advance(20ms);
        }
        EXPECT_EQ(stream.end(), End::Refused);
        EXPECT_FALSE(stream.isRunning());
        EXPECT_EQ(motor.stops, before + 1);
        motor.gate().setBusy({});
        clock.advance(15s);
        EXPECT_EQ(stream.end(), End::Refused);
    }
}

TEST_F(StreamLimits, ALinkThatIsFoundGoneByASetPointIsALostLinkNoRefusal)
{
    for (const bool update : {false, true}) {
        motor.isCut = false;
        ASSERT_TRUE(stream.start(setPointTo(0.3), 10s));
        const int before = motor.stops;
        motor.isCut = true;
        if (update) {
            EXPECT_FALSE(stream.update(setPointTo(0.4)));
        } else {
            clock.advance(20ms);
        }
        EXPECT_EQ(stream.end(), End::LinkLost);
        EXPECT_EQ(stream.reason(), "can0 was switched off");
        EXPECT_EQ(motor.stops, before + 1);
    }
}

TEST_F(StreamLimits, AStartAgainForgetsHowItEndedAndWhatItWasToldBefore)
{
    ASSERT_TRUE(stream.start(setPointTo(0.8), 10s, {1.0, 0.0}));
    clock.advance(100ms);
    stream.stop();
    EXPECT_FALSE(stream.isGliding());
    clock.advance(1s);
    motor.frames.clear();
    ASSERT_TRUE(stream.start(setPointTo(0.8), 10s, {1.0, 0.2}));
    EXPECT_EQ(stream.end(), End::None);
    EXPECT_TRUE(stream.reason().empty());
    EXPECT_EQ(stream.setPoints().size(), 1U);
    ASSERT_EQ(motor.frames.size(), 1U);
    EXPECT_EQ(motor.frames.front().second, 0.2) << "from where the motor is now, not from where it was told to be";
}

// Glides

TEST_F(StreamLimits, AGlideGoesAsFastAsItsRateFrameByFrame)
{
    ASSERT_TRUE(stream.start(setPointTo(0.25), 10s, {5.0, 0.1}));
    EXPECT_TRUE(stream.isGliding());
    clock.advance(45ms);
    ASSERT_EQ(motor.frames.size(), 3U);
    EXPECT_EQ(motor.frames[0].second, 0.1);
    EXPECT_NEAR(motor.frames[1].second, 0.2, 1e-12);
    EXPECT_EQ(motor.frames[2].second, 0.25);
    EXPECT_EQ(stream.setPoint().target, 0.25);
    EXPECT_FALSE(stream.isGliding());
}

TEST_F(StreamLimits, AnotherRateHoldsFromItsUpdateOn)
{
    ASSERT_TRUE(stream.start(setPointTo(1.0), 10s, {1.0, 0.0}));
    clock.advance(200ms);
    ASSERT_TRUE(stream.update(setPointTo(1.0), {0.5, {}}));
    clock.advance(200ms);
    EXPECT_NEAR(stream.setPoint().target, 0.3, 1e-9);
}

TEST_F(StreamLimits, AnotherModeBeginsWhereTheMotorIsAndNotAtATargetOfAnotherMeaning)
{
    ASSERT_TRUE(stream.start(setPointTo(0.5), 10s));
    motor.frames.clear();
    ASSERT_TRUE(stream.update(setPointTo(1000.0, Mode::Velocity), {100.0, 40.0}));
    ASSERT_EQ(motor.frames.size(), 1U);
    EXPECT_EQ(motor.frames[0].second, 40.0);
    clock.advance(20ms);
    EXPECT_NEAR(stream.setPoint().target, 42.0, 1e-9);
    ASSERT_TRUE(stream.update(setPointTo(0.2)));
    EXPECT_EQ(stream.setPoint().target, 0.2) << "nowhere to come from: at once";
    EXPECT_FALSE(stream.isGliding());
    clock.advance(100ms);
    EXPECT_EQ(stream.setPoint().target, 0.2);
}

TEST_F(StreamLimits, AGlideThatIsOnItsWayEndsWithAJumpAndWithAnotherMode)
{
    ASSERT_TRUE(stream.start(setPointTo(0.8), 10s, {1.0, 0.0}));
    clock.advance(100ms);
    ASSERT_TRUE(stream.update(setPointTo(0.5)));
    EXPECT_FALSE(stream.isGliding());
    clock.advance(100ms);
    EXPECT_EQ(stream.setPoint().target, 0.5);
    ASSERT_TRUE(stream.update(setPointTo(0.9), {1.0, {}}));
    clock.advance(100ms);
    ASSERT_TRUE(stream.isGliding());
    ASSERT_TRUE(stream.update(setPointTo(1000.0, Mode::Velocity), {100.0, 40.0}));
    EXPECT_EQ(stream.setPoint().target, 40.0) << "where it turns, not what its duty was";
    clock.advance(100ms);
    EXPECT_NEAR(stream.setPoint().target, 50.0, 1e-9);
}

TEST_F(StreamLimits, AGlideAfterADistanceOrATargetThatWaitsBeginsWhereTheMotorIs)
{
    for (const bool waits : {false, true}) {
        SetPoint before = setPointTo(0.0, Mode::Position);
        before.relative = !waits; // holds where it is
        before.buffered = waits;
        ASSERT_TRUE(stream.start(before, 10s));
        ASSERT_TRUE(stream.update(setPointTo(5200.0, Mode::Position), {1000.0, 5000.0}));
        EXPECT_EQ(stream.setPoint().target, 5000.0);
        clock.advance(100ms);
        EXPECT_NEAR(stream.setPoint().target, 5100.0, 1e-6);
        stream.stop();
    }
}

TEST_F(StreamLimits, NoRateJumpsFromWhatItWasToldAndTheSameTargetIsNoGlide)
{
    ASSERT_TRUE(stream.start(setPointTo(0.5), 10s, {1.0, 0.5}));
    EXPECT_FALSE(stream.isGliding());
    ASSERT_TRUE(stream.update(setPointTo(0.9), {0.0, 0.0}));
    EXPECT_EQ(stream.setPoint().target, 0.9);
    EXPECT_FALSE(stream.isGliding());
    ASSERT_TRUE(stream.update(setPointTo(0.9), {1.0, 0.0}));
    EXPECT_EQ(stream.setPoint().target, 0.9);
    EXPECT_FALSE(stream.isGliding());
}

class TwoAxes : public StreamLimits {
protected:
    TwoAxes()
        : StreamLimits(twoAxesFamily)
    {
    }
};

TEST_F(TwoAxes, EachAxisGlidesForItself)
{
    ASSERT_TRUE(stream.start(setPointTo(0.5), 10s));
    ASSERT_TRUE(stream.update(setPointTo(0.5, Mode::Duty, 2), {1.0, 0.0}));
    EXPECT_EQ(motor.others.back().second, 0.0) << "where axis 1 is told to be is no place of axis 2";
    clock.advance(100ms);
    EXPECT_NEAR(motor.others.back().second, 0.1, 1e-9);
    EXPECT_EQ(motor.frames.back().second, 0.5);
    ASSERT_TRUE(stream.update(setPointTo(0.7)));
    EXPECT_EQ(stream.setPoint().axis, 1);
    clock.advance(100ms);
    EXPECT_EQ(stream.setPoint(), setPointTo(0.7)) << "the newest, though the other one is on its way";
    EXPECT_NEAR(motor.others.back().second, 0.2, 1e-9);
    EXPECT_TRUE(stream.isGliding());
}

TEST_F(TwoAxes, AnAxisThatIsTakenOutGetsNoMoreFrames)
{
    ASSERT_TRUE(stream.start(setPointTo(0.5), 10s));
    ASSERT_TRUE(stream.update(setPointTo(0.4, Mode::Duty, 2)));
    EXPECT_EQ(stream.setPoints().size(), 2U);
    ASSERT_TRUE(stream.update(setPointTo(0.0, Mode::Off, 2)));
    EXPECT_EQ(stream.setPoints().size(), 1U);
    motor.frames.clear();
    motor.others.clear();
    clock.advance(105ms);
    EXPECT_EQ(motor.frames.size(), 5U);
    EXPECT_TRUE(motor.others.empty());
    EXPECT_EQ(motor.stops, 0);
}

TEST_F(StreamLimits, OffStopsTheOnlyAxisAndStaysItsSetPoint)
{
    ASSERT_TRUE(stream.start(setPointTo(0.5), 10s));
    motor.frames.clear();
    ASSERT_TRUE(stream.update(setPointTo(0.0, Mode::Off)));
    EXPECT_EQ(motor.stops, 1);
    EXPECT_EQ(stream.setPoints().size(), 1U);
    clock.advance(50ms);
    EXPECT_TRUE(motor.frames.empty());
    EXPECT_EQ(motor.stops, 3) << "as often as any other set-point";
    EXPECT_TRUE(stream.isRunning());
}

/// A motor that needs a guardian, which comes when the test says.
class Awaiting : public testing::Test {
protected:
    Awaiting()
    {
        EXPECT_TRUE(link.open());
        motor.guard().setSource(&guard);
        guard.standsAtOnce = false;
    }
    test::FreezingClock clock;
    test::FakeGuard guard;
    test::LoggedLink link{clock, {Outlet::Form::CanSocket, 7}};
    test::LooseMotor motor{link, clock};
    SetPointStream stream{motor, clock};
};

TEST_F(Awaiting, AGlideBeginsWithTheFirstFrameAndNotBeforeTheGuardianIsThere)
{
    ASSERT_TRUE(stream.start(setPointTo(0.8), 10s, {1.0, 0.1}));
    clock.advance(300ms);
    ASSERT_TRUE(stream.update(setPointTo(0.6), {1.0, 0.1}));
    EXPECT_EQ(stream.setPoint().target, 0.1);
    clock.advance(300ms);
    guard.become(GuardWatch::State::Standing);
    EXPECT_EQ(stream.setPoint().target, 0.1);
    clock.advance(20ms);
    EXPECT_NEAR(stream.setPoint().target, 0.12, 1e-9);
}

TEST_F(Awaiting, OffNeedsNoGuardianAndEndsTheWait)
{
    ASSERT_TRUE(stream.start(setPointTo(0.8), 10s));
    ASSERT_TRUE(stream.update(setPointTo(0.0, Mode::Off)));
    clock.advance(2500ms);
    EXPECT_TRUE(stream.isRunning()) << "the two seconds of a guardian are of no meaning any more";
    stream.stop();
    guard.calls = 0;
    SetPointStream off(motor, clock);
    ASSERT_TRUE(off.start(setPointTo(0.0, Mode::Off), 10s));
    EXPECT_EQ(guard.calls, 0);
    EXPECT_EQ(link.sent.back(), "00000100#00");
}

TEST_F(Awaiting, WhileItWaitsNothingIsLateAndNoSleepCounts)
{
    ASSERT_TRUE(stream.start(setPointTo(0.8), 10s));
    clock.freeze(350ms);
    clock.suspend(1h);
    stream.renew();
    EXPECT_TRUE(stream.isRunning()) << "the motor stands";
    guard.become(GuardWatch::State::Standing);
    EXPECT_TRUE(stream.isRunning());
    EXPECT_EQ(link.sent.size(), 1U);
}

// The slew itself

TEST(SetPointSlew, NeverChangesFasterThanItsRateInEitherDirectionAndTimeDoesNotRunBackwards)
{
    SetPointSlew slew;
    const Instant begin{5s};
    slew.start(10.0, begin);
    EXPECT_EQ(slew.value(), 10.0);
    EXPECT_EQ(slew.target(), 10.0);
    EXPECT_TRUE(slew.isThere());
    slew.setRate(4.0);
    slew.setTarget(20.0);
    EXPECT_FALSE(slew.isThere());
    EXPECT_EQ(slew.advance(begin + 500ms), 12.0);
    EXPECT_EQ(slew.advance(begin + 250ms), 12.0) << "backwards";
    EXPECT_EQ(slew.advance(begin + 500ms), 13.0) << "from the latest time it was told";
    slew.resume(begin + 10s);
    EXPECT_EQ(slew.advance(begin + 10500ms), 15.0);
    slew.setTarget(14.0);
    EXPECT_EQ(slew.advance(begin + 10750ms), 14.0);
    slew.setTarget(-100.0);
    EXPECT_EQ(slew.advance(begin + 11750ms), 10.0);
    slew.setRate(0.0);
    EXPECT_EQ(slew.advance(begin + 11750ms), -100.0) << "jumps";
    EXPECT_TRUE(slew.isThere());
}

} // namespace
} // namespace mb
