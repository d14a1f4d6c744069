// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/setpoints.h"
#include "families/dmc60ccontrollerfixture.h"

#include <algorithm>

namespace mb::dmc60c {
namespace {

struct Commanded {
    const char *name;
    SetPoint setPoint;
    const char *frame;
};

SetPoint make(Mode mode, double target, double ramp = 0.0)
{
    SetPoint s;
    s.mode = mode;
    s.target = target;
    s.ramp = ramp;
    return s;
}

std::vector<Commanded> commands()
{
    SetPoint slot1 = make(Mode::Position, 123456);
    slot1.slot = 1;
    slot1.reverseSensor = true;
    SetPoint brake = make(Mode::Duty, 0);
    brake.brake = true;
    SetPoint coast = make(Mode::Duty, 0);
    coast.brake = false;
    SetPoint limits = make(Mode::Duty, 0);
    limits.overrideLimits = limits.disableForwardLimit = limits.disableReverseLimit = true;
    SetPoint follow = make(Mode::Follow, 9);
    follow.reverseMotor = true;
    follow.reverseSensor = true; // has no effect there
    return {
        {"C3 a little over half reverse", make(Mode::Duty, -16384.0 / 32767.0), "02060005#000000FF00C00000"},
        {"C4 full forward is 32767", make(Mode::Duty, 1.0), "02060005#00000000FF7F0000"},
        {"full reverse is -32767", make(Mode::Duty, -1.0), "02060005#000000FF01800000"},
        {"C6 ramp in duty per second", make(Mode::Duty, 10000.0 / 32767.0, 2500.0 * 2000.0 / 32767.0),
            "02060005#000000001027C409"},
        {"the slowest ramp is 1, not none", make(Mode::Duty, 0.0, 1e-6), "02060005#0000000000000100"},
        {"the fastest ramp is the field's end", make(Mode::Duty, 0.0, 1e9), "02060005#000000000000FFFF"},
        {"C7 102400 counts/s", make(Mode::Velocity, 102400), "02060005#0100000000280000"},
        {"C9 133.3 counts/s rounded", make(Mode::Velocity, 133.3333), "02060005#010000000D000000"},
        {"C10", make(Mode::Position, 123456), "02060005#0200000140E20000"},
        {"C12 without a ramp, which is the slot's", slot1, "02060005#C200000140E20000"},
        {"C13", make(Mode::Current, 12.5), "02060005#0300000C00800000"},
        {"C15", make(Mode::Voltage, 6.0, 1024.0 * 2000.0 / 32767.0), "02060005#0400000600000004"},
        {"C16", make(Mode::Voltage, -12.0), "02060005#040000F400000000"},
        {"C18", brake, "02060005#3000000000000000"},
        {"C19", coast, "02060005#1000000000000000"},
        {"C21", limits, "02060005#000E000000000000"},
        {"follower, motor reversed", follow, "02060005#0501000009000000"},
    };
}

TEST_F(Dmc60cController, SendsTheGoldenControlFrames)
{
    for (const Commanded &row : commands()) {
        ASSERT_TRUE(device->command(row.setPoint)) << row.name;
        clock.advance(1ms);
        EXPECT_EQ(unit.heard().back(), row.frame) << row.name;
        EXPECT_EQ(latest("setpoint"), row.setPoint.target) << row.name;
    }
}

/// dmc60c/README.md#stopping
TEST_F(Dmc60cController, ATargetOfZeroIsPrecededByTheLeastThereIsThreeTimesAfterEachHalt)
{
    const std::string least = "02060005#0000000001000000";
    const std::string zero = "02060005#0000000000000000";
    for (int halts = 1; halts <= 2; ++halts) {
        for (int n = 0; n < 5; ++n) {
            ASSERT_TRUE(command(Mode::Duty, 0.0));
            clock.advance(20ms);
        }
        EXPECT_EQ(unit.count(least), 3 * halts);
        EXPECT_EQ(unit.count(zero), 5 * halts);
        clock.advance(200ms);
    }
}

TEST_F(Dmc60cController, SendsNothingForASetPointItRefuses)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    SetPoint slot2 = make(Mode::Velocity, 1);
    slot2.slot = 2;
    SetPoint axis2 = make(Mode::Velocity, 1);
    axis2.axis = 2;
    const std::vector<std::pair<SetPoint, Fault>> rows{{make(Mode::Duty, 1.0001), Fault::OutOfRange},
        {make(Mode::Duty, -1.0001), Fault::OutOfRange}, {make(Mode::Duty, nan), Fault::OutOfRange},
        {make(Mode::Velocity, infinite), Fault::OutOfRange}, {make(Mode::Velocity, 83886080), Fault::OutOfRange},
        {make(Mode::Position, 8388608), Fault::OutOfRange}, {make(Mode::Position, -8388609), Fault::OutOfRange},
        {make(Mode::Current, 100.1), Fault::OutOfRange}, {make(Mode::Voltage, -28.1), Fault::OutOfRange},
        {make(Mode::Follow, 5), Fault::OutOfRange}, {make(Mode::Follow, 0), Fault::OutOfRange},
        {make(Mode::Follow, 64), Fault::OutOfRange}, {make(Mode::Follow, 9.5), Fault::OutOfRange},
        {make(Mode::Duty, 0.1, -1.0), Fault::OutOfRange}, {make(Mode::Duty, 0.1, nan), Fault::OutOfRange},
        {make(Mode::RampPosition, 1), Fault::Unsupported}, {make(Mode::RampVelocity, 1), Fault::Unsupported},
        {slot2, Fault::Unsupported}, {axis2, Fault::Unsupported}};
    for (const auto &[refused, fault] : rows) {
        const auto result = device->command(refused);
        ASSERT_FALSE(result) << toString(refused.mode) << ' ' << refused.target;
        EXPECT_EQ(result.error().fault, fault) << result.error().text();
        EXPECT_FALSE(device->check(refused));
    }
    clock.advance(10ms);
    EXPECT_TRUE(unit.heard().empty());
}

TEST_F(Dmc60cController, StopsBeforeEverythingThatWaitsAndLetsNoSetPointFollow)
{
    const std::string stop = "02060005#0F00000000000000"; // C1
    for (int n = 0; n < 20; ++n) {
        ASSERT_TRUE(host.send(extendedFrame(0x00000100U, {1, 2, 3, 4, 5, 6, 7, 8})));
        ASSERT_TRUE(command(Mode::Duty, 0.5));
    }
    clock.advance(10us); // the first is on the wire
    device->stop();
    clock.advance(20ms);
    ASSERT_GE(unit.heard().size(), 3U);
    EXPECT_EQ(unit.heard()[1], stop);
    EXPECT_EQ(unit.count(stop), 2);
    const auto last = std::find_if(unit.heard().rbegin(), unit.heard().rend(),
        [](const std::string &text) { return text.starts_with("02060005"); });
    EXPECT_EQ(*last, stop) << "a set-point that comes after the stop would drive again";
}

/// Without the override a unit returns to its button (6.1), which may say coast.
TEST_F(Dmc60cController, AStopBrakesWhereTheLastSetPointOverrodeTheButtonToBrake)
{
    const std::string braked = "02060005#3F00000000000000";
    SetPoint setPoint;
    setPoint.mode = Mode::Duty;
    setPoint.target = 0.5;
    setPoint.brake = true;
    ASSERT_TRUE(device->command(setPoint));
    const StopScript script = device->stopScript();
    ASSERT_EQ(script.steps.size(), 1U);
    EXPECT_EQ(toText(*script.steps.front().frame), braked) << "and what stops it from outside";
    for (int told = 1; told <= 2; ++told) {
        device->stop();
        clock.advance(20ms);
        EXPECT_EQ(unit.count(braked), 2 * told);
    }
    setPoint.brake = false;
    ASSERT_TRUE(device->command(setPoint));
    device->stop();
    clock.advance(20ms);
    EXPECT_EQ(unit.count("02060005#0F00000000000000"), 2) << "what was to coast is left to the button";
}

TEST_F(Dmc60cController, SendsTheStopForAnOffSetPointAndForADuplicate)
{
    EXPECT_TRUE(command(Mode::Off, 0));
    clock.advance(1ms);
    EXPECT_EQ(unit.count("02060005#0F00000000000000"), 2);
    Identity duplicate = device->identity();
    duplicate.state = DeviceState::Duplicate;
    device->setIdentity(duplicate);
    device->stop();
    clock.advance(1ms);
    EXPECT_EQ(unit.count("02060005#0F00000000000000"), 4) << "stopping is always allowed";
}

TEST(Dmc60cSetPoints, OffIsNeverRefusedAndCarriesNoTarget)
{
    for (const double target : {0.0, 0.5, -0.5, 1e9}) {
        const auto control = controlFor(make(Mode::Off, target), 5);
        ASSERT_TRUE(control) << target;
        EXPECT_EQ(control->mode, ControlMode::NoDrive);
        EXPECT_EQ(control->target, 0);
    }
}

TEST_F(Dmc60cController, IsSeenStoppedOnlyByYoungerFramesWithoutOutput)
{
    unit.send(resting);
    clock.advance(1ms);
    device->stop();
    EXPECT_FALSE(device->isSeenStopped()) << "the frame is older than the stop";
    clock.advance(1ms);
    unit.send(drivingHalf);
    clock.advance(1ms);
    EXPECT_FALSE(device->isSeenStopped());
    unit.send("02061405#0000110008000000"); // velocity mode, output crosses zero
    clock.advance(1ms);
    EXPECT_FALSE(device->isSeenStopped());
    unit.send("02061405#0000110008000000");
    clock.advance(1ms);
    EXPECT_TRUE(device->isSeenStopped());
    device->stop();
    clock.advance(1ms);
    unit.send(resting);
    clock.advance(1ms);
    EXPECT_TRUE(device->isSeenStopped()) << "no drive and no output";
}

} // namespace
} // namespace mb::dmc60c
