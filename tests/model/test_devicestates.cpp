// SPDX-License-Identifier: GPL-3.0-or-later
// Who hears of what a device tells of itself: every change for those who record, few for those who show.
#include "async/virtualclock.h"
#include "model/heardsince.h"
#include "support/freezingclock.h"
#include "support/loosemotor.h"

namespace mb {
namespace {

using namespace std::chrono_literals;

constexpr StateRow toldStates[] = {{"limit", "Limit", "limit holds", StateKind::Condition},
    {"halted", "Halted", "halted", StateKind::Rest}, {"pin", "Pin", {}, StateKind::Input}};
constexpr StateIndex limitState{0};
constexpr StateIndex haltedState{1};
constexpr StateIndex pinState{2};

constexpr Family tellingFamily = [] {
    Family family = test::looseFamily;
    family.states = toldStates;
    return family;
}();

class TellingMotor final : public test::MuteDevice {
public:
    TellingMotor(CanLink &link, Clock &clock)
        : MuteDevice(tellingFamily, link, clock, {})
    {
    }
    void tell(StateIndex index, bool on, Instant time)
    {
        LiveStates now = states();
        now.set(index, on);
        setLiveness(liveness(), now, time);
    }
    void tell(const Liveness &now) { setLiveness(now); }

private:
    Result<void> doCommand(const SetPoint &) override { return {}; }
    void doStop() override { }
    [[nodiscard]] bool isSeenStopped() const override { return true; }
};

class DeviceStates : public testing::Test {
protected:
    DeviceStates()
    {
        shown = motor.changed().add([this] { ++shows; });
        recorded = motor.statesChanged().add([this](Instant time) { records.push_back(time); });
    }
    void tell(StateIndex index, bool on, Duration at) { motor.tell(index, on, Instant{10s} + at); }

    VirtualClock clock;
    test::LoggedLink link{clock, {Outlet::Form::CanSocket, 7}};
    TellingMotor motor{link, clock};
    Subscription shown;
    Subscription recorded;
    int shows = 0;
    std::vector<Instant> records;
};

TEST(HeardSince, IsOverWhereItWasSilentOrTheComputerSleptForSoLongThatItMayBeAnother)
{
    for (const bool sleeps : {false, true}) {
        for (const Duration time : {exchangeTime - 1ns, exchangeTime}) {
            test::FreezingClock clock;
            test::LoggedLink link{clock, {Outlet::Form::CanSocket, 7}};
            TellingMotor motor{link, clock};
            HeardSince same(motor);
            Liveness heard = motor.liveness();
            heard.heard = sleeps;
            motor.tell(heard);
            sleeps ? clock.suspend(time) : clock.freeze(time);
            heard.heard = true;
            motor.tell(heard);
            EXPECT_EQ(same.holds(motor), time < exchangeTime) << sleeps;
        }
    }
}

TEST_F(DeviceStates, APinIsShownTwentyTimesASecondAtMostAndRecordedEachTime)
{
    tell(pinState, true, 0ms);
    EXPECT_EQ(shows, 1);
    tell(pinState, false, 20ms);
    tell(pinState, true, 30ms);
    tell(pinState, false, 50ms - 1ns);
    EXPECT_EQ(shows, 1);
    tell(pinState, false, 50ms);
    EXPECT_EQ(shows, 2);
    tell(pinState, false, 200ms);
    EXPECT_EQ(shows, 2) << "nothing new";
    EXPECT_EQ(records,
        (std::vector<Instant>{Instant{10s}, Instant{10s} + 20ms, Instant{10s} + 30ms, Instant{10s} + 50ms - 1ns}));
}

TEST_F(DeviceStates, AConditionIsShownAtOnceAndTakesThePinsAlong)
{
    tell(pinState, true, 0ms);
    tell(pinState, false, 10ms);
    tell(limitState, true, 11ms);
    EXPECT_EQ(shows, 2);
    tell(pinState, false, 61ms);
    EXPECT_EQ(shows, 2) << "shown with the limit";
    tell(haltedState, true, 62ms);
    tell(limitState, false, 63ms);
    EXPECT_EQ(shows, 4);
}

TEST_F(DeviceStates, LivenessIsShownWhenItChanges)
{
    Liveness now = motor.liveness();
    motor.tell(now);
    EXPECT_EQ(shows, 0);
    now.moving = true;
    motor.tell(now);
    EXPECT_EQ(shows, 1);
    EXPECT_TRUE(motor.liveness().moving);
    EXPECT_TRUE(records.empty());
}

TEST_F(DeviceStates, ARestartTakesTheMoveThatTheDeviceKept)
{
    motor.gate().moveSent();
    Liveness now = motor.liveness();
    now.moving = true;
    motor.tell(now);
    EXPECT_TRUE(motor.gate().keepsMove());
    now.restarted = true;
    motor.tell(now);
    EXPECT_FALSE(motor.gate().keepsMove());
    motor.gate().moveSent(); // a new one, given since
    now.moving = false;
    motor.tell(now);
    EXPECT_TRUE(motor.gate().keepsMove());
}

} // namespace
} // namespace mb
