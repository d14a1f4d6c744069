// SPDX-License-Identifier: GPL-3.0-or-later
// When a stop is told again and when it is given up, to the millisecond, for every kind of device.
#include "async/virtualclock.h"
#include "model/devicestop.h"
#include "support/loosemotor.h"

#include <algorithm>
#include <optional>

namespace mb {
namespace {

using namespace std::chrono_literals;
using Milliseconds = std::vector<std::int64_t>;

/// A device of which only its stop knows anything; it does what the test says.
struct Told final : Stoppable {
    Told(Link &where, Clock &when, bool dog, Duration dogLimit = 250ms)
        : Stoppable(dog, dogLimit)
        , line(where)
        , time(when)
        , begin(when.now())
    {
        life.heard = true;
        changes = stopping.changed().add([this] { states.emplace_back(since(), stopping.state()); });
    }
    [[nodiscard]] Link &link() const override { return line; }
    [[nodiscard]] Clock &clock() const override { return time; }
    [[nodiscard]] std::string selector() const override { return "told"; }
    [[nodiscard]] const Liveness &liveness() const override { return life; }
    [[nodiscard]] bool isSeenStopped() const override { return seen; }
    [[nodiscard]] Result<void> mayStop() const override
    {
        return harmless ? Result<void>() : fail(Fault::Unsafe, say("it would start it"));
    }
    [[nodiscard]] StopScript stopScript() const override { return {{{extendedFrame(0x200, {7}), {}, {}, {}, 5ms, 1}}}; }
    void stop() override
    {
        ++stops;
        stopping.told();
    }
    void repeatStop() override { repeats.push_back(since()); }
    [[nodiscard]] std::int64_t since() const { return (time.now() - begin) / 1ms; }

    Link &line;
    Clock &time;
    Instant begin;
    Liveness life;
    bool seen = false;
    bool harmless = true;
    int stops = 0;
    Milliseconds repeats; ///< ms
    std::vector<std::pair<std::int64_t, StopState>> states;
    DeviceStop stopping{*this};
    Subscription changes;
};

class StopTimes : public testing::Test {
protected:
    using States = decltype(Told::states);
    StopTimes() { EXPECT_TRUE(link.open()); }
    Told &make(bool watchdog, bool heard, bool driven, Duration watchdogLimit = 250ms)
    {
        told.emplace(link, clock, watchdog, watchdogLimit);
        told->life.heard = heard;
        if (driven)
            told->stopping.driven();
        told->stop();
        return *told;
    }
    void cut() { link.lose({Fault::LinkLost, say("cut")}); }

    VirtualClock clock;
    test::LoggedLink link{clock, {Outlet::Form::CanSocket, 7}};
    std::optional<Told> told;
};

TEST_F(StopTimes, AMotorThatIsHeardAndDoesNotStandIsToldFourTimesASecondForTenSecondsAndThenOnceASecond)
{
    Told &motor = make(false, true, true);
    clock.advance(13s);
    Milliseconds expected;
    for (std::int64_t at = 250; at < 10000; at += 250)
        expected.push_back(at);
    expected.insert(expected.end(), {10750, 11750, 12750});
    EXPECT_EQ(motor.repeats, expected);
    EXPECT_EQ(motor.states, (States{{0, StopState::Stopping}, {10000, StopState::Unconfirmed}}));
    EXPECT_TRUE(motor.stopping.mayTurn());
}

TEST_F(StopTimes, ASilentMotorWithoutWatchdogIsUnconfirmedAfterOneSecondAndToldOn)
{
    Told &motor = make(false, false, true);
    clock.advance(3s);
    EXPECT_EQ(motor.repeats, (Milliseconds{250, 500, 750, 1750, 2750}));
    EXPECT_EQ(motor.states, (States{{0, StopState::Stopping}, {1000, StopState::Unconfirmed}}));
}

TEST_F(StopTimes, ASilentMotorWithWatchdogIsOffAfterOneSecondAndNotToldAnyMore)
{
    Told &motor = make(true, false, true);
    clock.advance(20s);
    EXPECT_EQ(motor.repeats, (Milliseconds{250, 500, 750}));
    EXPECT_EQ(motor.states, (States{{0, StopState::Stopping}, {1000, StopState::ByWatchdog}}));
    EXPECT_FALSE(motor.stopping.mayTurn());
    EXPECT_FALSE(motor.stopping.isDue());
}

TEST_F(StopTimes, WhatNobodyMovedEndsInSilenceAndIsNotToldAnyMore)
{
    for (const bool watchdog : {false, true}) {
        for (const bool heard : {false, true}) {
            Told &motor = make(watchdog, heard, false);
            EXPECT_FALSE(motor.stopping.isForMotion());
            clock.advance(20s);
            EXPECT_EQ(motor.states, (States{{0, StopState::Stopping}, {heard ? 10000 : 1000, StopState::Silent}}));
            EXPECT_EQ(motor.repeats.size(), heard ? 39U : 3U);
            EXPECT_FALSE(motor.stopping.mayTurn());
            EXPECT_FALSE(motor.stopping.isDue());
        }
    }
}

TEST_F(StopTimes, AStandingMotorIsSeenWithinTenMillisecondsAndLaterWithinAQuarterOfASecond)
{
    Told &motor = make(false, true, true);
    clock.advance(105ms);
    motor.seen = true;
    clock.advance(1s);
    EXPECT_EQ(motor.states, (States{{0, StopState::Stopping}, {110, StopState::Seen}}));
    EXPECT_FALSE(motor.stopping.hasMoved());
    EXPECT_FALSE(motor.stopping.isForMotion());
    EXPECT_TRUE(motor.repeats.empty());

    Told &late = make(false, true, true);
    clock.advance(10100ms);
    late.seen = true;
    clock.advance(1s);
    EXPECT_EQ(late.states.back(), (States::value_type{10250, StopState::Seen}));
}

TEST_F(StopTimes, AMotionOfSomebodyElseThatIsSeenCountsAsOne)
{
    told.emplace(link, clock, false);
    told->life.moving = true;
    told->stop();
    EXPECT_TRUE(told->stopping.isForMotion());
    EXPECT_FALSE(told->stopping.hasMoved());
    told->life.moving = false; // as its stop says
    told->stop();
    EXPECT_TRUE(told->stopping.isForMotion()) << "told twice it is still for that motion";
    clock.advance(11s);
    EXPECT_TRUE(told->stopping.mayTurn());
}

TEST_F(StopTimes, OverACutLineAMotorWithoutWatchdogIsOwedFromTheFirstMoment)
{
    cut();
    Told &motor = make(false, false, true);
    EXPECT_EQ(motor.stopping.state(), StopState::Owed);
    EXPECT_TRUE(motor.stopping.mayTurn());
    clock.advance(DeviceStop::debtLimit + 1s);
    EXPECT_EQ(motor.states, (States{{0, StopState::Owed}, {600010, StopState::Unconfirmed}}));
    EXPECT_TRUE(motor.repeats.empty()) << "nobody is there to be told";
    EXPECT_FALSE(motor.stopping.isDue());
}

TEST_F(StopTimes, OverACutLineAWatchdogIsBelievedAfterAQuarterOfASecond)
{
    cut();
    Told &motor = make(true, false, true);
    clock.advance(20s);
    EXPECT_EQ(motor.states, (States{{0, StopState::Stopping}, {250, StopState::ByWatchdog}}));
    EXPECT_TRUE(motor.repeats.empty());
    const Told &slower = make(true, false, true, 400ms);
    clock.advance(20s);
    EXPECT_EQ(slower.states.back(), (States::value_type{400, StopState::ByWatchdog})) << "as its family says";
}

TEST_F(StopTimes, ALineThatIsCutWhileAMotorIsToldMakesItOwedWithinTenMilliseconds)
{
    Told &motor = make(false, true, true);
    clock.advance(104ms);
    cut();
    clock.advance(6ms);
    EXPECT_EQ(motor.states.back(), (States::value_type{110, StopState::Owed}));
    clock.advance(20ms);
    motor.seen = true; // as if its telemetry came by another way
    clock.advance(1s);
    EXPECT_EQ(motor.states.back(), (States::value_type{370, StopState::Seen})) << "looked at four times a second";
}

TEST_F(StopTimes, AnUnconfirmedStopIsDueForTenMinutesAfterItWasTold)
{
    Told &motor = make(false, true, true);
    clock.advance(DeviceStop::debtLimit - 1ns);
    EXPECT_EQ(motor.stopping.state(), StopState::Unconfirmed);
    EXPECT_TRUE(motor.stopping.isDue());
    EXPECT_TRUE(motor.stopping.mayStillTurn());
    clock.advance(1ns);
    EXPECT_FALSE(motor.stopping.isDue());
    EXPECT_TRUE(motor.stopping.mayTurn()) << "nobody has seen it stand";
    EXPECT_FALSE(motor.stopping.mayStillTurn());
    motor.repeats.clear();
    clock.advance(1h);
    EXPECT_TRUE(motor.repeats.empty());
    EXPECT_EQ(motor.states,
        (States{{0, StopState::Stopping}, {10000, StopState::Unconfirmed}, {600000, StopState::Unconfirmed}}))
        << "once more, for it is told no more";
}

TEST_F(StopTimes, AMotionThatNobodyEndedMayGoOnHoweverLongAndOneOfAMuteUnitForTenMinutes)
{
    Told &motor = make(false, false, true);
    motor.stopping.driven();
    clock.advance(1h);
    EXPECT_TRUE(motor.stopping.mayStillTurn());
    for (const bool watchdog : {false, true}) {
        const Told &mute = make(watchdog, false, true);
        clock.advance(DeviceStop::debtLimit - 1ns);
        EXPECT_TRUE(mute.stopping.mayStillTurn());
        clock.advance(1ns);
        EXPECT_FALSE(mute.stopping.mayStillTurn());
    }
}

TEST_F(StopTimes, AStopThatMayStartAMotorIsNotRepeated)
{
    Told &motor = make(false, true, true);
    motor.harmless = false;
    clock.advance(13s);
    EXPECT_TRUE(motor.repeats.empty());
    EXPECT_EQ(motor.stopping.state(), StopState::Unconfirmed);
}

TEST_F(StopTimes, ALinkThatIsBackIsToldOnlyWhatIsDue)
{
    struct Row {
        const char *what;
        bool driven, harmless;
        StopState end;
        std::size_t sent;
        int stops;
    };
    for (const Row &row : {Row{"as it was", true, true, StopState::Stopping, 1, 2},
             Row{"a stop may start it", true, false, StopState::Owed, 0, 1},
             Row{"nothing had moved", false, true, StopState::Stopping, 1, 2}}) {
        cut();
        Told &motor = make(false, true, row.driven);
        clock.advance(1s);
        ASSERT_TRUE(link.open());
        link.sent.clear();
        motor.harmless = row.harmless;
        motor.stopping.linkIsBack();
        EXPECT_EQ(motor.stopping.state(), row.end) << row.what;
        EXPECT_EQ(link.sent.size(), row.sent) << row.what;
        EXPECT_EQ(motor.stops, row.stops) << row.what;
    }
    Told &idle = make(false, true, true);
    idle.stopping.dismiss();
    idle.stopping.linkIsBack();
    EXPECT_EQ(idle.stops, 1) << "the user has looked";
    EXPECT_EQ(idle.stopping.state(), StopState::None);
}

TEST_F(StopTimes, WhatIsDismissedOrDrivenAgainIsNotToldAnyMore)
{
    for (const bool dismissed : {true, false}) {
        Told &motor = make(false, true, true);
        clock.advance(600ms);
        motor.repeats.clear();
        if (dismissed)
            motor.stopping.dismiss();
        else
            motor.stopping.driven();
        EXPECT_EQ(motor.stopping.state(), StopState::None);
        EXPECT_EQ(motor.stopping.hasMoved(), !dismissed);
        EXPECT_FALSE(motor.stopping.isForMotion());
        clock.advance(20s);
        EXPECT_TRUE(motor.repeats.empty());
        EXPECT_EQ(motor.stopping.state(), StopState::None);
        if (dismissed) {
            motor.stop();
            EXPECT_FALSE(motor.stopping.isForMotion()) << "that motion is over";
        }
    }
}

TEST_F(StopTimes, AnInheritedStopIsForAMotionAndGoesOutAtOnce)
{
    told.emplace(link, clock, false);
    told->stopping.inherit(clock.now());
    EXPECT_EQ(told->stops, 1);
    EXPECT_TRUE(told->stopping.isForMotion());
    EXPECT_EQ(told->stopping.state(), StopState::Stopping);
}

TEST_F(StopTimes, ListenersHearOfAChangeOnce)
{
    Told &motor = make(false, true, true);
    motor.stop();
    motor.stop();
    EXPECT_EQ(motor.states.size(), 1U);
}

} // namespace
} // namespace mb
