// SPDX-License-Identifier: GPL-3.0-or-later
// Two sets of gains by their steps: sums of errors that can be worked out by hand.
#include "tuning/stepcomparison.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace mb::tuning {
namespace {

using Course = std::function<double(double)>; ///< share of the step that is missing, by s since the edge

/// Steps of `held` s to `to`, 1 ms between samples, the next one a second later.
Trial comparedTrial(Mode mode, double to, double held, const std::vector<Course> &missing)
{
    Trial trial;
    trial.mode = mode;
    trial.stimulus.to = to;
    Signal signal;
    signal.channel = mode == Mode::Velocity ? "ch1.velocity" : mode == Mode::Position ? "ch1.position" : "ch1.current";
    for (std::size_t i = 0; i < missing.size(); ++i) {
        const double from = 2.0 + static_cast<double>(i) * (held + 1.0);
        trial.holds.push_back({from, from + held});
        for (int k = 0; k <= static_cast<int>(std::lround(1000.0 * (held + 0.5))); ++k)
            signal.trace.add(from + 0.001 * k, to * (1.0 - (k <= 1000.0 * held + 0.5 ? missing[i](0.001 * k) : 50.0)));
    }
    trial.signals = {signal};
    return trial;
}

Course until(double seconds)
{
    return [seconds](double t) { return t < seconds - 1e-9 ? 1.0 : 0.0; };
}

/// Of a loop of a velocity from whose reading nothing is forgiven.
LoopShape coarseIntegral()
{
    LoopShape shape;
    shape.integralStep = 0.001;
    return shape;
}

TEST(StepComparison, IsTheRatioOfTheIntegralsOfTimeTimesError)
{
    // an error of 1 until T: T²/2
    const std::vector now{comparedTrial(Mode::Velocity, 1000.0, 1.0, {until(0.2)})};
    const std::vector before{comparedTrial(Mode::Velocity, 1000.0, 1.0, {until(0.4)})};
    EXPECT_NEAR(errorRatio(now, before, coarseIntegral()), 0.25, 0.003);
    EXPECT_NEAR(errorRatio(before, now, coarseIntegral()), 4.0, 0.05);
    // of all steps of all trials, each a share of its own step
    const std::vector both{comparedTrial(Mode::Velocity, 1000.0, 1.0, {until(0.2), until(0.4)}),
        comparedTrial(Mode::Velocity, -5000.0, 1.0, {until(0.2)})};
    EXPECT_NEAR(errorRatio(both, before, coarseIntegral()), (0.04 + 0.16 + 0.04) / 3.0 / 0.16, 0.005);
}

TEST(StepComparison, LooksAsLongAsAllHoldsOfBothAre)
{
    const Course late = [](double t) { return t < 0.2 || t > 0.55 ? 0.5 : 0.0; };
    const std::vector longer{comparedTrial(Mode::Velocity, 1000.0, 1.0, {late})};
    const std::vector shorter{comparedTrial(Mode::Velocity, 1000.0, 0.5, {until(0.2)})};
    EXPECT_NEAR(errorRatio(longer, shorter, coarseIntegral()), 0.5, 0.01);
    EXPECT_NEAR(errorRatio(shorter, longer, coarseIntegral()), 2.0, 0.04);
}

TEST(StepComparison, AnErrorThatStaysCountsForAsLongAgainButThatOfACurrent)
{
    // e·T²/2 of the step, and e·T·(T + T/2) of an equal time after it
    const auto ratio = [](Mode mode, const Course &course) {
        return errorRatio({comparedTrial(mode, 100'000.0, 1.0, {course})},
            {comparedTrial(mode, 100'000.0, 1.0, {until(0.4)})}, coarseIntegral());
    };
    const Course stays = [](double t) { return t > 0.75 ? 0.1 : 0.0; };
    EXPECT_NEAR(ratio(Mode::Velocity, stays), (0.1 * (1.0 - 0.75 * 0.75) / 2.0 + 0.15) / 0.08, 0.01);
    const Course early = [](double t) { return t < 0.74 ? 0.1 : 0.0; }; // on its target in the last quarter
    EXPECT_NEAR(ratio(Mode::Velocity, early), 0.1 * 0.74 * 0.74 / 0.16, 0.005);
    const Course all = [](double) { return 0.1; };
    EXPECT_NEAR(ratio(Mode::Velocity, all), (0.05 + 0.15) / 0.08, 0.02);
    EXPECT_NEAR(ratio(Mode::Current, all), 0.05 / 0.08, 0.06);
    EXPECT_NEAR(ratio(Mode::Current, until(0.2)), 0.25, 0.03);
}

TEST(StepComparison, ForgivesAPositionFourCounts)
{
    const auto ratio = [](double counts) {
        const Course off = [counts](double t) { return t < 0.4 ? 1.0 + 4.0 / 1000.0 : counts / 1000.0; };
        return errorRatio({comparedTrial(Mode::Position, 1000.0, 1.0, {off})},
            {comparedTrial(Mode::Position, 1000.0, 1.0, {until(0.4)})}, {});
    };
    const double before = 0.996 * 0.08;
    EXPECT_NEAR(ratio(4.0), 0.08 / before, 0.002);
    EXPECT_NEAR(ratio(-3.9), 0.08 / before, 0.002);
    EXPECT_NEAR(ratio(24.0), (0.08 + 0.02 * 0.42 + 0.02 * 1.5) / before, 0.004);
    EXPECT_NEAR(ratio(-24.0), (0.08 + 0.02 * 0.42 + 0.02 * 1.5) / before, 0.004);
}

TEST(StepComparison, ForgivesAVelocityHalfAStepOfItsReadingWhereItsIntegralIsExact)
{
    // 20 counts/s are a step of both readings
    const Course beside = [](double t) { return t < 0.4 ? 1.0 : std::lround(1000.0 * t) % 2 == 0 ? -0.01 : 0.01; };
    const Course fineReading = [](double t) { return t < 0.0015 ? 0.98 : until(0.4)(t); };
    const std::vector now{comparedTrial(Mode::Velocity, 1000.0, 1.0, {beside})};
    const std::vector before{comparedTrial(Mode::Velocity, 1000.0, 1.0, {fineReading})};
    EXPECT_NEAR(errorRatio(now, before, {}), 1.0, 0.003);
    EXPECT_NEAR(errorRatio(now, before, coarseIntegral()), 1.0 + 0.01 * 0.42 / 0.08, 0.005);
    const Course further = [&beside](double t) { return t < 0.4 ? 1.0 : beside(t) + std::copysign(0.02, beside(t)); };
    EXPECT_NEAR(errorRatio({comparedTrial(Mode::Velocity, 1000.0, 1.0, {further})}, before, coarseIntegral()),
        1.0 + 0.03 * 0.42 / 0.08, 0.01);
}

TEST(StepComparison, WhatNeverSteppedIsNotBetter)
{
    const std::vector before{comparedTrial(Mode::Velocity, 1000.0, 1.0, {until(0.4)})};
    EXPECT_FALSE(isBetter({}, before, {}));
    Trial silent = before.front();
    silent.signals.clear();
    EXPECT_FALSE(isBetter({silent}, before, {}));
}

TEST(StepComparison, ForgivesNothingOfALoopThatIsNotOfACurrent)
{
    const std::vector before{comparedTrial(Mode::Velocity, 1000.0, 1.0, {until(0.4), until(0.2)})};
    const std::vector worse{comparedTrial(Mode::Velocity, 1000.0, 1.0, {until(0.41), until(0.2)})};
    EXPECT_FALSE(isBetter(worse, before, {}));
    EXPECT_TRUE(isBetter(before, worse, {}));
    EXPECT_TRUE(isBetter(worse, before, {}, 1.1));
    EXPECT_FALSE(isBetter(before, before, {}));
}

/// Currents whose steps differ: an error of 1 until `mean` ± `spread`, half of the steps each.
Trial spreadCurrent(double mean, double spread, int pairs)
{
    std::vector<Course> courses;
    for (int i = 0; i < pairs; ++i) {
        courses.push_back(until(mean - spread));
        courses.push_back(until(mean + spread));
    }
    return comparedTrial(Mode::Current, 10.0, 0.1, courses);
}

TEST(StepComparison, ForgivesACurrentTwoStandardErrorsOfItsSteps)
{
    // ITAE of a step is T²/2: with 20 ± 4 ms 128 and 288, of eight steps σ/√8 = 80·√(8/7)/√8 = 30.2; of each set, so of both 42.8, and
    // twice that is forgiven: 85.5 of some 200
    const std::vector before{spreadCurrent(0.02, 0.004, 4)};
    const auto better = [&before](double mean) { return isBetter({spreadCurrent(mean, 0.004, 4)}, before, {}); };
    EXPECT_TRUE(better(0.02));
    EXPECT_TRUE(better(0.023));
    EXPECT_FALSE(better(0.025));
    // of one step of each set nothing is known of its noise
    EXPECT_FALSE(isBetter({comparedTrial(Mode::Current, 10.0, 0.1, {until(0.021)})},
        {comparedTrial(Mode::Current, 10.0, 0.1, {until(0.02)})}, {}));
}

TEST(StepComparison, TwoStepsOfACurrentTellLittle)
{
    // 128 and 288 again: half of what lies between is 80; of 33 ms 132, both together 154, and twice that is forgiven
    const std::vector before{spreadCurrent(0.02, 0.004, 1)};
    EXPECT_TRUE(isBetter({spreadCurrent(0.028, 0.004, 1)}, before, {}));
    EXPECT_FALSE(isBetter({spreadCurrent(0.033, 0.004, 1)}, before, {}));
}

TEST(StepComparison, AStepIsWhatLiesBetweenItsEnds)
{
    // the same way, from another place
    std::vector moved{comparedTrial(Mode::Velocity, 1000.0, 1.0, {until(0.3)})};
    moved.front().stimulus.from += 500.0;
    moved.front().stimulus.to += 500.0;
    for (double &y : moved.front().signals.front().trace.y)
        y += 500.0;
    EXPECT_NEAR(
        errorRatio(moved, {comparedTrial(Mode::Velocity, 1000.0, 1.0, {until(0.3)})}, coarseIntegral()), 1.0, 1e-9);
}

TEST(StepComparison, ACurrentOfTwoTrialsIsAsSureAsTheMeanOfBoth)
{
    const std::vector before{spreadCurrent(0.02, 0.004, 4), spreadCurrent(0.02, 0.004, 4)};
    const auto better = [&before](double mean) {
        return isBetter({spreadCurrent(mean, 0.004, 4), spreadCurrent(mean, 0.004, 4)}, before, {});
    };
    // 85.5/√2 = 60 is forgiven: 22.0² / 2 = 242, 24² / 2 = 288 of 200
    EXPECT_TRUE(better(0.022));
    EXPECT_FALSE(better(0.024));
}

} // namespace
} // namespace mb::tuning
