// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of an experiment before it begins, for who plans one and for who runs it.
#include "experiment/foresight.h"
#include "experiment/gains.h"
#include "model/deviceprofile.h"
#include "model/family.h"
#include "model/registry.h"

#include <gtest/gtest.h>

namespace mb::tuning {
namespace {

const Family &familyOf(std::string_view key)
{
    return *findFamily(families(), key);
}

constexpr Envelope foreseen{.travel = 1000.0, .speed = 50'000.0, .current = 10.0, .duty = 0.5};

TEST(Foresight, APlanBeginsWhereTheMotorStandsOnlyInPositionMode)
{
    const Family &family = familyOf("dmc60c");
    ExperimentPlan plan;
    plan.mode = Mode::Position;
    plan.to = 300.0;
    const auto place = stimulusWithin(family, foreseen, plan, {100.0, 100.0, 0.0});
    ASSERT_TRUE(place) << place.error().text();
    EXPECT_EQ(place->from, 100.0);
    plan.mode = Mode::Current;
    plan.to = 3.0;
    EXPECT_EQ(stimulusWithin(family, foreseen, plan, {100.0, 100.0, 0.0})->from, 0.0);
}

TEST(Foresight, APlanThatGoesNowhereOrTooFarIsRefused)
{
    const Family &family = familyOf("dmc60c");
    ExperimentPlan plan;
    plan.mode = Mode::Position;
    plan.to = 100.0;
    EXPECT_EQ(stimulusWithin(family, foreseen, plan, {100.0, 100.0, 0.0}).error().detail,
        "there is no way from 100 to itself");
    plan.to = 1200.0;
    EXPECT_EQ(stimulusWithin(family, foreseen, plan, {100.0, 100.0, 0.0}).error().fault, Fault::OutOfRange);
    EXPECT_TRUE(stimulusWithin(family, foreseen, plan, {300.0, 300.0, 0.0}));
    plan.seconds = -1.0;
    EXPECT_FALSE(stimulusWithin(family, foreseen, plan, {300.0, 300.0, 0.0}));
}

TEST(Foresight, AFirstStepIsWellInsideWhatIsKnown)
{
    const Family &family = familyOf("dmc60c");
    const auto target = [&](Mode mode, const Envelope &limits, double here = 0.0) {
        return usualTarget(family, mode, limits, here, 4096.0);
    };
    Envelope one;
    one.speed = 50'000.0;
    one.duty = 0.1;
    EXPECT_EQ(target(Mode::Velocity, foreseen), 50.0) << "its travel is narrower than its speed";
    EXPECT_EQ(target(Mode::Velocity, one), 20'000.0);
    EXPECT_EQ(target(Mode::Velocity, {}), std::nullopt);
    EXPECT_EQ(target(Mode::Current, foreseen), 4.0);
    EXPECT_EQ(target(Mode::Current, family.trials->bench), 6.0) << "of what no simulated motor reaches";
    EXPECT_EQ(target(Mode::Current, {}), std::nullopt);
    EXPECT_EQ(target(Mode::Position, foreseen, 100.4), 500.0) << "two fifths of the travel from here";
    EXPECT_EQ(target(Mode::Position, {}), 1600.0) << "of a turn";
    EXPECT_EQ(target(Mode::Duty, foreseen), 0.2);
    EXPECT_EQ(target(Mode::Duty, one), 0.1);
    EXPECT_EQ(target(Mode::Voltage, foreseen), std::nullopt);
}

TEST(Foresight, GainsThatNobodyCouldPutBackStay)
{
    const Family &blind = familyOf("abstractdc");
    const auto gain = findParameter(blind.parameters, "velocity.p");
    ASSERT_TRUE(gain);
    ParameterStore store(blind.parameters);
    DeviceProfile profile;
    const std::vector<ParameterChange> gains{{*gain, 5}};
    EXPECT_EQ(usualKeep(blind, store.entries(), profile, gains), Keep::Always) << "never written here";
    store.setWritten(*gain, 4);
    EXPECT_EQ(usualKeep(blind, store.entries(), profile, gains), Keep::WhenDone);
    profile.lost.insert("velocity.p");
    EXPECT_EQ(usualKeep(blind, store.entries(), profile, gains), Keep::Always) << "a reset has taken it";
    EXPECT_EQ(usualKeep(blind, store.entries(), profile, {}), Keep::WhenDone);
    const Family &read = familyOf("dmc60c");
    EXPECT_EQ(usualKeep(read, {}, {}, {{*findParameter(read.parameters, "slot0.p"), 5}}), Keep::WhenDone);
}

TEST(Foresight, WhatIsNoPartOfAnExperimentIsLeftOut)
{
    const Family &family = familyOf("abstractdc");
    const auto index = [&](std::string_view key) { return *findParameter(family.parameters, key); };
    const auto some = triable(family, {{index("velocity.p"), 1}, {index("current.averaging"), 2}});
    ASSERT_EQ(some.size(), 1U);
    EXPECT_EQ(some.front().index, index("velocity.p"));
}

} // namespace
} // namespace mb::tuning
