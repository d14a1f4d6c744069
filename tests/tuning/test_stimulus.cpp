// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/stimulus.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace mb::tuning {
namespace {

constexpr double beat = 0.02;

Stimulus madeStimulus(Profile profile, std::optional<double> seconds = {}, double from = -100.0, double to = 300.0)
{
    const auto stimulus = Stimulus::make(profile, from, to, seconds, beat);
    EXPECT_TRUE(stimulus) << (stimulus ? "" : stimulus.error().text());
    return stimulus.value_or(Stimulus());
}

TEST(Stimulus, EveryProfileStartsAndEndsWhereItCameFromAndStaysBetween)
{
    for (const Profile profile :
        {Profile::Step, Profile::Square, Profile::Ramp, Profile::Sine, Profile::Chirp, Profile::Prbs}) {
        const Stimulus stimulus = madeStimulus(profile);
        EXPECT_EQ(profileFromString(toString(profile)), profile);
        EXPECT_EQ(stimulus.at(-0.001), -100.0) << toString(profile);
        EXPECT_EQ(stimulus.at(stimulus.length()), -100.0) << toString(profile);
        double most = -1e9;
        for (double t = 0.0; t < stimulus.length(); t += 0.001) {
            EXPECT_GE(stimulus.at(t), -100.0 - 1e-9) << toString(profile) << t;
            most = std::max(most, stimulus.at(t));
        }
        EXPECT_NEAR(most, 300.0, 0.01) << toString(profile);
    }
    EXPECT_FALSE(profileFromString("steps"));
}

TEST(Stimulus, HasTheTimesOfTheRulesUnlessToldOtherwise)
{
    EXPECT_DOUBLE_EQ(madeStimulus(Profile::Sine).time, 6.0);
    EXPECT_DOUBLE_EQ(madeStimulus(Profile::Sine).period, 1.0);
    EXPECT_DOUBLE_EQ(madeStimulus(Profile::Square).period, 2.0);
    EXPECT_DOUBLE_EQ(madeStimulus(Profile::Chirp).time, 30.0);
    EXPECT_DOUBLE_EQ(madeStimulus(Profile::Chirp).high, 5.0); // 0.1/Ts of 20 ms
    EXPECT_DOUBLE_EQ(Stimulus::make(Profile::Chirp, 0.0, 1.0, {}, 0.001)->high, 15.0);
    EXPECT_DOUBLE_EQ(madeStimulus(Profile::Prbs).period, 0.125);
    EXPECT_TRUE(madeStimulus(Profile::Step).ends);
    EXPECT_FALSE(madeStimulus(Profile::Step, 2.0).ends);
    EXPECT_DOUBLE_EQ(madeStimulus(Profile::Step, 2.0).length(), 2.0);
}

TEST(Stimulus, TheChirpSweepsFromItsFirstToItsLastFrequency)
{
    const Stimulus chirp = madeStimulus(Profile::Chirp, {}, -1.0, 1.0);
    const auto crossings = [&chirp](double from, double to) {
        int count = 0;
        for (double t = from; t < to; t += 1e-4)
            count += (chirp.at(t) < 0.0) != (chirp.at(t + 1e-4) < 0.0) ? 1 : 0;
        return count;
    };
    EXPECT_NEAR(crossings(29.0, 29.9), 2 * 5.0 * 0.9, 2.0);
    EXPECT_LE(crossings(0.0, 4.0), 1);
}

TEST(Stimulus, TheBitsOfThePrbsAreAMaximalSequence)
{
    int ones = 0;
    std::set<int> windows;
    for (int i = 0; i < 127; ++i) {
        ones += prbsBit(i) ? 1 : 0;
        int window = 0;
        for (int k = 0; k < 7; ++k)
            window = window * 2 + (prbsBit(i + k) ? 1 : 0);
        windows.insert(window);
        EXPECT_EQ(prbsBit(i), prbsBit(i + 127));
    }
    EXPECT_EQ(ones, 64);
    EXPECT_EQ(windows.size(), 127U);
}

TEST(Stimulus, EdgesAreWhereTheTargetJumpsToItsGoal)
{
    EXPECT_EQ(madeStimulus(Profile::Step).edges(), (std::vector<double>{0.0}));
    EXPECT_EQ(madeStimulus(Profile::Square).edges(), (std::vector<double>{0.0, 2.0}));
    EXPECT_TRUE(madeStimulus(Profile::Sine).edges().empty());
}

TEST(Stimulus, FinerThanTheDeviceTakesSetPointsIsRefusedWithTheNumbers)
{
    struct Row {
        Profile profile;
        double seconds;
        std::string_view number;
    };
    constexpr Row rows[] = {
        {Profile::Step, 0.03, "30 ms"},
        {Profile::Ramp, 0.03, "30 ms"},
        {Profile::Square, 0.1, "25 ms"},
        {Profile::Sine, 0.6, "100 ms"},
        {Profile::Prbs, 2.54, "20 ms"},
        {Profile::Chirp, 5.0, "10 s"},
    };
    for (const Row &row : rows) {
        const auto stimulus = Stimulus::make(row.profile, 0.0, 1.0, row.seconds, beat);
        ASSERT_FALSE(stimulus) << toString(row.profile);
        EXPECT_EQ(stimulus.error().fault, Fault::OutOfRange);
        EXPECT_NE(stimulus.error().text().find(row.number), std::string::npos) << stimulus.error().detail;
    }
    EXPECT_TRUE(Stimulus::make(Profile::Step, 0.0, 1.0, 0.05, beat));
}

} // namespace
} // namespace mb::tuning
