// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/storing.h"
#include "settingsbench.h"

namespace mb {
namespace {

using namespace std::chrono_literals;
using settings::Origin;

/// A DMC60C, which stores by itself 15 s after a write, and programs that come one after the other.
class StoredSettings : public test::SettingsBench {
protected:
    StoredSettings() { bench.clock.advance(20s); }
    /// As the next program finds it.
    ParameterState read(std::string_view key, settings::SettingsLog *log)
    {
        five.parameters().forgetAll();
        EXPECT_TRUE(run(settings::readKept(five, {bench.index(five, key)}, log, progress)));
        return five.parameters().entry(bench.index(five, key)).state;
    }

    Device &five = *bench.device(5);
};

TEST_F(StoredSettings, WhatAnEarlierProgramWroteIsInRamUntilTheUnitMustHaveStoredIt)
{
    ASSERT_TRUE(write(five, {change(five, "slot0.p", 30000)}));
    EXPECT_EQ(read("slot0.p", book.get()), ParameterState::Ram);
    EXPECT_EQ(read("slot0.i", book.get()), ParameterState::Stored) << "nobody wrote it";
    bench.clock.advance(14s);
    EXPECT_EQ(read("slot0.p", book.get()), ParameterState::Ram);
    bench.clock.advance(3s);
    EXPECT_EQ(read("slot0.p", book.get()), ParameterState::Stored);
}

TEST_F(StoredSettings, WhatWasProvedIsStoredForTheNextProgramToo)
{
    ASSERT_TRUE(write(five, {change(five, "slot0.p", 30000)}));
    EXPECT_EQ(run(settings::storeKept(five, Origin::Console, book.get(), progress)), Result<bool>(true));
    EXPECT_EQ(read("slot0.p", book.get()), ParameterState::Stored);
    ASSERT_TRUE(write(five, {change(five, "slot0.p", 31000)}));
    EXPECT_EQ(read("slot0.p", book.get()), ParameterState::Ram) << "written after the proof";
}

TEST_F(StoredSettings, AWriteThatChangedNothingOrWasReplacedByAnotherProgramWaitsForNothing)
{
    const std::int64_t present = *reads(five, "slot0.p");
    ASSERT_TRUE(write(five, {change(five, "slot0.p", present)}));
    EXPECT_EQ(read("slot0.p", book.get()), ParameterState::Stored);
    ASSERT_TRUE(write(five, {change(five, "slot0.i", 30000)}));
    ASSERT_TRUE(run(five.write(bench.index(five, "slot0.i"), 30001)));
    EXPECT_EQ(read("slot0.i", book.get()), ParameterState::Stored) << "what is there is not what was written";
}

TEST_F(StoredSettings, ASnapshotSaysWhatIsInRam)
{
    ASSERT_TRUE(write(five, {change(five, "slot0.p", 30000)}));
    five.parameters().forgetAll();
    const auto taken = snapshot(five);
    ASSERT_TRUE(taken);
    EXPECT_EQ(five.parameters().entry(bench.index(five, "slot0.p")).state, ParameterState::Ram);
    EXPECT_NE(taken->file.find("\"ram\""), std::string::npos);
}

TEST_F(StoredSettings, AUnitThatStoresAtOnceHasNothingInRam)
{
    test::SimulatedSession line("sim:serial");
    line.scan();
    Device &four = *line.device(4, "supermodified");
    const ParameterIndex gain = line.index(four, "gain.p");
    ASSERT_TRUE(
        test::run(line.clock, settings::writeKept(four, {{gain, 900}}, {Origin::Console}, book.get(), progress)));
    ASSERT_TRUE(test::run(line.clock, settings::readKept(four, {gain}, book.get(), progress)));
    EXPECT_EQ(four.parameters().entry(gain).state, ParameterState::Stored);
}

TEST_F(StoredSettings, WithoutAHistoryOnlyThisProgramsOwnWritesAreKnown)
{
    ASSERT_TRUE(write(five, {change(five, "slot0.p", 30000)}));
    EXPECT_EQ(read("slot0.p", nullptr), ParameterState::Stored);
}

} // namespace
} // namespace mb
