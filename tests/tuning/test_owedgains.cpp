// SPDX-License-Identifier: GPL-3.0-or-later
// What an experiment owes to a real unit that stores by itself, later: a DMC60C on a CAN interface, in virtual time.
#include "tests/tuning/realunit.h"

namespace mb::tuning {
namespace {

using namespace std::chrono_literals;
using test::RealUnit;
using test::run;

TEST(OwedGains, OfAUnitThatStoresLaterCountAsPutBackWhenItsFlashSaysSo)
{
    RealUnit unit;
    ASSERT_TRUE(storesLater(*unit.device));
    unit.tryAndPutBack(3s);
    EXPECT_EQ(unit.askedAbout(), 0U) << "it has them";
    EXPECT_EQ(unit.journal.owed.size(), 1U) << "but not for good";
    unit.clock.advance(storingTime(*unit.device));
    EXPECT_EQ(unit.askedAbout(), 0U);
    EXPECT_TRUE(unit.journal.owed.empty());
    unit.losePower();
    EXPECT_EQ(*run(unit.clock, unit.device->read(unit.gain)), unit.before);
}

TEST(OwedGains, AreAskedForWhenThePowerWentBeforeTheyWereStored)
{
    RealUnit unit;
    unit.tryAndPutBack(3s);
    EXPECT_EQ(unit.askedAbout(), 0U);
    unit.losePower();
    EXPECT_EQ(*run(unit.clock, unit.device->read(unit.gain)), unit.before / 2) << "its flash had what was tried";
    EXPECT_EQ(unit.askedAbout(), 1U);
    ASSERT_TRUE(run(unit.clock, payOwed(*unit.device, unit.journal, {1, 0.0, unit.journal.owed})));
    unit.clock.advance(storingTime(*unit.device));
    EXPECT_EQ(unit.askedAbout(), 0U);
    EXPECT_EQ(unit.journal.owed.size(), 1U) << "the device tells once that it restarted before it had stored";
    EXPECT_EQ(unit.askedAbout(), 0U);
    EXPECT_TRUE(unit.journal.owed.empty());
    unit.losePower();
    EXPECT_EQ(*run(unit.clock, unit.device->read(unit.gain)), unit.before);
}

TEST(OwedGains, OfWhatSomebodyHasWrittenSinceTheyWerePutBackAreOwedNoMore)
{
    RealUnit unit;
    unit.tryAndPutBack(3s);
    ASSERT_TRUE(run(unit.clock, writeGains(*unit.device, {{unit.gain, unit.before + 1000}})));
    EXPECT_EQ(unit.askedAbout(), 0U);
    EXPECT_TRUE(unit.journal.owed.empty());
    EXPECT_EQ(*run(unit.clock, unit.device->read(unit.gain)), unit.before + 1000);
}

TEST(OwedGains, ThatWereNeverPutBackAreAskedForWhateverTheUnitHas)
{
    RealUnit unit;
    ASSERT_TRUE(run(unit.clock, unit.journal.begin({})));
    ASSERT_TRUE(
        run(unit.clock, unit.journal.owe(1, unitKeyOf(*unit.device), {{"slot0.p", unit.before, unit.before / 2}})));
    ASSERT_TRUE(run(unit.clock, writeGains(*unit.device, {{unit.gain, unit.before + 1000}})));
    EXPECT_EQ(unit.askedAbout(), 1U);
}

} // namespace
} // namespace mb::tuning
