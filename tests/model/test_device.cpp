// SPDX-License-Identifier: GPL-3.0-or-later
// What all devices have in common: what may be read, written, moved and stopped, and what is known afterwards.
#include "async/virtualclock.h"
#include "model/answersagain.h"
#include "model/parametertransfer.h"
#include "support/loosemotor.h"
#include "support/simulatedsession.h"

#include <atomic>
#include <functional>
#include <span>

namespace mb {
namespace {

using namespace std::chrono_literals;

constexpr Parameter commonRow(std::string_view key, std::uint16_t id, Access access, Nature nature = Nature::Setting)
{
    return {key, id, WireType::Int32, 1.0, "", 0.0, 100.0, 0.0, access, true, nature, "Group", key, "help"};
}
constexpr std::array<Parameter, 5> commonRows{commonRow("told", 1, Access::WriteOnly),
    commonRow("asked", 2, Access::ReadWrite), commonRow("fixed", 3, Access::ReadOnly),
    commonRow("count", 4, Access::ReadWrite, Nature::Counter), commonRow("place", 5, Access::ReadWrite, Nature::Live)};
constexpr ParameterIndex toldRow{0};
constexpr ParameterIndex askedRow{1};
constexpr ParameterIndex fixedRow{2};
constexpr ParameterIndex countedRow{3};
constexpr ParameterIndex placeRow{4};

constexpr Family commonFamily(bool keepsSettings, bool storesAtOnce)
{
    Family family = test::looseFamily;
    family.parameters = commonRows;
    family.capabilities.watchdog = true;
    family.capabilities.watchdogLimit = 330ms;
    family.capabilities.keepsSettings = keepsSettings;
    family.capabilities.storesAtOnce = storesAtOnce;
    family.capabilities.restart = true;
    return family;
}
constexpr Family plainFamily = commonFamily(true, false);
constexpr Family forgetfulFamily = commonFamily(false, false);
constexpr Family storingFamily = commonFamily(true, true);

/// Answers what it is told to answer.
class AnsweringMotor final : public test::MuteDevice {
public:
    AnsweringMotor(CanLink &link, Clock &clock, const Family &family)
        : MuteDevice(family, link, clock, {})
    {
    }
    Task<void> refresh() override
    {
        ++refreshes;
        co_return answers ? Result<void>() : fail(silence);
    }
    void meetMaster()
    {
        Liveness now = liveness();
        now.foreignMaster = true;
        setLiveness(now);
    }
    void restartUnseen()
    {
        Liveness now = liveness();
        now.restarted = true;
        setLiveness(now);
    }

    bool answers = true;
    Fault silence = Fault::Timeout; ///< of a question that it does not answer
    std::int64_t inForce = 0;       ///< what it makes of a value
    bool obeys = true;
    Fault refusal = Fault::Unsafe; ///< of a write that it does not obey
    Result<void> ownReason;
    std::optional<ParameterIndex> missing; ///< in its dialect
    int refreshes = 0;
    int reads = 0;
    int writes = 0;
    int commands = 0;
    int releases = 0;
    int stops = 0;
    int restarts = 0;
    std::function<void()> whenCommanded;

private:
    Task<std::int64_t> doRead(ParameterIndex) override
    {
        ++reads;
        if (!answers)
            co_return fail(Fault::Timeout);
        co_return inForce;
    }
    Task<std::int64_t> doWrite(ParameterIndex, std::int64_t) override
    {
        ++writes;
        if (!answers)
            co_return fail(Fault::Timeout);
        if (!obeys)
            co_return fail(refusal);
        co_return inForce;
    }
    Task<void> doRestart() override
    {
        ++restarts;
        co_return {};
    }
    Result<void> doCommand(const SetPoint &) override
    {
        ++commands;
        if (whenCommanded)
            whenCommanded();
        return obeys ? Result<void>() : fail(Fault::Refused);
    }
    Result<void> doReleaseMoves() override
    {
        ++releases;
        return {};
    }
    [[nodiscard]] bool offers(ParameterIndex index) const override { return missing != index; }
    Task<void> doMayWrite(ParameterIndex, std::int64_t, std::span<const ParameterChange>) override
    {
        co_return ownReason;
    }
    Result<void> doMayMove() const override { return ownReason; }
    Result<void> doMayStop() const override { return ownReason; }
    void doStop() override { ++stops; }
    [[nodiscard]] bool isSeenStopped() const override { return true; }
};

class CommonDevice : public testing::Test {
protected:
    CommonDevice() { EXPECT_TRUE(link.open()); }
    AnsweringMotor &make(const Family &family = plainFamily)
    {
        motor.emplace(link, clock, family);
        motor->inForce = 42;
        return *motor;
    }
    [[nodiscard]] ParameterStore::Entry entry(ParameterIndex index) const { return motor->parameters().entry(index); }
    Result<std::int64_t> write(ParameterIndex index) { return test::run(clock, motor->write(index, 7)); }
    Result<std::int64_t> read(ParameterIndex index) { return test::run(clock, motor->read(index)); }
    static SetPoint duty(bool buffered = false)
    {
        SetPoint setPoint;
        setPoint.mode = Mode::Duty;
        setPoint.target = 0.3;
        setPoint.buffered = buffered;
        return setPoint;
    }

    VirtualClock clock;
    test::LoggedLink link{clock, {Outlet::Form::CanSocket, 7}};
    std::optional<AnsweringMotor> motor;
};

TEST_F(CommonDevice, AUnitThatWasWrittenIsAskedTenTimesInFiveSecondsBeforeItCountsAsSilent)
{
    make().answers = false;
    const Instant begin = clock.now();
    EXPECT_EQ(test::run(clock, answersAgain(*motor)), false);
    EXPECT_EQ(motor->refreshes, 10);
    EXPECT_EQ(clock.now() - begin, 5s);
    motor->silence = Fault::LinkLost;
    EXPECT_EQ(test::run(clock, answersAgain(*motor)).error().fault, Fault::LinkLost);
    EXPECT_EQ(motor->refreshes, 11) << "nobody could answer";
    motor->answers = true;
    EXPECT_EQ(test::run(clock, answersAgain(*motor)), true);
    EXPECT_EQ(motor->refreshes, 12);
    EXPECT_EQ(clock.now() - begin, 6s) << "half a second after it was written, and after each question";
}

TEST_F(CommonDevice, WhatIsReadIsKnownAndWhatWasNotAnsweredHasFailed)
{
    make();
    EXPECT_EQ(read(askedRow), 42);
    EXPECT_EQ(entry(askedRow).raw, 42);
    EXPECT_EQ(read(toldRow).error().fault, Fault::Unsupported);
    EXPECT_EQ(motor->reads, 1) << "a value that cannot be read is not askedRow for";
    motor->answers = false;
    EXPECT_EQ(read(askedRow).error().fault, Fault::Timeout);
    EXPECT_EQ(entry(askedRow).state, ParameterState::Failed);
}

TEST_F(CommonDevice, NothingIsWrittenWhereOneOfSeveralValuesMayNotBe)
{
    const std::vector<ParameterChange> changes{{askedRow, 42}, {placeRow, 42}};
    NoProgress unseen;
    const auto written = [&] { return test::run(clock, writeParameters(*motor, changes, unseen)).value(); };
    make().missing = placeRow;
    ASSERT_EQ(written().size(), 1U);
    EXPECT_EQ(written().front().index, placeRow);
    EXPECT_EQ(written().front().raw.error().fault, Fault::Unsupported);
    motor->missing.reset();
    motor->ownReason = fail(Fault::OutOfRange);
    EXPECT_EQ(written().front().raw.error().fault, Fault::OutOfRange);
    EXPECT_EQ(write(askedRow).error().fault, Fault::OutOfRange) << "nor one alone";
    EXPECT_EQ(motor->writes, 0);
    motor->ownReason = {};
    EXPECT_EQ(written().size(), 2U);
    EXPECT_EQ(motor->writes, 2);
}

TEST_F(CommonDevice, WhatIsWrittenIsKnownAsTheDeviceMadeIt)
{
    make();
    EXPECT_EQ(write(askedRow), 42);
    EXPECT_EQ(entry(askedRow).raw, 42);
    EXPECT_EQ(entry(askedRow).state, ParameterState::Ram);
    EXPECT_TRUE(motor->knowledge().profile().isEmpty()) << "the device keeps it";
    EXPECT_EQ(write(toldRow), 42);
    EXPECT_EQ(motor->knowledge().profile().written.at("told"), 42) << "nobody else does";
    EXPECT_EQ(write(fixedRow).error().fault, Fault::OutOfRange);
    EXPECT_EQ(motor->writes, 2);
    EXPECT_EQ(write(countedRow), 42);
    EXPECT_FALSE(entry(countedRow).raw) << "a count that was cleared is not what it was";
}

TEST_F(CommonDevice, TheLastWriteIsThatOfTheNewestValueThatFlashPerhapsDoesNotHave)
{
    make();
    const ParameterStore &store = motor->parameters();
    EXPECT_EQ(write(toldRow), 42);
    EXPECT_EQ(store.lastWrite(), std::nullopt) << "nothing is known of its flash";
    clock.advance(1s);
    EXPECT_EQ(write(askedRow), 42);
    const Instant first = clock.now();
    EXPECT_EQ(store.lastWrite(), first);
    clock.advance(1s);
    EXPECT_EQ(write(askedRow), 42);
    EXPECT_EQ(store.lastWrite(), first) << "it had that already";
    motor->inForce = 43;
    EXPECT_EQ(write(askedRow), 43);
    EXPECT_EQ(store.lastWrite(), first + 1s);
}

TEST_F(CommonDevice, OfADeviceThatForgetsItsSettingsTheyAreKeptHere)
{
    make(forgetfulFamily);
    EXPECT_EQ(write(askedRow), 42);
    EXPECT_EQ(motor->knowledge().profile().written.at("asked"), 42);
    EXPECT_EQ(write(countedRow), 42);
    EXPECT_FALSE(motor->knowledge().profile().written.contains("count")) << "that is no setting";
}

TEST_F(CommonDevice, OfADeviceThatStoresAtOnceNothingIsLeftToBeStored)
{
    make(storingFamily);
    EXPECT_EQ(write(askedRow), 42);
    EXPECT_EQ(entry(askedRow).state, ParameterState::Stored);
    motor->answers = false;
    EXPECT_FALSE(write(askedRow));
    make(plainFamily);
    EXPECT_EQ(write(askedRow), 42);
    EXPECT_EQ(entry(askedRow).state, ParameterState::Ram);
}

TEST_F(CommonDevice, AWriteThatWasNotAnsweredChangesNothingThatIsKnown)
{
    for (const Family *family : {&plainFamily, &forgetfulFamily, &storingFamily}) {
        make(*family).answers = false;
        EXPECT_FALSE(write(toldRow));
        EXPECT_FALSE(write(askedRow));
        EXPECT_FALSE(entry(toldRow).raw);
        EXPECT_FALSE(entry(askedRow).raw);
        EXPECT_TRUE(motor->knowledge().profile().isEmpty());
    }
}

TEST_F(CommonDevice, ItsWatchdogIsThatOfItsFamily)
{
    make(plainFamily);
    EXPECT_TRUE(motor->hasWatchdog());
    EXPECT_EQ(motor->watchdogLimit(), 330ms);
}

TEST_F(CommonDevice, NothingMovesThatMayNot)
{
    struct Row {
        const char *what;
        std::function<void(AnsweringMotor &)> make;
    };
    const auto state = [](DeviceState is) {
        return [is](AnsweringMotor &one) {
            Identity known = one.identity();
            known.state = is;
            one.setIdentity(known);
        };
    };
    for (const Row &row : {Row{"its firmware is written", [](auto &m) { m.gate().setBusy(say("busy")); }},
             Row{"its link is gone",
                 [this](auto &) {
                     link.lose({Fault::LinkLost, say("cut")});
                 }},
             Row{"several answer", state(DeviceState::Duplicate)},
             Row{"it has no number", state(DeviceState::Unassigned)},
             Row{"no application runs", state(DeviceState::Bootloader)},
             Row{"another master", [](auto &m) { m.meetMaster(); }},
             Row{"it restarted, and nobody has looked at it", [](auto &m) { m.restartUnseen(); }},
             Row{"the family's own reason", [](auto &m) { m.ownReason = fail(Fault::Unsafe); }}}) {
        make();
        ASSERT_TRUE(link.open());
        EXPECT_TRUE(motor->mayMove());
        EXPECT_TRUE(motor->command(duty()));
        EXPECT_TRUE(motor->releaseMoves());
        row.make(*motor);
        EXPECT_FALSE(motor->mayMove()) << row.what;
        EXPECT_FALSE(motor->command(duty())) << row.what;
        EXPECT_FALSE(motor->releaseMoves()) << row.what;
        EXPECT_EQ(motor->commands, 1) << row.what;
        EXPECT_EQ(motor->releases, 1) << row.what;
    }
}

TEST_F(CommonDevice, PositionsCountFromAnotherPlaceOnceItHasRestarted)
{
    const auto origin = make().gate().origin();
    motor->meetMaster();
    EXPECT_EQ(motor->gate().origin(), origin);
    motor->restartUnseen();
    EXPECT_NE(motor->gate().origin(), origin);
}

TEST_F(CommonDevice, PositionsCountFromAnotherPlaceOnceTheirCounterWasWrittenOrMayHaveBeen)
{
    make();
    const auto moves = [this](ParameterIndex row) {
        const auto origin = motor->gate().origin();
        (void)write(row);
        return motor->gate().origin() != origin;
    };
    EXPECT_TRUE(moves(placeRow));
    EXPECT_FALSE(moves(askedRow)) << "a setting";
    EXPECT_FALSE(moves(countedRow));
    motor->obeys = false;
    for (const Fault lost : {Fault::Timeout, Fault::LinkLost, Fault::BadReply, Fault::BadCheck, Fault::Cancelled}) {
        motor->refusal = lost;
        EXPECT_TRUE(moves(placeRow)) << "nobody knows whether it came: " << static_cast<int>(lost);
    }
    for (const Fault refused : {Fault::Unsafe, Fault::Refused, Fault::OutOfRange, Fault::Unsupported}) {
        motor->refusal = refused;
        EXPECT_FALSE(moves(placeRow)) << "it did not: " << static_cast<int>(refused);
    }
}

TEST_F(CommonDevice, WhileStopIsPressedNothingIsDrivenOrReleased)
{
    std::atomic<bool> pressed = true;
    make().gate().setStopGate(&pressed);
    EXPECT_FALSE(motor->command(duty()));
    EXPECT_FALSE(motor->releaseMoves());
    EXPECT_EQ(motor->commands + motor->releases, 0);
    EXPECT_FALSE(motor->stopping().hasMoved());
    pressed = false;
    EXPECT_TRUE(motor->command(duty()));
    EXPECT_TRUE(motor->releaseMoves());
    EXPECT_TRUE(motor->stopping().hasMoved());
}

TEST_F(CommonDevice, OnlyWhatTheDeviceTookHasMovedIt)
{
    make().obeys = false;
    EXPECT_FALSE(motor->command(duty()));
    EXPECT_FALSE(motor->stopping().hasMoved());
    motor->obeys = true;
    EXPECT_TRUE(motor->command(duty()));
    EXPECT_TRUE(motor->stopping().hasMoved());
}

TEST_F(CommonDevice, AStopLeavesAMoveThatTheDeviceKeepsAndNobodyWantsIt)
{
    make().stop();
    EXPECT_FALSE(motor->gate().keepsMove());
    for (const bool isAcknowledged : {false, true}) {
        motor->gate().moveSent();
        if (isAcknowledged)
            motor->gate().moveAcknowledged(duty());
        motor->stop();
        EXPECT_EQ(motor->gate().kept().state, KeptMove::State::Stale);
    }
    EXPECT_FALSE(motor->gate().moveReleased()) << "nobody wants it";
    motor->gate().moveSent();
    EXPECT_FALSE(motor->gate().moveReleased()) << "nobody knows whether it has one";
    motor->gate().moveAcknowledged(duty());
    EXPECT_TRUE(motor->gate().moveReleased());
    EXPECT_TRUE(motor->gate().keepsMove()) << "nobody knows whether it has heard that";
    motor->stop();
    EXPECT_EQ(motor->gate().kept().state, KeptMove::State::Stale);
}

TEST_F(CommonDevice, AnOrderWithWhichTheLinkWentForgetsNotItsStop)
{
    ASSERT_TRUE(make().command(duty()));
    motor->whenCommanded = [this] {
        link.lose({Fault::LinkLost, say("cut")});
        motor->stop(); // as whoever drives it does at once
    };
    EXPECT_FALSE(motor->command(duty()));
    EXPECT_EQ(motor->stopping().state(), StopState::Stopping);
    ASSERT_TRUE(link.open());
    motor->stopping().linkIsBack();
    EXPECT_EQ(motor->stops, 2);
}

TEST_F(CommonDevice, ARefusedMoveLeavesWhatTheDeviceKept)
{
    make().gate().moveSent();
    motor->gate().moveRefused();
    EXPECT_FALSE(motor->gate().keepsMove());
    motor->gate().moveAcknowledged(duty());
    motor->gate().moveSent();
    motor->gate().moveRefused();
    EXPECT_TRUE(motor->gate().moveReleased());
    EXPECT_EQ(motor->gate().kept().order, duty());
    motor->gate().forgetMove();
    motor->gate().moveSent();
    motor->gate().moveSent(); // the first has no answer
    motor->gate().moveRefused();
    EXPECT_EQ(motor->gate().kept().state, KeptMove::State::Sent) << "it may have taken the first";
    motor->stop();
    motor->gate().moveRefused();
    EXPECT_EQ(motor->gate().kept().state, KeptMove::State::Stale);
}

TEST_F(CommonDevice, OffIsAStopWhateverForbidsAMotion)
{
    make().gate().setBusy(say("its firmware is written"));
    EXPECT_TRUE(motor->command({}));
    EXPECT_EQ(motor->stops, 1);
    EXPECT_EQ(motor->commands, 0);
    EXPECT_EQ(motor->gate().stoppedAt(), clock.now());
}

TEST_F(CommonDevice, AStopIsHarmlessUnlessAReasonSaysOtherwise)
{
    make();
    EXPECT_TRUE(motor->mayStop());
    motor->gate().setBusy(say("its firmware is written"));
    EXPECT_FALSE(motor->mayStop());
    motor->gate().setBusy({});
    motor->ownReason = fail(Fault::Unsafe);
    EXPECT_FALSE(motor->mayStop());
    motor->ownReason = {};
    Identity known = motor->identity();
    known.state = DeviceState::Bootloader;
    motor->setIdentity(known);
    EXPECT_FALSE(motor->mayStop());
    motor->stop();
    EXPECT_EQ(motor->stops, 1) << "who stops it all the same does";
}

TEST_F(CommonDevice, ARestartStopsTheMotorFirstAndWaitsForAnUpdate)
{
    make().gate().setBusy(say("its firmware is written"));
    EXPECT_EQ(test::run(clock, motor->restart()).error().fault, Fault::Unsafe);
    EXPECT_EQ(motor->restarts + motor->stops, 0);
    motor->gate().setBusy({});
    EXPECT_TRUE(test::run(clock, motor->restart()));
    EXPECT_EQ(motor->restarts, 1);
    EXPECT_EQ(motor->stops, 1);
}

TEST_F(CommonDevice, ListenersHearOfAnIdentityThatIsAnother)
{
    make();
    int changes = 0;
    const auto listening = motor->changed().add([&changes] { ++changes; });
    motor->setIdentity(motor->identity());
    EXPECT_EQ(changes, 0);
    Identity known = motor->identity();
    known.name = "other";
    motor->setIdentity(known);
    EXPECT_EQ(changes, 1);
    EXPECT_EQ(motor->identity().name, "other");
}

} // namespace
} // namespace mb
