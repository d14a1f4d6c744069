// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of a stop: to whom it goes, how often, over a cut line, and what is known of it.
#include "support/fakeguard.h"
#include "support/loosemotor.h"
#include "support/simulatedsession.h"

#include <algorithm>

namespace mb {
namespace {

using namespace std::chrono_literals;
using test::SimulatedSession;

const std::string stopOfMotor = "00000100#00";

/// A motor without watchdog on a line that can be cut.
class Stopping : public testing::Test {
protected:
    Stopping()
    {
        EXPECT_TRUE(link.open());
        motor.guard().setSource(&guard);
    }
    void drive()
    {
        SetPoint setPoint;
        setPoint.mode = Mode::Duty;
        ASSERT_TRUE(stream.start(setPoint, 1h));
        clock.advance(100ms);
        link.sent.clear();
    }
    [[nodiscard]] auto stops() const { return std::count(link.sent.begin(), link.sent.end(), stopOfMotor); }

    VirtualClock clock;
    test::FakeGuard guard;
    test::LoggedLink link{clock, {Outlet::Form::CanSocket, 7}};
    test::LooseMotor motor{link, clock};
    SetPointStream stream{motor, clock};
};

TEST_F(Stopping, IsRepeatedUntilTheMotorIsSeenToStand)
{
    drive();
    EXPECT_TRUE(motor.stopping().hasMoved());
    stream.stop();
    EXPECT_EQ(motor.stopping().state(), StopState::Stopping);
    clock.advance(600ms);
    EXPECT_EQ(stops(), 3);
    motor.seenStopped = true;
    clock.advance(20ms);
    EXPECT_EQ(motor.stopping().state(), StopState::Seen);
    EXPECT_FALSE(motor.stopping().hasMoved());
    clock.advance(1min);
    EXPECT_EQ(stops(), 3);
}

TEST_F(Stopping, ThatNobodySeesSaysThatTheMotorMayStillTurnUntilItIsSeen)
{
    drive();
    stream.stop();
    clock.advance(9s);
    EXPECT_EQ(motor.stopping().state(), StopState::Stopping) << "it is heard, so it may be running out";
    clock.advance(2s);
    EXPECT_EQ(motor.stopping().state(), StopState::Unconfirmed);
    EXPECT_TRUE(motor.stopping().mayTurn());
    const auto before = stops();
    clock.advance(10s);
    EXPECT_NEAR(static_cast<double>(stops() - before), 9.0, 2.0) << "still told, now and then";
    motor.seenStopped = true;
    clock.advance(300ms);
    EXPECT_EQ(motor.stopping().state(), StopState::Seen);
    EXPECT_FALSE(motor.stopping().mayTurn());
}

/// A device of which only a stop and its guard know anything.
struct Known final : Stoppable {
    Known(Link &where, Clock &when, bool dog, bool talks)
        : Stoppable(dog)
        , line(where)
        , time(when)
    {
        life.heard = talks;
    }
    [[nodiscard]] Link &link() const override { return line; }
    [[nodiscard]] Clock &clock() const override { return time; }
    [[nodiscard]] std::string selector() const override { return "known"; }
    [[nodiscard]] const Liveness &liveness() const override { return life; }
    [[nodiscard]] bool isSeenStopped() const override { return false; }
    [[nodiscard]] Result<void> mayStop() const override { return {}; }
    void stop() override { }
    void repeatStop() override { ++repeats; }

    Link &line;
    Clock &time;
    Liveness life;
    int repeats = 0;
};

TEST_F(Stopping, IsBelievedOfAWatchdogOnlyWhileItsDeviceIsNotHeard)
{
    for (const bool watchdog : {false, true}) {
        for (const bool heard : {false, true}) {
            Known device(link, clock, watchdog, heard);
            DeviceStop stop(device);
            stop.driven();
            stop.told();
            clock.advance(11s);
            const bool believed = watchdog && !heard;
            EXPECT_EQ(stop.state(), believed ? StopState::ByWatchdog : StopState::Unconfirmed)
                << "watchdog " << watchdog << ", heard " << heard;
            EXPECT_EQ(stop.mayTurn(), !believed);
            EXPECT_GT(device.repeats, 2);
        }
    }
}

TEST_F(Stopping, IsForgottenByANewMotion)
{
    drive();
    stream.stop();
    drive();
    EXPECT_EQ(motor.stopping().state(), StopState::None);
    clock.advance(1s);
    EXPECT_EQ(stops(), 0);
}

TEST_F(Stopping, IsOwedOverACutLineAndGoesOutFirstWhenItIsBack)
{
    drive();
    link.lose({Fault::LinkLost, say("cut")});
    clock.advance(300ms);
    EXPECT_EQ(stream.end(), SetPointStream::End::LinkLost);
    EXPECT_EQ(motor.stopping().state(), StopState::Owed);
    EXPECT_TRUE(motor.stopping().mayTurn());
    link.sent.clear();
    ASSERT_TRUE(link.open());
    motor.stopping().linkIsBack();
    ASSERT_FALSE(link.sent.empty());
    EXPECT_EQ(link.sent.front(), stopOfMotor);
    EXPECT_EQ(motor.stopping().state(), StopState::Stopping);
}

TEST_F(Stopping, IsOwedForTenMinutes)
{
    drive();
    link.lose({Fault::LinkLost, say("cut")});
    clock.advance(9min);
    EXPECT_EQ(motor.stopping().state(), StopState::Owed);
    clock.advance(61s);
    EXPECT_EQ(motor.stopping().state(), StopState::Unconfirmed);
    EXPECT_FALSE(motor.stopping().isDue());
    link.sent.clear();
    ASSERT_TRUE(link.open());
    motor.stopping().linkIsBack();
    clock.advance(10s);
    EXPECT_TRUE(link.sent.empty());
}

TEST_F(Stopping, IsDismissedByTheUser)
{
    drive();
    link.lose({Fault::LinkLost, say("cut")});
    clock.advance(300ms);
    motor.stopping().dismiss();
    EXPECT_EQ(motor.stopping().state(), StopState::None);
    EXPECT_FALSE(motor.stopping().isDue());
}

TEST_F(Stopping, NothingIsDrivenWhileStopIsPressedAndNotYetServed)
{
    std::atomic<bool> gate = false;
    motor.gate().setStopGate(&gate);
    drive();
    gate = true;
    clock.advance(100ms);
    EXPECT_FALSE(stream.isRunning());
    EXPECT_EQ(std::count(link.sent.begin(), link.sent.end(), "00000100#01"), 0);
}

// The session: to whom

struct SentFrames {
    explicit SentFrames(Link &link)
        : tap(link.traffic().add([this](const Traffic &traffic) {
            if (traffic.can && traffic.direction == Direction::Sent)
                frames.push_back(toText(*traffic.can));
        }))
    {
    }
    [[nodiscard]] bool has(const std::string &frame) const
    {
        return std::find(frames.begin(), frames.end(), frame) != frames.end();
    }
    std::vector<std::string> frames;
    Subscription tap;
};

TEST(Stop, OfTheUserGoesToEveryDeviceThatCanBeStoppedMovingOrNot)
{
    SimulatedSession bench;
    bench.scan();
    bench.clock.advance(500ms);
    const SentFrames sent(*bench.link);
    bench.session.stopAll(StopCause::User);
    EXPECT_TRUE(sent.has("02060005#0F00000000000000")) << "stands, and is told all the same";
    EXPECT_TRUE(sent.has("02060007#0F00000000000000"));
    EXPECT_TRUE(sent.has("067#0000000000"));
    EXPECT_FALSE(sent.has("02060009#0F00000000000000")) << "waits in its bootloader";
    EXPECT_FALSE(bench.device(9)->mayStop());
    bench.clock.advance(500ms);
    for (Device *device : bench.session.devices()) {
        EXPECT_EQ(device->stopping().state() == StopState::Seen, device->mayStop().has_value()) << device->selector();
    }
}

TEST(Stop, OfTheUserGoesToADeviceThatIsSilentAndEndsWithAWord)
{
    SimulatedSession bench;
    bench.scan();
    bench.clock.advance(500ms);
    bench.simulator("dmc60c:7")->setPowered(false);
    bench.clock.advance(1s);
    ASSERT_FALSE(bench.device(7)->liveness().heard);
    const SentFrames sent(*bench.link);
    bench.session.stopAll(StopCause::User);
    EXPECT_TRUE(sent.has("02060007#0F00000000000000"));
    bench.clock.advance(1100ms);
    EXPECT_EQ(bench.device(7)->stopping().state(), StopState::Silent);
}

TEST(Stop, OfADeviceThatCannotBeToldIsNotSaidToHaveGotNoAnswer)
{
    test::SimulatedSession bench;
    bench.scan();
    Device *loading = bench.device(9);
    ASSERT_NE(loading, nullptr);
    ASSERT_FALSE(loading->mayStop());
    loading->stop(); // as an update does it before it begins
    bench.clock.advance(2s);
    EXPECT_EQ(loading->stopping().state(), StopState::None);
}

TEST(Stop, OfTheUserGoesToBothUnitsOfADuplicateNumber)
{
    SimulatedSession bench("sim:can?fault=duplicate");
    bench.scan();
    const SentFrames sent(*bench.link);
    bench.session.stopAll(StopCause::User);
    EXPECT_GE(std::count(sent.frames.begin(), sent.frames.end(), "02060005#0F00000000000000"), 2);
}

TEST(Stop, OfTheProgramGoesToWhatItHasMovedOnly)
{
    SimulatedSession bench;
    bench.scan();
    bench.clock.advance(500ms);
    SetPoint setPoint;
    setPoint.mode = Mode::Duty;
    setPoint.target = 0.3;
    ASSERT_TRUE(bench.session.stream(*bench.device(5)).start(setPoint, 60s));
    bench.clock.advance(200ms);
    const SentFrames sent(*bench.link);
    bench.session.stopAll(StopCause::Program);
    EXPECT_TRUE(sent.has("02060005#0F00000000000000"));
    EXPECT_FALSE(sent.has("02060007#0F00000000000000"));
    EXPECT_FALSE(sent.has("067#0000000000"));
}

TEST(Stop, OfAnOldDriveSendsNothingThatMayStartIt)
{
    SimulatedSession bench;
    bench.scan();
    Device &drive = *bench.device(3, "abstractdc");
    ASSERT_TRUE(drive.knowledge().setDialect("LL"));
    EXPECT_FALSE(drive.mayStop());
    const SentFrames sent(*bench.link);
    bench.session.stopAll(StopCause::User);
    drive.stop();
    EXPECT_FALSE(sent.has("067#0000000000000000")) << "to dialect LL that is a set-point";
}

TEST(Stop, OverACutLineIsTheFirstFrameWhenItIsBackAndWithinATenthOfASecond)
{
    SimulatedSession bench("sim:can?fault=busoff@3");
    bench.scan();
    bench.clock.advance(500ms);
    Device &drive = *bench.device(3, "abstractdc");
    SetPoint setPoint;
    setPoint.mode = Mode::Duty;
    setPoint.target = 0.3;
    ASSERT_TRUE(bench.session.stream(drive).start(setPoint, 60s));
    ASSERT_TRUE(bench.clock.runUntil([&] { return bench.link->state() == LinkState::Lost; }, 5s));
    bench.clock.advance(20ms);
    EXPECT_EQ(drive.stopping().state(), StopState::Owed);
    EXPECT_TRUE(bench.simulator("abstractdc:3")->isOutputOn()) << "the truth: it goes on";
    const SentFrames sent(*bench.link);
    const Instant lost = bench.clock.now();
    ASSERT_TRUE(bench.clock.runUntil([&] { return !sent.frames.empty(); }, 5s));
    EXPECT_EQ(sent.frames.front(), "067#0000000000");
    EXPECT_LE(bench.clock.now() - lost, 200ms) << "off the bus for 100 ms, and 100 ms more";
    ASSERT_TRUE(bench.clock.runUntil([&] { return drive.stopping().state() == StopState::Seen; }, 10s));
    EXPECT_FALSE(bench.simulator("abstractdc:3")->isOutputOn());
}

// Buffered moves

class BufferedMoves : public testing::Test {
protected:
    BufferedMoves() { bench.scan(); }
    Device &node(int id) { return *bench.device(id, "supermodified"); }
    void prepare(int id)
    {
        SetPoint move;
        move.mode = Mode::Position;
        move.target = 500.0;
        move.buffered = true;
        ASSERT_TRUE(bench.session.stream(node(id)).start(move, 60s));
        bench.clock.advance(500ms);
    }
    SimulatedSession bench{"sim:serial"};
};

TEST_F(BufferedMoves, BeginTogetherAndAreNotKeptAfterwards)
{
    prepare(4);
    prepare(5);
    EXPECT_TRUE(node(4).gate().keepsMove());
    ASSERT_TRUE(bench.session.stops().releaseMoves(node(4)));
    bench.clock.advance(500ms);
    EXPECT_FALSE(node(4).gate().keepsMove());
    EXPECT_FALSE(node(5).gate().keepsMove());
}

TEST_F(BufferedMoves, ThatWereStoppedAreNotBegunByAReleaseOnceTheirNodeMovesAgain)
{
    prepare(4);
    bench.session.stream(node(4)).stop();
    bench.clock.advance(500ms);
    SetPoint turn;
    turn.mode = Mode::Velocity;
    turn.target = 200.0;
    ASSERT_TRUE(bench.session.stream(node(4)).start(turn, 60s));
    bench.clock.advance(500ms);
    prepare(5);
    const auto released = bench.session.stops().releaseMoves(node(5));
    ASSERT_FALSE(released);
    EXPECT_EQ(released.error().fault, Fault::Unsafe);
    EXPECT_NE(released.error().text().find("number 4"), std::string::npos);
}

TEST_F(BufferedMoves, OfANodeThatWasStoppedIsShownAndDoesNotBeginWithTheOthers)
{
    prepare(4);
    bench.session.stopAll(StopCause::User);
    bench.clock.advance(500ms);
    EXPECT_TRUE(node(4).gate().keepsMove()) << "a stop does not take it from the node";
    prepare(5);
    const auto released = bench.session.stops().releaseMoves(node(5));
    ASSERT_FALSE(released);
    EXPECT_EQ(released.error().fault, Fault::Unsafe);
    EXPECT_NE(released.error().text().find("number 4"), std::string::npos);
    bench.clock.advance(500ms);
    EXPECT_FALSE(bench.simulator("supermodified:4")->isOutputOn());
    prepare(4); // a new one takes its place
    EXPECT_TRUE(bench.session.stops().releaseMoves(node(5)));
}

TEST_F(Stopping, MovesAreReleasedOnlyUnderGuard)
{
    const auto released = motor.releaseMoves();
    ASSERT_FALSE(released);
    EXPECT_EQ(released.error().fault, Fault::Unsafe) << "no guardian was called";
    EXPECT_TRUE(link.sent.empty());
}

} // namespace
} // namespace mb
