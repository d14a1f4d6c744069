// SPDX-License-Identifier: GPL-3.0-or-later
// A drive has no word for its restart: its position begins at 0 again, its mode is none, and what was not saved is gone.
#include "abstractdccontrollerbench.h"

#include "async/progress.h"

namespace mb::abstractdc {
namespace {

class AbstractDcRestart : public AbstractDcController {
protected:
    /// Of a drive that resets itself, 3 s after this has begun.
    Simulator &drive() { return add("abstractdc:3,fault=reset@3"); }
    void isStoppedByTheReset(Simulator &drive, SetPoint order)
    {
        SetPointStream stream(*device, clock);
        ASSERT_TRUE(stream.start(order, 60s));
        ASSERT_TRUE(clock.runUntil([this] { return happened("reset"); }, 10s));
        ASSERT_GT(std::abs(latest("position")), 1000.0);
        sent.clear();
        EXPECT_FALSE(clock.runUntil([&] { return drive.isOutputOn(); }, 3s)) << "nobody ordered it again";
        EXPECT_EQ(stream.end(), SetPointStream::End::DeviceRestarted) << stream.reason().english();
        EXPECT_FALSE(sentOf("067#00").empty()) << "the stop";
        EXPECT_TRUE(device->liveness().restarted) << "until somebody looks at it";
        ASSERT_TRUE(test::run(clock, device->refresh()));
        EXPECT_FALSE(device->liveness().restarted);
    }
    bool store()
    {
        NoProgress progress;
        const auto stored = test::run(clock, device->store(progress));
        return stored.has_value();
    }
};

TEST_F(AbstractDcRestart, InMotionEndsADutyInsteadOfDrivingOn)
{
    Simulator &unit = drive();
    open(3, &dialectF);
    isStoppedByTheReset(unit, setPoint(Mode::Duty, 0.6));
}

TEST_F(AbstractDcRestart, InMotionEndsAVelocityInsteadOfDrivingOn)
{
    Simulator &unit = drive();
    open(3, &dialectF);
    isStoppedByTheReset(unit, setPoint(Mode::Velocity, 1500.0));
}

TEST_F(AbstractDcRestart, InMotionEndsAPositionThatWouldBeTravelledTwice)
{
    Simulator &unit = drive();
    open(3, &dialectF);
    isStoppedByTheReset(unit, setPoint(Mode::Position, 3000.0));
}

TEST_F(AbstractDcRestart, IsSeenBackwardsToo)
{
    Simulator &unit = drive();
    open(3, &dialectF);
    isStoppedByTheReset(unit, setPoint(Mode::Duty, -0.6));
}

TEST_F(AbstractDcRestart, NothingIsSentToADriveAtWhichNobodyHasLookedSince)
{
    drive();
    open(3, &dialectF);
    SetPointStream stream(*device, clock);
    ASSERT_TRUE(stream.start(setPoint(Mode::Duty, 0.6), 60s));
    ASSERT_TRUE(clock.runUntil([this] { return device->liveness().restarted; }, 10s));
    ASSERT_EQ(stream.end(), SetPointStream::End::DeviceRestarted);
    clock.advance(3s);
    sent.clear();
    const auto refused = stream.start(setPoint(Mode::Duty, 0.6), 60s);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().fault, Fault::Unsafe);
    EXPECT_TRUE(sentOf("067#").empty()) << "neither the set-point nor its stop";
    ASSERT_TRUE(test::run(clock, device->refresh()));
    EXPECT_TRUE(stream.start(setPoint(Mode::Duty, 0.6), 60s));
    stream.stop();
}

TEST_F(AbstractDcRestart, IsNotSeenInAMotorThatPassesItsZero)
{
    add("abstractdc:3");
    open(3, &dialectF);
    SetPointStream stream(*device, clock);
    ASSERT_TRUE(stream.start(setPoint(Mode::Duty, 1.0), 60s));
    clock.advance(2s);
    ASSERT_TRUE(stream.update(setPoint(Mode::Duty, -1.0)));
    ASSERT_TRUE(clock.runUntil([this] { return latest("position") < -1000.0; }, 20s));
    ASSERT_TRUE(stream.update(setPoint(Mode::Duty, 1.0)));
    ASSERT_TRUE(clock.runUntil([this] { return latest("position") > 1000.0; }, 20s));
    EXPECT_TRUE(stream.isRunning()) << stream.reason().english();
    stream.stop();
}

TEST_F(AbstractDcRestart, TakesWhatWasWrittenAndNotSaved)
{
    Simulator &unit = add("abstractdc:3");
    open(3, &dialectF);
    ASSERT_TRUE(write("velocity.p", 4));
    ASSERT_TRUE(write("velocity.divisor", 3));
    ASSERT_TRUE(store());
    ASSERT_TRUE(write("velocity.p", 5));
    powerCycle(unit, 1s);
    EXPECT_FALSE(device->parameters().entry(index("velocity.p")).raw) << "the flash has 4, if nobody else wrote it";
    EXPECT_TRUE(device->knowledge().profile().lost.contains("velocity.p"));
    EXPECT_EQ(device->parameters().entry(index("velocity.divisor")).raw, 3) << "saved";
    EXPECT_FALSE(device->knowledge().profile().lost.contains("velocity.divisor"));
    ASSERT_TRUE(write("velocity.p", 5));
    EXPECT_FALSE(device->knowledge().profile().lost.contains("velocity.p"));
    ASSERT_TRUE(store());
    powerCycle(unit, 1s);
    EXPECT_EQ(device->parameters().entry(index("velocity.p")).raw, 5) << "saved, too";
}

TEST_F(AbstractDcRestart, TakesWhatAnotherRunWroteAndWhatAnotherMasterWrote)
{
    Simulator &unit = add("abstractdc:3");
    open(3, &dialectF);
    ASSERT_TRUE(write("velocity.p", 5));
    ASSERT_TRUE(write("position.p", 6));
    ASSERT_TRUE(store());
    ASSERT_TRUE(write("velocity.p", 7));
    const DeviceProfile kept = device->knowledge().profile();
    open(3, &dialectF);
    device->knowledge().setProfile(kept);
    VirtualCanLink master(*LinkAddress::parse("sim:can"), bus);
    ASSERT_TRUE(master.open());
    ASSERT_TRUE(master.send(*canFrameFromText("0CB#030040420F00")));
    clock.advance(5ms);
    powerCycle(unit, 1s);
    EXPECT_FALSE(device->parameters().entry(index("velocity.p")).raw);
    EXPECT_FALSE(device->parameters().entry(index("position.p")).raw);
}

/// Another run of the program, which each call of the console is: near 0 nothing shows that its power went.
TEST_F(AbstractDcRestart, IsNotTakenForGrantedByAnotherRunWhereTheMotorHasNotTurned)
{
    add("abstractdc:3");
    open(3, &dialectF);
    ASSERT_TRUE(write("velocity.p", 5));
    for (int run = 0; run < 2; ++run) {
        const DeviceProfile kept = device->knowledge().profile();
        device.reset();
        device = family.open(host, clock, identityOf(3, &dialectF));
        device->knowledge().setProfile(kept);
        clock.advance(500ms);
        EXPECT_EQ(device->parameters().entry(index("velocity.p")).raw, 5);
        EXPECT_EQ(device->parameters().entry(index("velocity.p")).state, ParameterState::Assumed);
    }
    host.close();
    clock.advance(3s);
    ASSERT_TRUE(host.open());
    clock.advance(2s);
    EXPECT_EQ(device->parameters().entry(index("velocity.p")).raw, 5) << "its line was gone";
}

/// Nobody saw it: the power went while this program did not run, or had no link.
TEST_F(AbstractDcRestart, TakesWhatWasNotSavedWhileThisProgramDidNotRun)
{
    Simulator &unit = add("abstractdc:3");
    open(3, &dialectF);
    ASSERT_TRUE(turnsAwayFromZero());
    ASSERT_TRUE(write("velocity.p", 5));
    const DeviceProfile kept = device->knowledge().profile();
    device.reset();
    powerCycle(unit, 1s);
    device = family.open(host, clock, identityOf(3, &dialectF));
    device->knowledge().setProfile(kept);
    clock.advance(500ms);
    EXPECT_FALSE(device->parameters().entry(index("velocity.p")).raw);
    EXPECT_TRUE(device->knowledge().profile().lost.contains("velocity.p"));
}

TEST_F(AbstractDcRestart, TakesWhatWasNotSavedWhileTheLinkWasGone)
{
    Simulator &unit = add("abstractdc:3");
    open(3, &dialectF);
    ASSERT_TRUE(turnsAwayFromZero());
    ASSERT_TRUE(write("velocity.p", 5));
    host.close();
    unit.setPowered(false);
    clock.advance(3s);
    unit.setPowered(true);
    ASSERT_TRUE(host.open());
    clock.advance(2s);
    ASSERT_TRUE(device->liveness().heard);
    EXPECT_FALSE(device->parameters().entry(index("velocity.p")).raw);
}

TEST_F(AbstractDcRestart, WhatWasNotSavedStaysWhereTheMotorStillStandsAsItDid)
{
    add("abstractdc:3");
    open(3, &dialectF);
    ASSERT_TRUE(turnsAwayFromZero());
    ASSERT_TRUE(write("velocity.p", 5));
    host.close();
    clock.advance(3s);
    ASSERT_TRUE(host.open());
    clock.advance(2s);
    ASSERT_TRUE(device->liveness().heard);
    EXPECT_EQ(device->parameters().entry(index("velocity.p")).raw, 5);
}

TEST_F(AbstractDcRestart, IsNoCableThatWasOut)
{
    add("abstractdc:3");
    open(3, &dialectF);
    ASSERT_TRUE(turnsAwayFromZero());
    ASSERT_TRUE(write("velocity.p", 5));
    bus.setLoss(1.0);
    clock.advance(2s);
    bus.setLoss(0.0);
    clock.advance(2s);
    ASSERT_TRUE(device->liveness().heard);
    EXPECT_FALSE(device->liveness().restarted);
    EXPECT_EQ(device->parameters().entry(index("velocity.p")).raw, 5);
}

TEST_F(AbstractDcController, AnOutputThatHadWrappedDoesNotEndTheNextRun)
{
    Simulator &drive = add("abstractdc:3,gains=default");
    open(3, &dialectF);
    drive.disturb("stall", 1.0);
    ASSERT_TRUE(write("velocity.i", 1'000'000));
    ASSERT_TRUE(write("velocity.divisor", 1'000'000));
    SetPointStream stream(*device, clock);
    ASSERT_TRUE(stream.start(setPoint(Mode::Velocity, 900.0), 10s));
    clock.advance(3s);
    ASSERT_EQ(stream.end(), SetPointStream::End::Refused);
    drive.disturb("stall", 0.0);
    ASSERT_TRUE(write("velocity.i", 0));
    ASSERT_TRUE(write("velocity.p", 100'000));
    ASSERT_TRUE(stream.start(setPoint(Mode::Velocity, 900.0), 10s));
    clock.advance(3s);
    EXPECT_TRUE(stream.isRunning()) << stream.reason().english();
    EXPECT_GT(drive.speed(), 10.0);
    stream.stop();
}

TEST_F(AbstractDcController, WhatAnotherMasterDrivesIsItsUntilItIsStopped)
{
    add("abstractdc:3");
    open(3, &dialectF);
    VirtualCanLink master(*LinkAddress::parse("sim:can"), bus);
    ASSERT_TRUE(master.open());
    ASSERT_TRUE(master.send(*canFrameFromText("067#0300000000"))); // stays where it is
    clock.advance(20s);
    EXPECT_TRUE(device->liveness().foreignMaster) << "it holds the shaft for ever";
    EXPECT_FALSE(device->mayMove());
    device->stop();
    clock.advance(3s);
    EXPECT_FALSE(device->liveness().foreignMaster);
    EXPECT_TRUE(device->mayMove());
}

TEST_F(AbstractDcController, WhatWasSentButNotAnsweredLeavesASettingUnknown)
{
    Simulator &drive = add("abstractdc:3");
    open(3, &dialectF);
    ASSERT_TRUE(write("velocity.p", 5));
    drive.setPowered(false);
    EXPECT_EQ(write("velocity.p", 6).error().fault, Fault::Timeout);
    EXPECT_FALSE(device->parameters().entry(index("velocity.p")).raw) << "5 or 6";
    EXPECT_EQ(device->parameters().entry(index("velocity.p")).state, ParameterState::Failed);
    EXPECT_TRUE(device->knowledge().profile().lost.contains("velocity.p"));
    EXPECT_EQ(write("velocity.divisor", 0).error().fault, Fault::OutOfRange);
    drive.setPowered(true);
    clock.advance(1s);
    ASSERT_TRUE(write("velocity.p", 6));
    EXPECT_EQ(device->parameters().entry(index("velocity.p")).raw, 6);
    host.close();
    EXPECT_EQ(write("velocity.p", 7).error().fault, Fault::LinkLost);
    EXPECT_EQ(device->parameters().entry(index("velocity.p")).raw, 6) << "nothing was sent";
}

/// Each time is a file on the disk.
TEST_F(AbstractDcRestart, KeepsWhereItStandsAndWhereItPassedOnce)
{
    add("abstractdc:3");
    open(3, &dialectF);
    int kept = 0;
    const Subscription keeping = device->knowledge().changed().add([&kept] { ++kept; });
    ASSERT_TRUE(turnsAwayFromZero());
    EXPECT_EQ(kept, 1);
    const auto &counters = device->knowledge().profile().counters;
    EXPECT_EQ(counters.at("place.position"), std::lround(latest("position")));
    EXPECT_TRUE(counters.contains("place.passed_ms"));
}

TEST_F(AbstractDcController, AWriteThatIsCutWhileASilentDriveIsWaitedForLeavesASettingUnknown)
{
    Simulator &drive = add("abstractdc:3");
    open(3, &dialectF);
    ASSERT_TRUE(write("velocity.p", 5));
    drive.setPowered(false);
    clock.advance(1s);
    DeviceProfile kept;
    const Subscription keeping = device->knowledge().changed().add([&] { kept = device->knowledge().profile(); });
    sent.clear();
    auto writing = device->write(index("velocity.p"), 6);
    writing.start();
    clock.advance(1ms);
    ASSERT_FALSE(writing.isFinished());
    ASSERT_FALSE(sentOf("0CB#").empty()) << "it may have come";
    writing.cancel();
    EXPECT_FALSE(device->parameters().entry(index("velocity.p")).raw) << "5 or 6";
    EXPECT_EQ(device->parameters().entry(index("velocity.p")).state, ParameterState::Failed);
    EXPECT_TRUE(kept.lost.contains("velocity.p"));
}

TEST_F(AbstractDcController, AWriteThatWasAnsweredIsNotDoubtedByItsEnd)
{
    add("abstractdc:3");
    open(3, &dialectF);
    {
        auto writing = device->write(index("velocity.p"), 6);
        writing.start();
        clock.advance(1s);
        ASSERT_TRUE(writing.isFinished());
    }
    {
        const auto neverBegun = device->write(index("velocity.p"), 7);
    }
    EXPECT_EQ(device->parameters().entry(index("velocity.p")).raw, 6);
    EXPECT_EQ(device->parameters().entry(index("velocity.p")).state, ParameterState::Assumed);
}

TEST_F(AbstractDcController, AWriteThatOutlivesItsDeviceEndsWithNothing)
{
    Simulator &drive = add("abstractdc:3");
    open(3, &dialectF);
    ASSERT_TRUE(write("velocity.p", 5));
    drive.setPowered(false);
    auto writing = device->write(index("velocity.p"), 6);
    writing.start();
    clock.advance(1ms);
    device.reset();
    writing.cancel();
    EXPECT_FALSE(writing.isValid());
}

TEST_F(AbstractDcController, ASaveThatWasNotAnsweredIsStillOwed)
{
    test::FakeUnit unit(bus, clock);
    unit.answer("387#01", {{"403#00000000"}});
    open(3, &dialectF);
    ASSERT_TRUE(write("velocity.p", 5));
    unit.answer("387#01", {{}});
    NoProgress progress;
    ASSERT_FALSE(test::run(clock, device->store(progress)));
    EXPECT_EQ(unit.count("0CB#01"), 1);
    unit.answer("387#01", {{"403#00000000"}});
    ASSERT_TRUE(test::run(clock, device->store(progress)));
    EXPECT_EQ(unit.count("0CB#01"), 2) << "the first may not have come";
    ASSERT_TRUE(test::run(clock, device->store(progress)));
    EXPECT_EQ(unit.count("0CB#01"), 2) << "saved";
}

TEST_F(AbstractDcController, WhatAnotherRunOfTheProgramDidNotSaveIsSaved)
{
    add("abstractdc:3");
    open(3, &dialectF);
    ASSERT_TRUE(write("velocity.p", 5));
    const DeviceProfile kept = device->knowledge().profile();
    open(3, &dialectF);
    device->knowledge().setProfile(kept);
    NoProgress progress;
    ASSERT_TRUE(test::run(clock, device->store(progress)));
    EXPECT_EQ(sentOf("0CB#01").size(), 1U);
    EXPECT_TRUE(happened("settings-saved"));
}

} // namespace
} // namespace mb::abstractdc
