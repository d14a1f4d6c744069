// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/battery.h"
#include "tests/tuning/experimentbench.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace mb::tuning {
namespace {

TEST(Batteries, HaveFiveSizesInBothDirectionsUpToTheLargest)
{
    const Battery speed = batteryOf(test::stepTo(Mode::Velocity, 50'000.0), 0.0, false);
    ASSERT_EQ(speed.steps.size(), 10U);
    EXPECT_DOUBLE_EQ(speed.steps.front().to, 10'000.0);
    EXPECT_DOUBLE_EQ(speed.steps[1].to, -10'000.0);
    EXPECT_DOUBLE_EQ(speed.steps.back().to, -50'000.0);
    const Battery place = batteryOf(test::stepTo(Mode::Position, 4'000.0), 1'000.0, false);
    EXPECT_DOUBLE_EQ(place.steps.front().to, 1'600.0);
    EXPECT_DOUBLE_EQ(place.steps.back().to, -2'000.0);
    EXPECT_FALSE(place.steps.front().from);
    EXPECT_DOUBLE_EQ(batteryOf(test::stepTo(Mode::Position, 500.0), 77.0, true).steps[1].to, -100.0);
}

TEST(Batteries, AreStepsHeldAsLongAsIsUsualOnceEach)
{
    ExperimentPlan largest = test::stepTo(Mode::Velocity, 50'000.0);
    largest.profile = Profile::Sine;
    largest.repeat = 3;
    largest.seconds = 7.0;
    largest.from = 10'000.0;
    const Battery battery = batteryOf(largest, 123.0, false);
    for (const ExperimentPlan &step : battery.steps) {
        EXPECT_EQ(step.profile, Profile::Step);
        EXPECT_EQ(step.repeat, 1);
        EXPECT_FALSE(step.seconds);
        EXPECT_EQ(step.from, 10'000.0);
        EXPECT_EQ(step.mode, Mode::Velocity);
    }
    EXPECT_DOUBLE_EQ(battery.steps.front().to, 18'000.0);
    EXPECT_DOUBLE_EQ(battery.steps[1].to, 2'000.0);
}

TEST(Batteries, NameTheWorstOfEachMetricAndWhereItWas)
{
    std::vector<Trial> trials(3);
    trials[0].metrics.overshoot = 0.01;
    trials[1].metrics.overshoot = 0.2;
    trials[1].metrics.sse = 0.001;
    trials[2].metrics.sse = -0.02;
    const BatteryWorst worst = worstOf(trials);
    EXPECT_DOUBLE_EQ(worst.metrics.overshoot.value_or(0.0), 0.2);
    EXPECT_DOUBLE_EQ(worst.metrics.sse.value_or(0.0), -0.02);
    EXPECT_FALSE(worst.metrics.rise);
    for (std::size_t key = 0; key < metricKeys().size(); ++key) {
        if (metricKeys()[key].key == "overshoot") {
            EXPECT_EQ(worst.where[key], 1U);
        }
        if (metricKeys()[key].key == "sse") {
            EXPECT_EQ(worst.where[key], 2U);
        }
        if (metricKeys()[key].key == "rise") {
            EXPECT_FALSE(worst.where[key]);
        }
    }
}

TEST(Batteries, CallAStepThatDidNotSettleTheWorstToSettle)
{
    const auto settle = static_cast<std::size_t>(findMetric("settle") - metricKeys().data());
    std::vector<Trial> trials(3);
    for (Trial &trial : trials)
        trial.metrics.overshoot = 0.1;
    trials[0].metrics.settle = 0.3;
    trials[1].metrics.noise = 0.001;
    trials[2].metrics.settle = 0.5;
    EXPECT_FALSE(worstOf(trials).metrics.settle);
    EXPECT_EQ(worstOf(trials).where[settle], 1U);
    trials[1].metrics.noise = 2.0 * unreadableNoise;
    EXPECT_EQ(worstOf(trials).where[settle], 2U) << "nobody could read it";
    trials[1].metrics = {};
    EXPECT_EQ(worstOf(trials).metrics.settle, 0.5) << "it was stopped before it answered";
}

TEST(Batteries, CallAStepThatWasHeldTooBrieflyTheWorstToSettle)
{
    test::ExperimentBench bench;
    std::vector<Trial> trials;
    for (const double seconds : {2.0, 0.3, 2.0}) {
        ExperimentPlan step = test::stepTo(Mode::Velocity, 8'000.0);
        step.seconds = seconds;
        const auto trial = bench.run(step);
        ASSERT_TRUE(trial) << trial.error().text();
        EXPECT_EQ(trial->reason, tuning::EndReason::Done);
        EXPECT_EQ(trial->metrics.settle.has_value(), seconds > 1.0);
        trials.push_back(*trial);
    }
    const auto settle = static_cast<std::size_t>(findMetric("settle") - metricKeys().data());
    EXPECT_FALSE(worstOf(trials).metrics.settle);
    EXPECT_EQ(worstOf(trials).where[settle], 1U);
}

TEST(Batteries, OfUnitSevenAreTenTrialsThatOvershoot)
{
    test::ExperimentBench bench("sim:can", "dmc60c", 7);
    std::vector<Trial> trials;
    for (const ExperimentPlan &step : batteryOf(test::stepTo(Mode::Velocity, 60'000.0), 0.0, false).steps) {
        const auto trial = bench.run(step);
        ASSERT_TRUE(trial) << trial.error().text();
        EXPECT_EQ(trial->reason, tuning::EndReason::Done);
        trials.push_back(*trial);
    }
    const BatteryWorst worst = worstOf(trials);
    std::printf("worst overshoot of ten steps: %.1f %%\n", 100.0 * worst.metrics.overshoot.value_or(0.0));
    EXPECT_GT(worst.metrics.overshoot.value_or(0.0), 0.1);
}

} // namespace
} // namespace mb::tuning
