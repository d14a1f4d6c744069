// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60ccontrollerfixture.h"

namespace mb::dmc60c {
namespace {

TEST_F(Dmc60cController, TurnsStatusFramesIntoSamplesWithTheTimeOfTheFrame)
{
    std::vector<Instant> times;
    const auto tap = host.received().add([&](const CanFrame &frame) { times.push_back(frame.time); });
    unit.send("02061485#01E240FED4000014"); // S8
    unit.send("020614C5#4C03FF3B00F6FF1B"); // S13
    unit.send(drivingHalf);
    clock.advance(5ms);
    EXPECT_EQ(latest("position"), 123456.0);
    EXPECT_EQ(latest("velocity"), -3000.0) << "counts/s, the wire has counts per 100 ms";
    EXPECT_EQ(latest("analog1"), 3.296875);
    EXPECT_EQ(latest("current"), 59.99609375);
    EXPECT_EQ(latest("temperature"), -10.0);
    EXPECT_EQ(latest("bus_voltage"), 27.99609375);
    EXPECT_DOUBLE_EQ(latest("duty"), 16384.0 / 32767.0);
    ASSERT_EQ(times.size(), 3U);
    const auto at = [&](const char *key) { return device->telemetry()->latest(channel(key))->time; };
    const std::vector<Instant> sampled{at("position"), at("current"), at("duty")};
    EXPECT_EQ(sampled, times);
}

TEST_F(Dmc60cController, NeverReportsMoreThanFullDuty)
{
    unit.send("02061405#00804BE32C000000"); // S7: −32768
    clock.advance(5ms);
    EXPECT_EQ(latest("duty"), -1.0);
}

TEST_F(Dmc60cController, GivesTheErrorInTheUnitOfTheMode)
{
    unit.send("02061405#0000110090FEFFFF"); // S3
    clock.advance(5ms);
    EXPECT_EQ(latest("error"), -512.0);
    unit.send("02061405#0020110018008001"); // S4
    clock.advance(5ms);
    EXPECT_EQ(latest("error"), 1.5);
    unit.send("02061405#00201100080A0000"); // velocity mode, 10 counts per 100 ms
    clock.advance(5ms);
    EXPECT_EQ(latest("error"), 100.0);
}

TEST_F(Dmc60cController, IgnoresFramesOfOtherUnits)
{
    unit.send("02061406#0040110000000000");
    unit.send("02061486#01E240FED4000014");
    clock.advance(5ms);
    EXPECT_FALSE(device->liveness().heard);
    EXPECT_FALSE(device->telemetry()->latest(channel("position")));
}

TEST_F(Dmc60cController, CountsMissingStatusFramesInEveryChannelOfTheFrame)
{
    unit.every(10ms, resting);
    clock.advance(205ms);
    unit.endPeriodic();
    clock.advance(25ms); // frames at 210, 220 and 230 are missing
    clock.advance(10ms);
    unit.every(10ms, resting);
    clock.advance(100ms);
    EXPECT_EQ(lost("duty"), 3U);
    EXPECT_EQ(lost("error"), 3U);
    EXPECT_EQ(lost("position"), 0U);
}

TEST_F(Dmc60cController, AsksTheDeviceBeforeItTakesALongerPeriodForLoss)
{
    unit.answer("02061805#34125C", {{"02061845#5CE803000000"}}); // the encoder frame comes every second
    unit.every(10ms, resting);
    unit.every(1s, "02061485#01E240FED4000014");
    clock.advance(4500ms);
    EXPECT_EQ(lost("position"), 0U);
    EXPECT_EQ(unit.count("02061805#34125C"), 1);
    device->telemetry()->commit();
    EXPECT_EQ(device->telemetry()->size(channel("position")), 5U);
}

TEST_F(Dmc60cController, IsLostAfterAHundredMillisecondsOfSilence)
{
    unit.answer("02061805#341233", {{"02061845#330000000000"}}); // else it is looked for already
    unit.every(10ms, resting);
    clock.advance(50ms);
    EXPECT_TRUE(device->liveness().heard);
    unit.endPeriodic();
    clock.advance(80ms);
    EXPECT_TRUE(device->liveness().heard);
    clock.advance(25ms);
    EXPECT_FALSE(device->liveness().heard);
    EXPECT_FALSE(device->liveness().mode);
    EXPECT_EQ(unit.count(enumeration), 1) << "it may sit in its bootloader";
    unit.send(resting);
    clock.advance(1ms);
    EXPECT_TRUE(device->liveness().heard);
}

TEST_F(Dmc60cController, WaitsFivePeriodsForASlowDevice)
{
    unit.send("02061845#5D3200000000"); // 50 ms, whoever asked
    unit.send(resting);
    clock.advance(240ms);
    EXPECT_TRUE(device->liveness().heard);
    clock.advance(20ms);
    EXPECT_FALSE(device->liveness().heard);
}

TEST_F(Dmc60cController, KeepsQuietWhileAnUpdateRuns)
{
    device->gate().setBusy(say("an update runs"));
    clock.advance(10s);
    unit.send("0206F005#CDAB03012060");
    clock.advance(1s);
    EXPECT_TRUE(unit.heard().empty());
    EXPECT_EQ(device->identity().session, 0x1234);
}

TEST_F(Dmc60cController, TellsModeMotionAndFaults)
{
    unit.send(drivingHalf);
    clock.advance(1ms);
    EXPECT_EQ(device->liveness().mode, Mode::Duty);
    EXPECT_TRUE(device->liveness().moving);
    EXPECT_TRUE(device->liveness().faults.empty());
    unit.send(idle); // S6
    clock.advance(1ms);
    EXPECT_EQ(device->liveness().mode, Mode::Off);
    EXPECT_FALSE(device->liveness().moving);
    EXPECT_EQ(device->liveness().faults, std::vector<std::string>{"under_voltage"});
    unit.send("02061485#01E240FED4000014");
    clock.advance(1ms);
    EXPECT_TRUE(device->liveness().moving) << "the shaft turns";
    unit.send("02061405#00804BE32C000000"); // S7
    clock.advance(1ms);
    EXPECT_EQ(device->liveness().mode, Mode::Follow);
    EXPECT_EQ(device->liveness().faults, std::vector<std::string>{"gate_driver"});
}

TEST_F(Dmc60cController, NotifiesOnlyWhenSomethingChanged)
{
    int notified = 0;
    const auto tap = device->changed().add([&] { ++notified; });
    unit.every(10ms, resting);
    clock.advance(500ms);
    EXPECT_EQ(notified, 1);
}

TEST_F(Dmc60cController, SeesAnotherMasterForHalfASecond)
{
    ASSERT_TRUE(command(Mode::Duty, 0.1));
    clock.advance(1ms);
    EXPECT_FALSE(device->liveness().foreignMaster) << "our own frames do not count";
    unit.send("02060005#0000000010270000");
    clock.advance(1ms);
    EXPECT_TRUE(device->liveness().foreignMaster);
    EXPECT_EQ(command(Mode::Duty, 0.1).error().fault, Fault::Unsafe);
    clock.advance(490ms);
    EXPECT_TRUE(device->liveness().foreignMaster);
    clock.advance(20ms);
    EXPECT_FALSE(device->liveness().foreignMaster);
    EXPECT_TRUE(command(Mode::Duty, 0.1));
}

TEST_F(Dmc60cController, WhatNoUnitTakesForAnOrderIsNoneOfAnotherMaster)
{
    for (const char *frame : {"02060005#", "02060005#00000000102700"}) {
        unit.send(frame);
        clock.advance(1ms);
        EXPECT_FALSE(device->liveness().foreignMaster) << frame << ": an order has eight bytes";
    }
}

TEST_F(Dmc60cController, IgnoresMastersOfOtherUnits)
{
    unit.send("02060006#0000000010270000");
    clock.advance(1ms);
    EXPECT_FALSE(device->liveness().foreignMaster);
}

TEST_F(Dmc60cController, AdoptsTheSessionOfARestartedUnit)
{
    unit.answer(enumeration, {{"0206F005#CDAB03012060", "0206F005#CDAB000019010901"}}, 5ms);
    unit.send("0206F005#CDAB03012060");
    clock.advance(1s);
    EXPECT_EQ(device->identity().session, 0xABCD);
    EXPECT_EQ(device->identity().state, DeviceState::Online);
    EXPECT_TRUE(device->liveness().restarted);
    EXPECT_EQ(device->identity().firmware, "1.25");
    unit.answer("02061805#CDAB3D", {{"02061845#3D0000280000"}});
    EXPECT_TRUE(run(device->read(index("current_limit.continuous")))) << "it talks to the new session";
}

TEST_F(Dmc60cController, BecomesADuplicateWhenBothSessionsAnswer)
{
    unit.answer(enumeration, {{}, {"0206F005#341203012060", "0206F005#3412000017010901"}}, 5ms);
    unit.send("0206F005#CDAB03012060");
    clock.advance(1s);
    EXPECT_EQ(device->identity().session, 0x1234);
    EXPECT_EQ(device->identity().state, DeviceState::Duplicate);
    EXPECT_FALSE(device->liveness().restarted);
    EXPECT_EQ(command(Mode::Duty, 0.1).error().fault, Fault::Unsafe);
}

TEST_F(Dmc60cController, NoticesARestartAndForgetsWhatWasRead)
{
    unit.answer("02061805#34123D", {{"02061845#3D0000280000"}});
    (void)run(device->read(index("current_limit.continuous")));
    unit.send("0206FCC5#07000000"); // V19
    clock.advance(1ms);
    EXPECT_TRUE(device->liveness().restarted);
    EXPECT_EQ(device->parameters().entry(index("current_limit.continuous")).state, ParameterState::Unknown);
}

TEST_F(Dmc60cController, NoticesThatASilentUnitSitsInItsBootloader)
{
    unit.answer(enumeration, {{"0206F005#341203012060", "0206F005#34120100FFFF0901"}}, 5ms);
    unit.send(resting);
    clock.advance(1s);
    EXPECT_EQ(device->identity().state, DeviceState::Bootloader);
    EXPECT_EQ(device->identity().firmware, "");
    EXPECT_EQ(command(Mode::Duty, 0.1).error().fault, Fault::Unsafe);
}

TEST_F(Dmc60cController, RefreshesIdentityAndEndsTheRestart)
{
    unit.answer(getVersions, {versionsReply});
    unit.answer(getDescriptors, {descriptors});
    unit.send("0206FCC5#07000000");
    clock.advance(1ms);
    ASSERT_TRUE(run(device->refresh()));
    EXPECT_FALSE(device->liveness().restarted);
    EXPECT_EQ(device->identity().name, "DMC60C");
    EXPECT_EQ(device->identity().serial, "2103343A79F2");
    EXPECT_EQ(device->identity().firmware, "1.23");
    EXPECT_EQ(device->identity().state, DeviceState::Online);
}

TEST_F(Dmc60cController, RefreshFindsTheNewSessionOfAUnitThatDoesNotAnswer)
{
    unit.answer(enumeration, {{"0206F005#CDAB03012060", "0206F005#CDAB000017010901"}}, 5ms);
    unit.answer("0206FC05#CDAB610000000000", {versionsReply});
    unit.answer("0206FC05#CDAB600000000000", {descriptors});
    ASSERT_TRUE(run(device->refresh()));
    EXPECT_EQ(device->identity().session, 0xABCD);
    EXPECT_FALSE(device->liveness().restarted);
}

TEST_F(Dmc60cController, RefreshSaysTimeoutWhenNobodyIsThere)
{
    EXPECT_EQ(run(device->refresh()).error().fault, Fault::Timeout);
    EXPECT_EQ(unit.count(getVersions), 8);
}

} // namespace
} // namespace mb::dmc60c
