// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/tuning/matrix/groundtruth.h"
#include "tests/tuning/matrix/matrixrow.h"
#include "tuning/gainscale.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace mb::test {
namespace {

const Cell &coarseCell()
{
    static const Cell cell = cellOf("quadquad2drv", "25d", Mode::Velocity, 1, 0.0);
    return cell;
}

/// Gains of a rule on the true motor.
std::vector<ParameterChange> usualGains(const StepProbe &probe, Device &device)
{
    const tuning::PlantModel truth = groundTruth(coarseCell(), probe.step());
    const auto scaled
        = tuning::scaleGains(device, Mode::Velocity, 1, 0, tuning::velocityRule(truth, 2.0 * truth.delay));
    return scaled ? scaled->changes : std::vector<ParameterChange>();
}

TEST(StepProbe, ItsPhasesFillACountAndABeatEvenly)
{
    const auto phases = stepPhases(8);
    ASSERT_EQ(phases.size(), 8U);
    for (const double StepPhase::*const share : {&StepPhase::count, &StepPhase::time}) {
        std::vector<double> all;
        for (const StepPhase &phase : phases)
            all.push_back(phase.*share);
        std::sort(all.begin(), all.end());
        EXPECT_GE(all.front(), 0.0);
        EXPECT_LT(all.back(), 1.0);
        for (std::size_t i = 1; i < all.size(); ++i)
            EXPECT_LT(all[i] - all[i - 1], 0.3);
    }
    EXPECT_EQ(stepPhases(1, 8).front().count, stepPhases(9).back().count);
}

TEST(StepProbe, WhereInACountItBeginsTellsInItsError)
{
    StepProbe probe(coarseCell(), {1000.0, 0.8});
    const auto changes = usualGains(probe, probe.device());
    ASSERT_FALSE(changes.empty());
    const auto from = [&](StepPhase phase) { return probe.run(changes, phase).value_or(ShaftResponse()).itae; };
    ASSERT_GT(from({0.1, 0.1}), 0.0); // the first of a unit that has never turned
    const double once = from({0.1, 0.1});
    EXPECT_NEAR(from({0.1, 0.1}) / once, 1.0, 0.002);
    EXPECT_GT(std::abs(from({0.6, 0.6}) / once - 1.0), 0.002);
    const auto all = probe.runAll(changes, stepPhases(8));
    ASSERT_TRUE(all);
    EXPECT_GT(all->spread, 0.002);
}

TEST(StepProbe, GainsAreGivenUpThatAreWorseThanAsked)
{
    StepProbe probe(coarseCell(), {1000.0, 0.8});
    const auto changes = usualGains(probe, probe.device());
    const auto all = probe.runAll(changes, stepPhases(3));
    ASSERT_TRUE(all);
    EXPECT_FALSE(probe.runAll(changes, stepPhases(3), {0.5 * all->itae}));
    EXPECT_TRUE(probe.runAll(changes, stepPhases(3), {1.5 * all->itae, 0.5}));
}

} // namespace
} // namespace mb::test
