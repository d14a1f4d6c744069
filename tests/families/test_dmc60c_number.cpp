// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60ccontrollerfixture.h"

namespace mb::dmc60c {
namespace {

TEST_F(Dmc60cController, Blinks)
{
    unit.answer("0206FC05#3412500000000000", {{"0206FCC5#00000000"}});
    EXPECT_TRUE(run(device->identify()));
    unit.answer("0206FC05#3412500000000000", {{"0206FCC5#01000000"}});
    EXPECT_EQ(run(device->identify()).error().fault, Fault::Unsupported) << "the bootloader cannot";
}

TEST_F(Dmc60cController, RenamesWithTheNulCountedAndReadsTheNameBack)
{
    unit.answer("0206FC45#41726D00", {{"0206FCC5#00000000"}}); // V9; the status comes after the last byte
    unit.answer(getDescriptors, {{"0206FCC5#00000500", "0206FC85#010341726D"}});
    ASSERT_TRUE(run(device->rename("Arm")));
    EXPECT_EQ(unit.heard().front(), "0206FC05#3412020004000000");
    EXPECT_EQ(device->identity().name, "Arm");
}

TEST_F(Dmc60cController, FailsWhenAnotherNameComesBack)
{
    unit.answer("0206FC45#41726D00", {{"0206FCC5#00000000"}});
    unit.answer(getDescriptors, {{"0206FCC5#00000400", "0206FC85#01024172"}});
    EXPECT_EQ(run(device->rename("Arm")).error().fault, Fault::BadCheck);
}

TEST_F(Dmc60cController, ALateAnswerToANewNameIsNotTakenForTheDescriptors)
{
    unit.answer(
        "0206FC45#41726D00", {{"0206FCC5#00000000", "0206FCC5#00000000"}}); // the second is that to an earlier try
    unit.answer(getDescriptors, {{"0206FCC5#00000500", "0206FC85#010341726D"}}, 2ms);
    const auto named = run(device->rename("Arm"));
    EXPECT_TRUE(named) << named.error().text();
    EXPECT_EQ(device->identity().name, "Arm");
}

TEST_F(Dmc60cController, RefusesNamesThatDoNotFit)
{
    EXPECT_EQ(run(device->rename("")).error().fault, Fault::OutOfRange);
    EXPECT_EQ(run(device->rename(std::string(65, 'x'))).error().fault, Fault::OutOfRange);
    EXPECT_EQ(run(device->rename("\xE2\x82\xAC")).error().fault, Fault::OutOfRange);
    EXPECT_TRUE(unit.heard().empty());
}

const std::string setNumber7 = "0206FC05#3412010007000000";

TEST_F(Dmc60cController, RenumbersWithTheStatusFromTheNewNumber)
{
    unit.answer(setNumber7, {{"0206FCC7#00000000"}});
    unit.answer("0206FC07#3412610000000000", {{"0206FCC7#00000600", "0206FC87#000017010901"}});
    ASSERT_TRUE(run(device->renumber(7)));
    EXPECT_EQ(device->identity().address, 7);
    unit.send("02061407#0040110000000000");
    clock.advance(1ms);
    EXPECT_TRUE(device->liveness().heard);
    EXPECT_EQ(unit.count(setNumber7), 1);
}

TEST_F(Dmc60cController, KeepsItsNumberWhenTheOldOneRefuses)
{
    unit.answer(setNumber7, {{"0206FCC5#02000000"}}); // V3
    const auto result = run(device->renumber(7));
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().fault, Fault::Refused);
    EXPECT_EQ(device->identity().address, 5);
}

TEST_F(Dmc60cController, FindsTheUnitAtItsNewNumberWhenTheStatusIsLost)
{
    unit.answer("0206FC07#3412610000000000", {{"0206FCC7#00000600", "0206FC87#000017010901"}});
    ASSERT_TRUE(run(device->renumber(7)));
    EXPECT_EQ(device->identity().address, 7);
    EXPECT_EQ(unit.count(setNumber7), 1) << "it would not hear a second one";
}

TEST_F(Dmc60cController, DoesNotMoveToANumberThatIsTaken)
{
    unit.answer(enumeration, {{"0206F007#010003012060"}}, 7ms);
    EXPECT_EQ(run(device->renumber(7)).error().fault, Fault::Refused);
    EXPECT_EQ(unit.count(setNumber7), 0);
    EXPECT_EQ(run(device->renumber(0)).error().fault, Fault::OutOfRange);
    EXPECT_EQ(run(device->renumber(64)).error().fault, Fault::OutOfRange);
}

TEST_F(Dmc60cController, ANumberFromWhichStatusFramesComeIsNotFree)
{
    unit.every(10ms, "02061407#0000110078000000");
    EXPECT_EQ(run(device->renumber(7)).error().fault, Fault::Refused) << "its answers to the enumeration are lost";
    EXPECT_EQ(unit.count(setNumber7), 0);
}

TEST_F(Dmc60cController, ANumberIsAskedForThreeTimesBeforeItCountsAsFree)
{
    unit.answer(enumeration, {{}, {}, {"0206F007#010003012060"}}, 7ms);
    EXPECT_EQ(run(device->renumber(7)).error().fault, Fault::Refused) << "the first answers may be lost";
    EXPECT_EQ(unit.count(enumeration), 3);
    EXPECT_EQ(unit.count(setNumber7), 0);
}

TEST_F(Dmc60cController, MovesToTheFirstNumberAndToTheLast)
{
    for (const auto &[number, order] : {std::pair{1, "0206FC05#3412010001000000"}, {63, "0206FC05#341201003F000000"}}) {
        EXPECT_FALSE(run(device->renumber(number))) << "nobody answers there";
        EXPECT_GE(unit.count(order), 1) << number;
    }
    EXPECT_TRUE(run(device->renumber(5))) << "it has that one";
}

TEST_F(Dmc60cController, AnAssignedUnitMayMove)
{
    Identity unassigned = identityOf5();
    unassigned.address = 0;
    unassigned.state = DeviceState::Unassigned;
    device = family.open(host, clock, unassigned);
    unit.answer("0206FC00#3412010007000000", {{"0206FCC7#00000000"}});
    unit.answer("0206FC07#3412610000000000", {{"0206FCC7#00000600", "0206FC87#000017010901"}});
    EXPECT_FALSE(device->mayMove());
    ASSERT_TRUE(run(device->renumber(7)));
    EXPECT_EQ(device->identity().state, DeviceState::Online);
    EXPECT_TRUE(device->mayMove());
}

TEST_F(Dmc60cController, SetsARateAndPutsItBack)
{
    unit.answer("02061805#34125C", {{"02061845#5C6400000000"}});
    unit.answer("02061885#34125C0A000000", {{"02061845#5C0A00000000"}});
    unit.answer("02061885#34125C64000000", {{"02061845#5C6400000000"}});
    ASSERT_TRUE(run(device->setRate(channel("velocity"), 100.0)));
    EXPECT_EQ(unit.heard().back(), "02061885#34125C0A000000");
    ASSERT_TRUE(run(device->setRate(channel("velocity"), 0.0)));
    EXPECT_EQ(unit.heard().back(), "02061885#34125C64000000");
    const std::size_t before = unit.heard().size();
    ASSERT_TRUE(run(device->setRate(channel("velocity"), 0.0)));
    EXPECT_EQ(unit.heard().size(), before) << "there is nothing to put back";
}

TEST_F(Dmc60cController, MapsChannelsToTheirFramesAndKeepsTheLegalPeriods)
{
    unit.answer("02061805#34125D", {{"02061845#5D0A00000000"}});
    unit.answer("02061885#34125D32000000", {{"02061845#5D3200000000"}});
    ASSERT_TRUE(run(device->setRate(channel("duty"), 1.0))) << "50 ms is the longest";
    unit.answer("02061805#34125B", {{"02061845#5B6400000000"}});
    unit.answer("02061885#34125B01000000", {{"02061845#5B0100000000"}});
    ASSERT_TRUE(run(device->setRate(channel("current"), 5000.0))) << "1 ms is the shortest";
    EXPECT_EQ(run(device->setRate(channel("setpoint"), 10.0)).error().fault, Fault::Unsupported);
    EXPECT_EQ(run(device->setRate(channel("duty"), -1.0)).error().fault, Fault::OutOfRange);
}

TEST_F(Dmc60cController, AsksForItsRateAgainAfterARestart)
{
    unit.answer("02061805#34125C", {{"02061845#5C6400000000"}});
    unit.answer("02061885#34125C0A000000", {{"02061845#5C0A00000000"}});
    ASSERT_TRUE(run(device->setRate(channel("velocity"), 100.0)));
    unit.send("0206FCC5#07000000");
    clock.advance(5ms);
    EXPECT_EQ(unit.count("02061885#34125C0A000000"), 2);
}

TEST_F(Dmc60cController, AsksForItsRateAgainAfterAnUpdateWhetherItsResetWasAnsweredOrNot)
{
    const std::string ten = "02061885#34125C0A000000";
    FakeUnit second(bus, clock);
    unit.answer("02061805#34125C", {{"02061845#5C6400000000"}});
    unit.answer(ten, {{"02061845#5C0A00000000"}});
    ASSERT_TRUE(run(device->setRate(channel("velocity"), 100.0)));
    for (const bool answered : {true, false}) {
        const int before = unit.count(ten);
        device->gate().setBusy(say("an update runs"));
        unit.send("0206FCC5#04000000");
        clock.advance(1s);
        if (answered)
            unit.send("0206FCC5#07000000");
        unit.send(resting);
        second.send("02061406#000011007A000000");
        clock.advance(50ms);
        EXPECT_EQ(unit.count(ten), before) << "the update talks alone";
        device->gate().setBusy({});
        second.send("02061406#000011007A000000");
        clock.advance(5ms);
        EXPECT_EQ(unit.count(ten), before) << "another unit";
        unit.send(resting);
        clock.advance(5ms);
        EXPECT_EQ(unit.count(ten), before + 1);
        unit.send(resting);
        clock.advance(5ms);
        EXPECT_EQ(unit.count(ten), before + 1) << "once";
    }
}

} // namespace
} // namespace mb::dmc60c
