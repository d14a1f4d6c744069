// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/parameterstore.h"

#include <gtest/gtest.h>

#include <array>

namespace mb {
namespace {

Parameter storedRow(const char *key, Access access, bool persistent)
{
    Parameter p;
    p.key = key;
    p.access = access;
    p.persistent = persistent;
    return p;
}

class Store : public testing::Test {
protected:
    [[nodiscard]] ParameterState state(ParameterIndex index) const { return store.entry(index).state; }

    static constexpr ParameterIndex kept{0};
    static constexpr ParameterIndex volatileOne{1};
    static constexpr ParameterIndex blind{2};
    const std::array<Parameter, 3> table{storedRow("kept", Access::ReadWrite, true),
        storedRow("volatile", Access::ReadWrite, false), storedRow("blind", Access::WriteOnly, true)};
    ParameterStore store{table};
};

TEST_F(Store, KnowsNothingAtFirst)
{
    EXPECT_EQ(state(kept), ParameterState::Unknown);
    EXPECT_FALSE(store.entry(kept).raw);
}

TEST_F(Store, TellsWhatAReadAndAWriteProve)
{
    store.setRead(kept, 1);
    store.setRead(volatileOne, 2);
    EXPECT_EQ(state(kept), ParameterState::Stored);
    EXPECT_EQ(state(volatileOne), ParameterState::Volatile);
    store.setWritten(kept, 3);
    store.setWritten(volatileOne, 4);
    store.setWritten(blind, 5);
    EXPECT_EQ(state(kept), ParameterState::Ram);
    EXPECT_EQ(state(volatileOne), ParameterState::Volatile);
    EXPECT_EQ(state(blind), ParameterState::Assumed);
    EXPECT_EQ(store.entry(kept).raw, 3);
}

TEST_F(Store, DoesNotTakeAReadBackForAProofOfFlash)
{
    store.setWritten(kept, 3);
    store.setRead(kept, 3);
    EXPECT_EQ(state(kept), ParameterState::Ram);
    store.setRead(kept, 9);
    EXPECT_EQ(state(kept), ParameterState::Stored) << "it has another value now: what was written is gone";
}

TEST_F(Store, ShowsAFailedReadAsFailedAndKeepsTheLastValue)
{
    store.setRead(kept, 7);
    store.setFailed(kept);
    EXPECT_EQ(state(kept), ParameterState::Failed);
    EXPECT_EQ(store.entry(kept).raw, 7);
}

TEST_F(Store, MovesOnlyWhatIsInRamToStored)
{
    store.setWritten(kept, 3);
    store.setWritten(volatileOne, 4);
    store.setWritten(blind, 5);
    store.setAllStored();
    EXPECT_EQ(state(kept), ParameterState::Stored);
    EXPECT_EQ(state(volatileOne), ParameterState::Volatile);
    EXPECT_EQ(state(blind), ParameterState::Assumed) << "nobody can ask it";
}

TEST_F(Store, RemembersWhatFlashHasWhileRamIsNewer)
{
    store.setRead(kept, 1);
    store.setWritten(kept, 3);
    store.setWritten(kept, 4);
    EXPECT_EQ(inRam(store.entries()), std::vector{kept});
    EXPECT_EQ(store.entry(kept).flash, 1);
    store.setFailed(kept);
    store.setWritten(kept, 5);
    EXPECT_EQ(store.entry(kept).flash, 1) << "a read without answer changed nothing in flash";
    store.setAllStored();
    EXPECT_TRUE(inRam(store.entries()).empty());
    EXPECT_EQ(store.entry(kept).flash, std::nullopt);
    store.setWritten(kept, 6);
    EXPECT_EQ(store.entry(kept).flash, 5) << "what was proved";
}

TEST_F(Store, DoesNotKnowWhatFlashHasOfWhatWasNeverRead)
{
    store.setWritten(kept, 3);
    store.setWritten(volatileOne, 4);
    EXPECT_EQ(inRam(store.entries()), std::vector{kept});
    EXPECT_EQ(store.entry(kept).flash, std::nullopt);
    store.setRead(kept, 9);
    store.forget(kept);
    store.setWritten(kept, 3);
    EXPECT_EQ(store.entry(kept).flash, std::nullopt) << "it was forgotten meanwhile";
}

TEST_F(Store, ForgetsWhatIsVolatileWithARestart)
{
    store.setRead(kept, 1);
    store.setRead(volatileOne, 2);
    store.forgetVolatile();
    EXPECT_EQ(state(kept), ParameterState::Stored);
    EXPECT_EQ(state(volatileOne), ParameterState::Unknown);
    EXPECT_FALSE(store.entry(volatileOne).raw);
    store.forgetAll();
    EXPECT_EQ(state(kept), ParameterState::Unknown);
}

TEST_F(Store, TellsOfEveryChange)
{
    int told = 0;
    const auto listening = store.changed().add([&told] { ++told; });
    const auto revision = store.revision();
    store.setRead(kept, 1);
    store.setFailed(kept);
    store.forgetAll();
    EXPECT_EQ(told, 3);
    EXPECT_EQ(store.revision(), revision + 3);
}

} // namespace
} // namespace mb
