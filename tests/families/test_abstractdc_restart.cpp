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
    void powerCycle(Simulator &drive)
    {
        drive.setPowered(false);
        clock.advance(1s);
        drive.setPowered(true);
        clock.advance(1s);
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
} // namespace
} // namespace mb::abstractdc
