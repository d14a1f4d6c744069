// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/tuning/tuningbench.h"
#include "tuning/modelnumbers.h"

#include <gtest/gtest.h>

namespace mb::tuning {
namespace {

TEST(ModelNumbers, OfACurrentLoopTellNoErrorOfALagThatIsTakenAndNoFriction)
{
    test::ExperimentBench bench("sim:can", "dmc60c", 5);
    TunePlan plan = test::planOf(Mode::Current);
    plan.propose = true;
    const auto report = test::tune(bench, plan);
    ASSERT_TRUE(report) << report.error().text();
    const ModelNumbers numbers = modelNumbers(*report);
    EXPECT_GT(numbers.gain.error.value_or(0.0), 0.0);
    EXPECT_DOUBLE_EQ(numbers.tau.value.value_or(0.0), 0.0005);
    EXPECT_FALSE(numbers.tau.error);
    EXPECT_FALSE(numbers.delay.error);
    EXPECT_FALSE(numbers.friction.value);
    EXPECT_FALSE(numbers.load.value);
}

TEST(ModelNumbers, OfAWindingThatStepsToldHaveItsLagWithWhatItMayBeOff)
{
    TuneReport report;
    report.loop = Mode::Current;
    report.motor.emplace().pushes.tau = 0.0005;
    report.plant = {30.0, 0.00025, 0.001};
    report.plant.lagDoubt = 0.2;
    const ModelNumbers numbers = modelNumbers(report);
    EXPECT_DOUBLE_EQ(numbers.tau.value.value_or(0.0), 0.00025);
    EXPECT_DOUBLE_EQ(numbers.tau.error.value_or(0.0), 0.00005);
}

TEST(ModelNumbers, AreThoseOfTheModelThatTheGainsStandOn)
{
    TuneReport report;
    report.motor.emplace();
    report.motor->line.gain = 50'000.0;
    report.motor->line.gainError = 100.0;
    report.motor->pushes.tau = 0.2;
    report.motor->line.frictionError = 0.001;
    report.plant = {48'000.0, 0.23, 0.03, 0.05};
    const ModelNumbers numbers = modelNumbers(report);
    EXPECT_DOUBLE_EQ(numbers.gain.value.value_or(0.0), 48'000.0);
    EXPECT_DOUBLE_EQ(numbers.gain.error.value_or(0.0), 100.0);
    EXPECT_DOUBLE_EQ(numbers.tau.value.value_or(0.0), 0.23);
    EXPECT_FALSE(numbers.tau.error);
    EXPECT_DOUBLE_EQ(numbers.friction.value.value_or(0.0), 0.05);
}

} // namespace
} // namespace mb::tuning
