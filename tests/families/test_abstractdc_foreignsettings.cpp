// SPDX-License-Identifier: GPL-3.0-or-later
// What others on the bus drive, write and save, and a motor that turns though nobody here drives it.
#include "abstractdccontrollerbench.h"

namespace mb::abstractdc {
namespace {

struct AbstractDcForeign : AbstractDcController {
    AbstractDcForeign() { EXPECT_TRUE(m_master.open()); }
    void others(const char *text)
    {
        ASSERT_TRUE(m_master.send(*canFrameFromText(text)));
        clock.advance(5ms);
    }
    std::int64_t counter(const std::string &key) const
    {
        const auto &counters = device->knowledge().profile().counters;
        const auto found = counters.find(key);
        return found == counters.end() ? 0 : found->second;
    }

private:
    VirtualCanLink m_master{*LinkAddress::parse("sim:can"), bus};
};

TEST_F(AbstractDcForeign, AnAveragingThatAnotherMasterRaisedIsLoweredOnlyAtAStandstill)
{
    Simulator &drive = add("abstractdc:3");
    add("abstractdc:10");
    open(3, &dialectF);
    ASSERT_TRUE(turnsAwayFromZero());
    ASSERT_TRUE(write("current.averaging", 10));
    powerCycle(drive, 500ms);
    ASSERT_TRUE(device->mayMove());
    others("0CB#0204F4010000"); // 500
    EXPECT_TRUE(device->mayMove()) << "raised, it owes nothing";
    clock.advance(3s);
    ASSERT_TRUE(device->command(setPoint(Mode::Duty, 0.1)));
    EXPECT_EQ(write("current.averaging", 60).error().fault, Fault::Unsafe);
    device->stop();
    clock.advance(10s);
    EXPECT_FALSE(happened("memory-overrun"));
}

TEST_F(AbstractDcForeign, AnAveragingThatAnotherMasterLoweredOwesAPowerCycle)
{
    Simulator &drive = add("abstractdc:3");
    add("abstractdc:10");
    open(3, &dialectF);
    ASSERT_TRUE(turnsAwayFromZero());
    ASSERT_TRUE(write("current.averaging", 500));
    others("0D2#02040A000000"); // of the other drive
    EXPECT_TRUE(device->mayMove());
    others("0CB#02040A000000");
    EXPECT_FALSE(device->mayMove());
    others("0CB#02");
    powerCycle(drive, 500ms);
    EXPECT_TRUE(device->mayMove());
}

/// What a drive has loaded from its flash nobody can ask, so that any value but the greatest may be a lower one.
TEST_F(AbstractDcForeign, AFirstAveragingOfAnotherMasterOwesAPowerCycleUnlessItIsTheGreatestAndSaysSo)
{
    add("abstractdc:3");
    open(3, &dialectF);
    others("0CB#0204F4010000"); // 500
    EXPECT_TRUE(device->mayMove());
    EXPECT_TRUE(device->liveness().faults.empty());
    open(3, &dialectF);
    others("0CB#020432000000"); // 50
    EXPECT_FALSE(device->mayMove());
    EXPECT_EQ(device->liveness().faults, std::vector<std::string>{"power_cycle_owed"});
}

TEST_F(AbstractDcForeign, AnAveragingBeyondTheBufferThatAnotherMasterWroteOwesOneToo)
{
    Simulator &drive = add("abstractdc:3");
    open(3, &dialectF);
    ASSERT_TRUE(turnsAwayFromZero());
    others("0CB#0204E8030000"); // 1000
    EXPECT_FALSE(device->mayMove());
    powerCycle(drive, 500ms);
    EXPECT_TRUE(device->mayMove()) << "it was not saved";
    ASSERT_TRUE(turnsAwayFromZero());
    others("0CB#0204E8030000");
    others("0CB#02");
    powerCycle(drive, 500ms);
    EXPECT_NE(device->mayMove().error().remedy.english().find("write an averaging"), std::string::npos)
        << "it has loaded the same";
    ASSERT_TRUE(write("current.averaging", 100));
    powerCycle(drive, 500ms);
    EXPECT_FALSE(device->mayMove()) << "it stood near 0: nothing shows that it was off";
    EXPECT_EQ(device->mayMove().error().remedy.english().find("write an averaging"), std::string::npos);
}

TEST_F(AbstractDcForeign, WhatAnotherMasterHoldsIsItsAfterAGapOfTheBusToo)
{
    add("abstractdc:3");
    open(3, &dialectF);
    others("067#0300000000");
    clock.advance(3s);
    bus.setLoss(1.0);
    clock.advance(300ms);
    ASSERT_FALSE(device->liveness().heard);
    bus.setLoss(0.0);
    clock.advance(3s);
    ASSERT_TRUE(device->liveness().heard);
    EXPECT_TRUE(device->liveness().foreignMaster);
    EXPECT_FALSE(device->mayMove());
    others("067#0000000000");
    clock.advance(3s);
    EXPECT_FALSE(device->liveness().foreignMaster);
    EXPECT_TRUE(device->mayMove());
}

TEST_F(AbstractDcForeign, WhatAnotherMasterHeldIsOffAfterARestartOfTheDrive)
{
    Simulator &drive = add("abstractdc:3");
    open(3, &dialectF);
    ASSERT_TRUE(turnsAwayFromZero());
    others("067#03E8030000");
    powerCycle(drive, 500ms);
    clock.advance(3s);
    ASSERT_TRUE(device->liveness().heard);
    EXPECT_FALSE(device->liveness().foreignMaster);
    EXPECT_TRUE(device->mayMove());
}

TEST_F(AbstractDcForeign, SavesOfAnotherMasterAreCountedToo)
{
    add("abstractdc:3");
    add("abstractdc:10");
    open(3, &dialectF);
    ASSERT_TRUE(write("velocity.p", 5));
    EXPECT_EQ(counter("unsaved.velocity.p"), 1);
    for (int i = 0; i < 50; ++i)
        others("0CB#01");
    others("0D2#01"); // another drive
    others("0CB#02");
    EXPECT_EQ(counter("saves.velocity"), 50);
    EXPECT_EQ(counter("saves.current"), 1);
    EXPECT_EQ(counter("unsaved.velocity.p"), 0);
    ASSERT_TRUE(write("velocity.p", 6));
    NoProgress progress;
    EXPECT_EQ(test::run(clock, device->store(progress)).error().fault, Fault::Unsafe);
}

TEST_F(AbstractDcForeign, AnotherDriveInItsPlaceHasNothingThatIsNotSavedAndWasNeverSaved)
{
    add("abstractdc:3");
    open(3, &dialectF);
    others("0CB#02");
    ASSERT_TRUE(write("velocity.p", 5));
    EXPECT_EQ(counter("unsaved.velocity.p"), 1);
    EXPECT_EQ(counter("saves.current"), 1);
    device->knowledge().unitExchanged();
    EXPECT_EQ(counter("unsaved.velocity.p"), 0);
    EXPECT_EQ(counter("saves.current"), 0);
}

/// A host that is gone before this one came.
TEST_F(AbstractDcForeign, NeitherADivisorIsWrittenNorAnythingSavedWhileAMotorTurnsThatSomebodyMayDrive)
{
    add("abstractdc:3");
    for (const char *gains : {"0CB#010040420F00", "0CB#010340420F00", "067#04F4010000"})
        others(gains);
    clock.advance(3s);
    open(3, &dialectF);
    ASSERT_TRUE(device->liveness().moving);
    ASSERT_FALSE(device->liveness().mode);
    EXPECT_EQ(write("velocity.divisor", 1).error().fault, Fault::Unsafe);
    EXPECT_TRUE(sentOf("0CB").empty());
    ASSERT_TRUE(write("velocity.p", 1'000'000));
    NoProgress progress;
    EXPECT_EQ(test::run(clock, device->store(progress)).error().fault, Fault::Unsafe);
    device->stop();
    clock.advance(20s);
    EXPECT_TRUE(test::run(clock, device->store(progress)));
    EXPECT_TRUE(write("velocity.divisor", 1'000'000));
}

TEST_F(AbstractDcForeign, AnAveragingThatCouldNotBeSavedIsNotLowered)
{
    add("abstractdc:3");
    open(3, &dialectF);
    ASSERT_TRUE(turnsAwayFromZero());
    ASSERT_TRUE(write("current.averaging", 500));
    device->knowledge().setCounters({{"saves.current", 50}});
    sent.clear();
    EXPECT_EQ(write("current.averaging", 10).error().fault, Fault::Unsafe);
    EXPECT_TRUE(sentOf("0CB").empty());
    EXPECT_EQ(device->parameters().entry(index("current.averaging")).raw, 500);
    EXPECT_TRUE(device->mayMove());
}

} // namespace
} // namespace mb::abstractdc
